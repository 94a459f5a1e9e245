#include "ui/messages/diagnostics_model.h"

#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QLocale>

#include "tests/ui/program_fixture.h"
#include "ui/language/language.h"
#include "ui/program_text/diagnostic_marks.h"

namespace feedscope::ui {
namespace {

Diagnostic diagnostic(Severity severity, std::uint32_t line, std::uint32_t column,
                      const std::string& file = "") {
  return {severity, line, column, "code", Message::as_written("message"), Message::as_written("hint"), file};
}

/// Diagnostics out of order, of the file as a whole and of another file among them.
std::shared_ptr<const Program> faulty_program() {
  auto program = std::make_shared<Program>();
  program->source = std::make_shared<const SourceText>("test.nc", "G1\nG1\nG1\nG1\n");
  program->diagnostics = {diagnostic(Severity::error, 3, 2), diagnostic(Severity::warning, 1, 1),
                          diagnostic(Severity::info, 0, 0), diagnostic(Severity::error, 2, 1, "p/sub.spf"),
                          diagnostic(Severity::warning, 3, 1)};
  return program;
}

QString text(const QAbstractItemModel& model, int row, int column = DiagnosticsModel::place) {
  return model.index(row, column).data().toString();
}

TEST(DiagnosticsModel, ListsByLineThenOtherFilesThenMessages) {
  DiagnosticsModel model;
  const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
  model.set_program(faulty_program());
  model.add_message(Severity::error, "no room");
  ASSERT_EQ(model.rowCount(), 6);
  const QStringList places{"", "1:1", "3:1", "3:2", "sub.spf:2:1", ""};
  for (int row = 0; row < places.size(); ++row) {
    EXPECT_EQ(text(model, row), places[row]) << row;
  }
  EXPECT_EQ(text(model, 5, DiagnosticsModel::message), "no room");
  EXPECT_EQ(text(model, 1, DiagnosticsModel::hint), "hint");
  EXPECT_EQ(model.index(3, 0).data(DiagnosticsModel::line_role).toUInt(), 3U);
  EXPECT_EQ(model.index(4, 0).data(DiagnosticsModel::line_role).toUInt(), 0U) << "it is another file's line";
  model.set_program(nullptr);
  EXPECT_EQ(model.rowCount(), 0);
}

TEST(DiagnosticsModel, AMessageOfManyPlacesIsOneRowWithTheirCount) {
  auto program = std::make_shared<Program>();
  Diagnostic closing{
      Severity::info, 4, 0, "turn", Message::as_written("2 more of this kind up to line 9"), {}, "", 2, 9};
  Diagnostic other = closing;  // of a kind of which several are kept
  other.code = "code";
  other.severity = Severity::warning;
  program->diagnostics = {
      {Severity::info, 2, 1, "turn", Message::as_written("axes turn"), Message::as_written("hint")},
      diagnostic(Severity::warning, 2, 3),
      diagnostic(Severity::warning, 3, 1),
      other,
      closing};
  DiagnosticsModel model;
  model.set_program(program);
  ASSERT_EQ(model.rowCount(), 4);
  EXPECT_EQ(text(model, 0, DiagnosticsModel::message), "axes turn (2 more up to line 9)");
  EXPECT_EQ(text(model, 1, DiagnosticsModel::message), "message");
  EXPECT_EQ(text(model, 3, DiagnosticsModel::message), "2 more of this kind up to line 9");
}

TEST(DiagnosticsModel, SpeaksTheLanguageOfTheWindow) {
  auto program = std::make_shared<Program>();
  program->diagnostics = {{Severity::warning, 2, 3, "feed-missing", NC_("core", "a feed move without a feed"),
                           NC_("core", "it runs as fast as the axes allow; write F before it")},
                          {Severity::warning,
                           3,
                           0,
                           "feed-missing",
                           message(NC_("core", "{} more of this kind up to line {}"), 8, 9),
                           {},
                           "",
                           8,
                           9}};
  DiagnosticsModel model;
  model.set_program(program);
  const DiagnosticMarks marks(*program);
  ui::speak(QStringLiteral("fr"));
  const QString said = text(model, 0, DiagnosticsModel::message);
  const QString hint = text(model, 0, DiagnosticsModel::hint);
  const QString hover = model.index(0, DiagnosticsModel::message).data(Qt::ToolTipRole).toString();
  const QString rest = text(model, 1, DiagnosticsModel::message);
  const QString tip = marks.tip(2);
  ui::speak(QStringLiteral("en"));
  QLocale::setDefault(QLocale::c());
  EXPECT_TRUE(said.startsWith("un déplacement en avance sans avance")) << said.toStdString();
  EXPECT_TRUE(hint.endsWith("programmez F avant")) << hint.toStdString();
  EXPECT_EQ(hover, said);
  EXPECT_EQ(tip.section('\n', 1), hint);
  EXPECT_FALSE(rest.contains("more of this kind")) << rest.toStdString();
  EXPECT_TRUE(text(model, 0, DiagnosticsModel::message).startsWith("a feed move without a feed"));
}

TEST(DiagnosticsFilter, LeavesOutWhatIsLessSevere) {
  DiagnosticsModel model;
  DiagnosticsFilter filter;
  filter.setSourceModel(&model);
  const QAbstractItemModelTester tester(&filter, QAbstractItemModelTester::FailureReportingMode::Fatal);
  model.set_program(faulty_program());
  EXPECT_EQ(filter.rowCount(), 5);
  filter.set_least(Severity::warning);
  EXPECT_EQ(filter.rowCount(), 4);
  filter.set_least(Severity::error);
  ASSERT_EQ(filter.rowCount(), 2);
  EXPECT_EQ(text(filter, 0), "3:2");
  model.add_message(Severity::warning, "not shown");
  EXPECT_EQ(filter.rowCount(), 2);
}

TEST(DiagnosticsFilter, StepsFromAPlaceAndAroundTheEnds) {
  DiagnosticsModel model;
  DiagnosticsFilter filter;
  filter.setSourceModel(&model);
  EXPECT_EQ(filter.next_row(-1, {1, 0}, true), -1);
  model.set_program(faulty_program());
  EXPECT_EQ(text(filter, filter.next_row(-1, {2, 0}, true)), "3:1");
  EXPECT_EQ(text(filter, filter.next_row(-1, {2, 0}, false)), "1:1");
  EXPECT_EQ(text(filter, filter.next_row(-1, {4, 0}, true)), "1:1");
  EXPECT_EQ(text(filter, filter.next_row(-1, {1, 0}, false)), "3:2");
  EXPECT_EQ(text(filter, filter.next_row(2, {3, 0}, true)), "3:2") << "the next one on the same line";
  EXPECT_EQ(text(filter, filter.next_row(3, {3, 0}, true)), "1:1");
  EXPECT_EQ(text(filter, filter.next_row(3, {3, 0}, false)), "3:1");
}

TEST(DiagnosticMarks, AreThoseOfTheProgramItself) {
  const auto program = faulty_program();
  const DiagnosticMarks marks(*program);
  EXPECT_EQ(marks.all().size(), 3U);
  EXPECT_TRUE(marks.of(2).empty());
  ASSERT_EQ(marks.of(3).size(), 2U);
  EXPECT_EQ(marks.of(3)[0]->column, 1U);
  EXPECT_EQ(worst_of(marks.of(3)), Severity::error);
  EXPECT_EQ(worst_of(marks.of(1)), Severity::warning);
  EXPECT_EQ(marks.of(1, 3).size(), 3U);
}

TEST(DiagnosticMarks, MarkTheWordAtTheColumn) {
  const std::string line = "  G1 X1..2Y5 Zabc";
  Syntax syntax(Dialect::iso);
  const auto& tokens = syntax.tokens_of(line);
  const auto marked = [&](std::uint32_t column) {
    const ByteRange range = marked_bytes(line, column, tokens);
    return line.substr(range.from, range.to - range.from);
  };
  EXPECT_EQ(marked(6), "X1..2");
  EXPECT_EQ(marked(11), "Y5");
  EXPECT_EQ(marked(14), "Zabc");
  EXPECT_EQ(marked(3), "G1");
  EXPECT_EQ(marked(0), "G1 X1..2Y5 Zabc");
  EXPECT_EQ(marked(18), "");
  EXPECT_EQ(marked(99), "");
}

}  // namespace
}  // namespace feedscope::ui
