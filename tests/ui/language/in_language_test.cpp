#include "ui/language/in_language.h"

#include <gtest/gtest.h>

#include <QLocale>
#include <QRegularExpression>
#include <vector>

#include "core/analysis/agreement/trace_on_program.h"
#include "core/analysis/notes/not_counted.h"
#include "core/analysis/notes/refused_lines.h"
#include "core/analysis/notes/remarks.h"
#include "core/analysis/run/control_dialect.h"
#include "core/analysis/run/run.h"
#include "core/program/path_control.h"
#include "core/program/program_unit.h"
#include "core/trace/read_trace.h"
#include "ui/language/language.h"

namespace feedscope::ui {
namespace {

class InLanguage : public testing::Test {
 protected:
  InLanguage() { speak(QStringLiteral("fr")); }
  ~InLanguage() override {
    speak(QStringLiteral("en"));
    QLocale::setDefault(QLocale::c());
  }

  static void expect_french(const Message& message) {
    const std::string text = message.english();
    static const QRegularExpression english(
        QStringLiteral("\\b(the|of|and|is|are|by|at|within|on|off|limit|times|not|axis|line|lines)\\b"),
        QRegularExpression::UseUnicodePropertiesOption);
    const QString made = in_language(message);
    QString rest = made;
    for (const char* name : {"jerk=on", "law", "--unit"}) {  // what settings and options are called
      rest.remove(QLatin1String(name));
    }
    EXPECT_NE(made.toStdString(), text);
    EXPECT_FALSE(english.match(rest).hasMatch()) << text << "\n  " << made.toStdString();
    EXPECT_FALSE(made.contains('%') && !text.empty() && text.find('%') == std::string::npos)
        << made.toStdString();
  }
};

/// Off the path, lost, a part, mirrored, in inches, with an axis missing; then of another program.
TEST_F(InLanguage, SaysInFrenchWhatIsWrongWithATrace) {
  Toolpath toolpath;
  toolpath.segments.resize(2);
  toolpath.segments[0] = {.end = Vec3(10, 0, 5), .length = 10, .line = 2};
  toolpath.segments[1] = {.end = Vec3(10, 10, 5), .length = 10, .line = 3};
  const ProgrammedCourse course(toolpath, {true, true, false});
  Trace trace;
  trace.place[0] = {0, 0};
  trace.place[1] = {0, 0};
  TraceOnProgram found;
  found.fit = {0.9, 0.9, 10};
  found.pose.scale = 25.4;
  found.pose.mirror = Vec3(-1, 1, 1);
  found.matched.s = {1, 12};
  found.matched.distance = {0, 0};
  found.matched.end = 2;
  found.law = TimeLaw({0, 1}, found.matched);
  found.lost = {{0.1, 0.5, 2, 12, true}, {0.5, 0.55, 12, 12, true}, {0.6, 0.7, 12, 12, false}};
  found.pass_times = {1, 1};
  std::vector<Diagnostic> messages = remarks_on(found, trace, course);
  EXPECT_EQ(messages.size(), 7U);
  found.fit = {0.1, 0.1, 10};
  found.pose.scale = 1 / 25.4;
  for (const Diagnostic& message : remarks_on(found, trace, course)) {
    messages.push_back(message);
  }
  EXPECT_EQ(messages.size(), 7U + 6U);
  const Trace read = parse_trace(
      "1 0 0\n2 0 0\n3 1 0\n4 2 0\n2 2 0\n3 2 0\n7 2 0\n8 2 0\n9 2 0\n10 3 0\n11 4 0\n12 4 "
      "0\n13 4 0\n14 4 0\n15 5 0\n25 5 0\n26 5 0\n",
      "t.txt", parse_trace_columns("time=1:s,x=2,y=3"));
  EXPECT_GE(read.notes.size(), 4U);
  messages.insert(messages.end(), read.notes.begin(), read.notes.end());
  std::string reached = "time_s,actual_x_mm,actual_y_mm\n";
  for (const char* const row : {"0,0,0\n", "1,1,0\n", "2,2,0\n", "3,3,0\n", "4,4,0\n", "5,5,0\n", "6,6,0\n",
                                "7,7,0\n", "8,8,0\n", "9,9,0\n"}) {
    reached += row;
  }
  const Trace actual = parse_trace(reached, "t.csv");
  EXPECT_EQ(actual.notes.front().code, "trace-actual");
  messages.insert(messages.end(), actual.notes.begin(), actual.notes.end());
  for (const bool on_machine : {false, true}) {
    TraceColumns columns = parse_trace_columns("linuxcnc");
    columns.machine_period = on_machine ? 1e-3 : 0;
    std::string rows;
    for (int i = 0; i < 500; ++i) {
      rows += std::to_string(i) + ' ' + std::to_string(0.1 * i) + " 0 0 7 50\n";  // at 100 mm/s
    }
    const Trace sampled = parse_trace(rows, "t.txt", columns);
    EXPECT_EQ(sampled.notes.size(), 2U);
    messages.insert(messages.end(), sampled.notes.begin(), sampled.notes.end());
  }
  for (const Diagnostic& message : messages) {
    expect_french(message.message);
    if (!message.hint.empty()) {
      expect_french(message.hint);
    }
  }
}

TEST_F(InLanguage, SaysInFrenchWhatModelsGuarantee) {
  for (const ControlModel* model : all_models()) {
    std::vector<std::vector<std::string>> settings{{}};
    if (model->info().id == "ward") {
      settings.push_back({"enforce=off"});
    } else if (model->info().id == "optimal") {
      settings.push_back({"jerk=on"});
      settings.push_back({"path=tapie"});
    } else if (model->info().id == "essid") {
      settings.push_back({"reading=strict"});
      settings.push_back({"compressor=on"});
    } else if (model->info().id == "msaddek") {
      settings.push_back({"law=static"});
    } else if (model->info().id == "linuxcnc") {
      settings.push_back({"blend_mode=G61"});
    }
    for (const std::vector<std::string>& set : settings) {
      const feedscope::Setup setup = make_setup({"", model->info().id, std::nullopt, set});
      for (const Message& sentence : sentences(model->guarantees(setup.settings))) {
        expect_french(sentence);
      }
    }
    for (const Message& remark : model->info().remarks) {
      expect_french(remark);
    }
  }
}

TEST_F(InLanguage, SaysInFrenchThatAFeedIsBeyondTheMachine) {
  const LoadedProgram program =
      load_program(std::make_shared<const SourceText>("line.nc", "G21 G90\nG1 X10 F9991300\n"));
  const std::vector<Message> said =
      texts_about(remarks(simulate_run(program, make_setup({}))), {Remark::About::programmed});
  ASSERT_EQ(said.size(), 1U);
  expect_french(said[0]);
}

TEST_F(InLanguage, SaysInFrenchWhatIsNotInTheCycleTime) {
  NotCounted counts;
  counts.tool_changes = 2;
  counts.spindle_starts = 1;
  counts.stops = 3;
  counts.machine_moves = 1;
  counts.other_axes = {"B", "C"};
  EXPECT_EQ(
      in_language(describe(counts)).toStdString(),
      "2 changements d’outil, 1 démarrage de la broche, 3 arrêts programme (M0, M1), 1 déplacement vers "
      "ou depuis une position machine, mouvement de B, C");
}

TEST_F(InLanguage, SaysInFrenchHowAProgramControlsThePath) {
  PathControl control;
  expect_french(describe(control));
  control.contour_tolerance = 0.05;
  control.blend_distance = 0.5;
  control.orientation_tolerance = 0.01;
  control.compaction_tolerance = 0.02;
  for (const Switch to : {Switch::on, Switch::off}) {
    control.compaction = to;
    control.compressor = to == Switch::on ? Switch::off : Switch::on;
    control.feed_forward = to;
    control.look_ahead = to;
    for (const PathMode mode : {PathMode::continuous, PathMode::exact_stop}) {
      control.mode = mode;
      for (const AccelerationMode acceleration :
           {AccelerationMode::soft, AccelerationMode::brisk, AccelerationMode::drive}) {
        control.acceleration = acceleration;
        expect_french(describe(control));
      }
    }
  }
  EXPECT_TRUE(in_language(describe(control)).contains(QStringLiteral("tolérance de contour 0,05 mm")));
  for (const auto source :
       {ProgramUnit::Source::program, ProgramUnit::Source::asked, ProgramUnit::Source::assumed}) {
    ProgramUnit unit;
    unit.source = source;
    expect_french(describe(unit));
  }
}

TEST_F(InLanguage, SaysInFrenchThatAControlDoesNotReadTheProgram) {
  const feedscope::Setup setup = make_setup({"spinner-mvc850", "essid", std::nullopt, {}});
  for (const Dialect dialect : {Dialect::heidenhain, Dialect::fanuc}) {
    const auto mismatch = control_mismatch(setup.machine, dialect);
    ASSERT_TRUE(mismatch.has_value());
    const QString text = in_language(describe(*mismatch));
    EXPECT_TRUE(text.startsWith(QStringLiteral("Le programme est écrit pour "))) << text.toStdString();
    EXPECT_TRUE(text.contains(QStringLiteral("Spinner MVC 850"))) << text.toStdString();
    EXPECT_FALSE(text.contains(QStringLiteral("control "))) << text.toStdString();
  }
}

TEST_F(InLanguage, LeavesTextsOfOthersAsTheyAre) {
  for (const char* text : {"", "Arc center and radius do not fit", "error", "2.5"}) {
    EXPECT_EQ(in_language(Message::as_written(text)).toStdString(), text);
  }
  EXPECT_EQ(in_language(Message::number("2.5")).toStdString(), "2,5");
}

TEST_F(InLanguage, TranslatesMessagesWithinMessages) {
  std::vector<Diagnostic> refused;
  for (const std::uint32_t line : {1U, 5U, 6U, 7U, 20U}) {
    refused.emplace_back().line = line;
  }
  EXPECT_EQ(
      in_language(refused_note(refused)).toStdString(),
      "5 lignes du programme sont refusées par la commande et ne sont pas exécutées (lignes 1, 5 à 7, 20).");
}

TEST_F(InLanguage, EnglishStaysAsItIs) {
  speak(QStringLiteral("en"));
  for (const ControlModel* model : all_models()) {
    const feedscope::Setup setup = make_setup({"", model->info().id, std::nullopt, {}});
    for (const Message& sentence : sentences(model->guarantees(setup.settings))) {
      EXPECT_EQ(in_language(sentence).toStdString(), sentence.english());
    }
  }
}

}  // namespace
}  // namespace feedscope::ui
