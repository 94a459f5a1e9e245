#include "ui/time_use/time_view.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QTreeWidget>
#include <optional>

#include "core/analysis/explanation/explanation.h"
#include "tests/ui/patience.h"
#include "tests/ui/run_fixture.h"
#include "ui/workbench/workbench.h"

namespace feedscope::ui {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class TimeViewTest : public testing::Test {
 protected:
  TimeViewTest() {
    QLocale::setDefault(QLocale::c());
    view.resize(380, 600);
    view.show();
  }

  void set_run(const feedscope::Run& run) {
    shown = make_shown(run);
    findings.set_run(shown, SetupState(run.setup));
  }
  bool finishes() {
    return QTest::qWaitFor([this] { return !view.busy(); }, patience);
  }
  QTreeWidgetItem* section(const QString& title) {
    for (int i = 0; i < view.tree().topLevelItemCount(); ++i) {
      if (view.tree().topLevelItem(i)->text(0).startsWith(title)) {
        return view.tree().topLevelItem(i);
      }
    }
    return nullptr;
  }
  void click(QTreeWidgetItem* item) {
    view.tree().scrollToItem(item);
    QTest::mouseClick(view.tree().viewport(), Qt::LeftButton, {}, view.tree().visualItemRect(item).center());
  }

  feedscope::Run run = test::simulate_text(test::small_program);
  std::shared_ptr<const ShownRun> shown;
  TimeFindings findings;
  TimeView view{findings};
};

TEST_F(TimeViewTest, SaysWhereTheTimeGoesAndWhatWouldHelp) {
  set_run(run);
  ASSERT_TRUE(finishes());
  EXPECT_THAT(view.conclusion().toStdString(), HasSubstr("programmed"));
  EXPECT_THAT(view.conclusion().toStdString(), HasSubstr("Mean feed "));
  ASSERT_NE(section("What it consists of"), nullptr);
  ASSERT_NE(section("Places that lose most"), nullptr);
  ASSERT_NE(section("What would help"), nullptr);
  ASSERT_NE(section("Limited by, with braking for it"), nullptr);
  ASSERT_NE(findings.report(), nullptr);
  EXPECT_FALSE(findings.report()->changes.best.empty());
  EXPECT_EQ(findings.report()->use.cycle_time, run.summary.cycle_time);
}

TEST_F(TimeViewTest, SaysWhatItsShareIsOf) {
  set_run(run);
  ASSERT_TRUE(finishes());
  const TimeUse& use = findings.report()->use;
  const QString share = QLocale().toString(100 * use.lost() / use.cycle_time, 'f', 1);
  EXPECT_THAT(view.conclusion().toStdString(),
              HasSubstr("(" + share.toStdString() + " % of the cycle time)"));
}

/// As report and `explain` print it.
TEST_F(TimeViewTest, AGainIsPositive) {
  set_run(run);
  ASSERT_TRUE(finishes());
  const ChangeTrials& changes = findings.report()->changes;
  const double gain = findings.report()->use.cycle_time - changes.tried[changes.best.front()].cycle_time;
  EXPECT_EQ(section("What would help")->child(0)->text(1),
            QLocale().toString(gain, 'f', decimals_of_gain(gain)) + QStringLiteral(" s"));
}

TEST_F(TimeViewTest, WhereNothingMovesThereIsNothingToTry) {
  set_run(test::simulate_text("M30\n"));
  EXPECT_FALSE(view.busy());
  EXPECT_EQ(view.conclusion(), QStringLiteral("Nothing in this program takes time."));
  EXPECT_FALSE(view.panel_actions().first()->isEnabled());
  for (const QPushButton* button : view.findChildren<QPushButton*>()) {
    EXPECT_FALSE(button->isVisible()) << button->text().toStdString();
  }
}

/// To where its cause rules: *Why here?* then speaks of what the row says.
TEST_F(TimeViewTest, AClickGoesToTheWorstPlaceOfAGroup) {
  set_run(run);
  ASSERT_TRUE(finishes());
  QSignalSpy chosen(&view, &TimeView::place_chosen);
  click(section("Places that lose most")->child(0));
  ASSERT_EQ(chosen.size(), 1);
  const SlowPlace& worst = findings.report()->slow.groups.front().worst.front();
  EXPECT_EQ(chosen[0][1].toDouble(), worst.from);
  EXPECT_EQ(chosen[0][2].toDouble(), worst.to);
  const State there = run.trajectory->state(chosen[0][0].toDouble());
  const Explanation why = explain(run, there);
  EXPECT_EQ((why.ahead ? why.ahead->reason.cause : why.reason.cause).kind, worst.cause.kind);
}

TEST_F(TimeViewTest, AChangeBecomesARunThatTakesWhatWasSaid) {
  set_run(run);
  ASSERT_TRUE(finishes());
  std::optional<SetupState> wanted;
  QObject::connect(&view, &TimeView::run_wanted, [&](const SetupState& setup) { wanted = setup; });
  QTreeWidgetItem* changes = section("What would help");
  std::size_t checked = 0;
  const ChangeTrials trials = findings.report()->changes;
  for (std::size_t i = 0; i < trials.best.size(); ++i) {
    const TriedChange& change = trials.tried[trials.best[i]];
    view.tree().setCurrentItem(changes->child(static_cast<int>(i)));
    QAction* new_run = view.panel_actions().last();
    ASSERT_TRUE(new_run->isEnabled());
    new_run->trigger();
    ASSERT_TRUE(wanted.has_value());
    EXPECT_NEAR(simulate_run(run.input, wanted->setup()).summary.cycle_time, change.cycle_time, 1e-9);
    ++checked;
  }
  EXPECT_GE(checked, 1U);
}

/// Rapids and dwells that are left of it take time, but there is nothing to explain.
TEST_F(TimeViewTest, OfARefusedProgramItSaysThatItIsRefused) {
  set_run(run);
  ASSERT_TRUE(finishes());
  set_run(test::simulate_text("G21 G90\nG0 X10\nG1 X100\nG1 Y100\n", "grbl", "grbl-router"));
  EXPECT_FALSE(view.busy());
  EXPECT_EQ(findings.report(), nullptr);
  EXPECT_EQ(view.tree().topLevelItemCount(), 0);
  EXPECT_THAT(view.conclusion().toStdString(), AllOf(HasSubstr("The control refuses the program"),
                                                     HasSubstr("Lines that are not run: 3, 4.")));
  EXPECT_FALSE(view.panel_actions().first()->isEnabled()) << "nothing to try changes of";
  findings.try_changes();
  EXPECT_FALSE(view.busy());
}

TEST_F(TimeViewTest, SaysHowManyLinesAreNotInItsTimes) {
  set_run(test::simulate_text("G21 G90\nG1 X10 F1000\nG1 X200 H1\nX10\n", "grbl", "grbl-router"));
  ASSERT_TRUE(finishes());
  EXPECT_THAT(view.conclusion().toStdString(),
              AllOf(HasSubstr("programmed"), HasSubstr("and not run (line 3).")));
}

TEST_F(TimeViewTest, LongNamesStandInSeveralLinesWhereThePanelIsNarrow) {
  set_run(run);
  ASSERT_TRUE(finishes());
  QTreeWidgetItem* longest = section("Places that lose most")->child(0);
  QCoreApplication::processEvents();
  const int line = view.tree().fontMetrics().height();
  view.resize(900, 600);
  QCoreApplication::processEvents();
  EXPECT_LT(view.tree().visualItemRect(longest).height(), 2 * line);
  view.resize(260, 600);
  QCoreApplication::processEvents();
  EXPECT_GE(view.tree().visualItemRect(longest).height(), 2 * line) << longest->text(0).toStdString();
}

TEST_F(TimeViewTest, WorksOnlyWhileItCanBeSeen) {
  view.set_on_screen(false);
  set_run(run);
  EXPECT_FALSE(view.busy());
  EXPECT_EQ(findings.report(), nullptr);
  view.set_on_screen(true);
  EXPECT_TRUE(view.busy());
  ASSERT_TRUE(finishes());
  EXPECT_NE(findings.report(), nullptr);
}

TEST_F(TimeViewTest, NoProgramEmptiesIt) {
  set_run(run);
  ASSERT_TRUE(finishes());
  findings.set_run(nullptr, SetupState(run.setup));
  EXPECT_EQ(view.tree().topLevelItemCount(), 0);
  EXPECT_FALSE(view.busy());
  EXPECT_THAT(view.conclusion().toStdString(), HasSubstr("Open a program"));
}

TEST_F(TimeViewTest, ALongProgramTriesChangesWhenAsked) {
  feedscope::Run slow = run;
  slow.simulate_time = 60;
  set_run(slow);
  ASSERT_TRUE(finishes());
  EXPECT_TRUE(findings.report()->changes.tried.empty());
  view.panel_actions().first()->trigger();
  ASSERT_TRUE(finishes());
  EXPECT_FALSE(findings.report()->changes.tried.empty());
}

TEST_F(TimeViewTest, ARunThatWasLookedAtBeforeIsKnownAtOnce) {
  set_run(run);
  ASSERT_TRUE(finishes());
  const auto first_shown = shown;
  const auto first = findings.report();
  set_run(test::simulate_text("G21 G90\nG1 X20 F3000\nY20\nM2\n"));
  EXPECT_EQ(findings.report(), nullptr);
  ASSERT_TRUE(finishes());
  EXPECT_NE(findings.report(), first);
  findings.set_run(make_shown(run), SetupState(run.setup));
  EXPECT_FALSE(view.busy());
  EXPECT_EQ(findings.report(), first);
}

/// While a changed value is simulated there is no run.
TEST_F(TimeViewTest, AfterAnEditItTriesChangesOnlyAfterAPause) {
  set_run(run);
  ASSERT_TRUE(finishes());
  findings.set_run(nullptr, SetupState(run.setup));
  set_run(test::simulate_text("G21 G90\nG1 X20 F3000\nY20\nM2\n"));
  ASSERT_TRUE(QTest::qWaitFor([this] { return findings.report() != nullptr; }, patience));
  QTest::qWait(300);
  EXPECT_TRUE(findings.report()->changes.tried.empty());
  findings.set_run(nullptr, SetupState(run.setup));
  EXPECT_FALSE(view.busy()) << "the next edit ends the pause";
}

/// A value that is being changed is simulated, not what would help the value before it.
TEST_F(TimeViewTest, LeavesTheProcessorsToAnotherSimulation) {
  set_run(run);
  findings.give_way(true);
  ASSERT_TRUE(finishes());
  ASSERT_NE(findings.report(), nullptr);
  EXPECT_TRUE(findings.report()->changes.tried.empty());
  findings.give_way(false);
  ASSERT_TRUE(finishes());
  EXPECT_FALSE(findings.report()->changes.tried.empty());
}

}  // namespace
}  // namespace feedscope::ui
