#include "ui/window/dialogs/report_dialog.h"

#include <gmock/gmock.h>

#include <QDir>
#include <QFile>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QProcess>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "tests/ui/identification_fixture.h"
#include "tests/ui/patience.h"
#include "tests/ui/run_fixture.h"
#include "ui/language/language.h"
#include "ui/session/session_file.h"
#include "ui/window/dialogs/language_box.h"
#include "ui/window/dialogs/page_preview.h"

namespace feedscope::ui {
namespace {

using testing::HasSubstr;
using testing::Not;

class ReportDialogTest : public testing::Test {
 protected:
  ReportDialogTest() {
    QSettings().remove("report");
    QFile program(folder_.filePath("part.nc"));
    EXPECT_TRUE(program.open(QIODevice::WriteOnly));
    program.write(test::small_program.c_str());
    subject_.session.program = program.fileName().toStdString();
    for (const double tolerance : {0.01, 0.05}) {
      const std::size_t number = subject_.session.runs.size();
      subject_.session.runs.push_back({static_cast<int>(number) + 1,
                                       {},
                                       run_colour(number),
                                       true,
                                       SetupState(make_setup({"", "essid", tolerance, {}}))});
    }
    subject_.session.current_run = 1;
    subject_.session.scenes.other = 0;
    subject_.run_names = {"fine", "coarse"};
  }
  ~ReportDialogTest() override { QSettings().remove("report"); }

  static bool rests(ReportDialog& dialog) {
    return QTest::qWaitFor([&] { return !dialog.busy(); }, patience);
  }
  std::string contents(const QString& name) const {
    QFile file(folder_.filePath(name));
    EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << name.toStdString();
    return file.readAll().toStdString();
  }

  QTemporaryDir folder_;
  ReportDialog::Subject subject_;
};

TEST_F(ReportDialogTest, ShowsThePagesAsTheyAreAskedFor) {
  ReportDialog dialog(subject_, FEEDSCOPE_EXECUTABLE);
  dialog.show();
  ASSERT_TRUE(rests(dialog));
  const qsizetype all = dialog.preview().count();
  EXPECT_GE(all, 2);
  for (int i = 0; i < dialog.parts().count(); ++i) {
    dialog.parts().item(i)->setCheckState(Qt::Unchecked);
  }
  EXPECT_TRUE(dialog.busy());
  ASSERT_TRUE(rests(dialog));
  EXPECT_EQ(dialog.preview().count(), 1);
}

TEST_F(ReportDialogTest, WritesTheChosenRunsWithOwnWords) {
  ReportDialog dialog(subject_, FEEDSCOPE_EXECUTABLE);
  dialog.runs().item(1)->setCheckState(Qt::Unchecked);
  dialog.findChild<QPlainTextEdit*>()->setPlainText("My own words.");
  QSignalSpy saved(&dialog, &ReportDialog::saved);
  dialog.save(folder_.filePath("r.html"));
  ASSERT_TRUE(rests(dialog));
  ASSERT_EQ(saved.size(), 1);
  const std::string html = contents("r.html");
  EXPECT_THAT(html, HasSubstr("My own words."));
  EXPECT_THAT(html, HasSubstr("essid, 0.01 mm"));
  EXPECT_THAT(html, Not(HasSubstr("0.05 mm")));
  EXPECT_THAT(html, Not(HasSubstr("How to make this again"))) << "its session is not kept";
}

TEST_F(ReportDialogTest, WithItsSessionTheReportSaysHowToMakeItAgain) {
  ReportDialog dialog(subject_, FEEDSCOPE_EXECUTABLE);
  dialog.keep_session(true);
  dialog.save(folder_.filePath("r.html"));
  ASSERT_TRUE(rests(dialog));
  const std::string first = contents("r.html");
  EXPECT_THAT(first, HasSubstr("feedscope report r.feedscope --out r.html"));
  QProcess again;
  again.setWorkingDirectory(folder_.path());
  again.start(FEEDSCOPE_EXECUTABLE, {"report", "r.feedscope", "--out", "r.html"});
  ASSERT_TRUE(again.waitForFinished(patience));
  EXPECT_TRUE(contents("r.html") == first) << "the same call gives the same bytes";
}

TEST_F(ReportDialogTest, WritesInTheLanguageThatIsChosen) {
  ReportDialog dialog(subject_, FEEDSCOPE_EXECUTABLE);
  auto* const language = dialog.findChild<LanguageBox*>();
  EXPECT_EQ(language->language(), chosen_language()) << "as the window";
  EXPECT_EQ(language->itemText(language->findData("en")), "English");
  language->choose("fr");
  EXPECT_TRUE(dialog.busy()) << "the preview follows";
  dialog.save(folder_.filePath("r.html"));
  ASSERT_TRUE(rests(dialog));
  const std::string html = contents("r.html");
  EXPECT_THAT(html, HasSubstr("<html lang=\"fr\">"));
  EXPECT_THAT(html, HasSubstr("0,01 mm"));
}

TEST_F(ReportDialogTest, ThePaperThatIsChosenIsOfferedTheNextTime) {
  {
    ReportDialog dialog(subject_, FEEDSCOPE_EXECUTABLE);
    EXPECT_EQ(dialog.wish().paper, "") << "A4";
    auto* const paper = dialog.findChild<QComboBox*>("paper");
    ASSERT_NE(paper, nullptr);
    paper->setCurrentText("Letter");
    EXPECT_TRUE(dialog.busy()) << "the preview follows";
    EXPECT_THAT(report_arguments(dialog.wish(), "s.feedscope").join(' ').toStdString(),
                HasSubstr("--paper=Letter"));
  }
  EXPECT_EQ(ReportDialog(subject_, FEEDSCOPE_EXECUTABLE).wish().paper, "Letter");
}

/// It travels with the session that the report is made of.
TEST_F(ReportDialogTest, WhatWasIdentifiedGoesInUnlessItIsNotTicked) {
  subject_.session.identification.result.outcome = test::some_outcome();
  ReportDialog dialog(subject_, FEEDSCOPE_EXECUTABLE);
  dialog.save(folder_.filePath("with.html"));
  ASSERT_TRUE(rests(dialog));
  EXPECT_THAT(contents("with.html"), HasSubstr("Limits and settings of the machine, found from what it"));
  const QList<QListWidgetItem*> parts = dialog.parts().findItems("Identification", Qt::MatchExactly);
  ASSERT_EQ(parts.size(), 1);
  parts[0]->setCheckState(Qt::Unchecked);
  dialog.save(folder_.filePath("without.html"));
  ASSERT_TRUE(rests(dialog));
  EXPECT_THAT(contents("without.html"), Not(HasSubstr("Limits and settings of the machine")));
}

TEST_F(ReportDialogTest, SaysWhyNothingIsWritten) {
  ReportDialog dialog(subject_, FEEDSCOPE_EXECUTABLE);
  QSignalSpy saved(&dialog, &ReportDialog::saved);
  dialog.save(folder_.filePath("nowhere/r.pdf"));
  ASSERT_TRUE(rests(dialog));
  EXPECT_EQ(saved.size(), 0);
  ReportDialog broken(subject_, folder_.filePath("no-program"));
  ASSERT_TRUE(rests(broken));
  EXPECT_EQ(broken.preview().count(), 0);
}

TEST(ReportWish, BecomesTheArgumentsOfTheCommand) {
  ReportWish wish;
  EXPECT_EQ(report_arguments(wish, "s.feedscope"), QStringList{"s.feedscope"});
  wish.title = "A title";
  wish.date = QDate(2026, 1, 15);
  wish.without = {"charts", "view"};
  EXPECT_EQ(report_arguments(wish, "s.feedscope"),
            (QStringList{"s.feedscope", "--title=A title", "--date=2026-01-15", "--without=charts,view"}));
  wish = {};
  wish.with.append("charts");
  EXPECT_EQ(report_arguments(wish, "s.feedscope"), (QStringList{"s.feedscope", "--with=charts"}));
  wish.with = {"trust", "charts"};
  EXPECT_EQ(report_arguments(wish, "s.feedscope"),
            (QStringList{"s.feedscope", "--brief", "--with=trust,charts"}));
}

TEST(ReportWish, RunsThatAreLeftOutKeepTheOthersInTheirPlace) {
  Session session;
  for (int i = 0; i < 4; ++i) {
    session.runs.push_back({i, {}, {}, true, SetupState(make_setup({}))});
  }
  session.current_run = 2;
  session.scenes.other = 3;
  session.scenes.reference = 1;
  session.identification.choice.run = 3;
  const Session some = with_runs(session, {true, false, true, true});
  ASSERT_EQ(some.runs.size(), 3U);
  EXPECT_EQ(some.runs[some.current_run].id, 2);
  ASSERT_TRUE(some.scenes.other.has_value());
  EXPECT_EQ(some.runs[*some.scenes.other].id, 3);
  EXPECT_FALSE(some.scenes.reference.has_value());
  EXPECT_EQ(some.identification.choice.run, 2U);
  EXPECT_EQ(with_runs(session, {false, true}).current_run, 0U);
}

}  // namespace
}  // namespace feedscope::ui
