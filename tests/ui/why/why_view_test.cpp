#include "ui/why/why_view.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QAction>
#include <QHeaderView>
#include <QLocale>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTableView>
#include <QTest>
#include <filesystem>

#include "tests/support/folders.h"
#include "tests/ui/patience.h"
#include "tests/ui/run_fixture.h"
#include "ui/theme/theme.h"

namespace feedscope::ui {
namespace {

using testing::HasSubstr;

class WhyViewTest : public testing::Test {
 protected:
  WhyViewTest() {
    QLocale::setDefault(QLocale::c());
    show_sample("essid_table1.nc", {"spinner-mvc850", "essid", 0.1, {}});
    view.resize(340, 900);
    view.show();
  }

  void show_sample(const std::string& sample, const SetupRequest& request) {
    const auto setup = make_setup(request);
    state = SetupState(setup);
    const LoadedProgram input =
        load_program(std::filesystem::path(FEEDSCOPE_SOURCE_DIR) / "resources/programs" / sample);
    shown = make_shown(simulate_run(input, setup));
    cursor.set_trajectory(shown->run.trajectory);
    view.set_run(shown, *state);
  }
  const Trajectory& trajectory() const { return *shown->run.trajectory; }
  /// To the first instant with that cause.
  void go_to(CauseKind kind) {
    for (int i = 0; i < 4000; ++i) {
      const double time = trajectory().duration() * (i + 0.5) / 4000;
      if (trajectory().state(time).cause.kind == kind) {
        cursor.set_time(time);
        return;
      }
    }
    ADD_FAILURE() << "never limited by that";
  }
  QAction* action(const QString& text) const {
    for (QAction* candidate : view.panel_actions()) {
      if (candidate->text().remove('&').startsWith(text)) {
        return candidate;
      }
    }
    return nullptr;
  }
  void wait_for_trials() {
    ASSERT_TRUE(QTest::qWaitFor([this] { return view.remedies().rowCount() > 0 && !view.busy(); }, patience));
    QCoreApplication::processEvents();
  }

  std::shared_ptr<const ShownRun> shown;
  std::optional<SetupState> state;
  Cursor cursor;
  WhyView view{cursor};
};

TEST_F(WhyViewTest, SaysWhereTheDrivesMakeMostOfTheError) {
  EXPECT_TRUE(view.drives_text().isEmpty());  // a machine without drives
  show_sample("tapie_circle_30.nc", {"mikron-ucp710", "tapie", {}, {}});
  cursor.set_time(trajectory().duration() / 2);
  EXPECT_THAT(view.drives_text().toStdString(), HasSubstr("the drives make most of it"));
  cursor.set_time(0);
  EXPECT_TRUE(view.drives_text().isEmpty());
}

TEST_F(WhyViewTest, FollowsTheCursor) {
  go_to(CauseKind::axis_jerk);
  EXPECT_THAT(view.cause_text().toStdString(), HasSubstr("Jerk of axis"));
  EXPECT_THAT(view.formula_text().toStdString(), HasSubstr("15 m/s³"));
  go_to(CauseKind::ramp_down);
  EXPECT_THAT(view.sentence_text().toStdString(), HasSubstr("The tool brakes"));
}

TEST_F(WhyViewTest, HiddenItWorksNothingOut) {
  go_to(CauseKind::axis_jerk);
  view.hide();
  go_to(CauseKind::ramp_down);
  EXPECT_THAT(view.cause_text().toStdString(), HasSubstr("Jerk of axis"));
  view.show();
  EXPECT_THAT(view.cause_text().toStdString(), HasSubstr("Braking"));
}

TEST_F(WhyViewTest, NeighboursInTimeAreOneClickAway) {
  go_to(CauseKind::ramp_down);
  QSignalSpy chosen(&view, &WhyView::time_chosen);
  action("Next cause")->trigger();
  action("Previous cause")->trigger();
  action("Slower place")->trigger();
  ASSERT_EQ(chosen.size(), 3);
  const double now = cursor.state().time;
  EXPECT_GT(chosen[0][0].toDouble(), now);
  EXPECT_LT(chosen[1][0].toDouble(), now);
  EXPECT_NE(trajectory().state(chosen[1][0].toDouble()).cause, cursor.state().cause);
  EXPECT_EQ(chosen[2][0].toDouble(), explain(shown->run, cursor.state()).ahead->time);
}

TEST_F(WhyViewTest, ChangesAreTriedOnceTheCursorRestsAndTheBestComesFirst) {
  go_to(CauseKind::axis_jerk);
  wait_for_trials();
  const auto gain = [&](int row) {
    return view.remedies().index(row, RemedyTable::gain).data().toString().toStdString();
  };
  EXPECT_THAT(gain(0), HasSubstr("−"));
  EXPECT_THAT(gain(0), HasSubstr("%"));
}

TEST_F(WhyViewTest, AChangeBecomesARun) {
  go_to(CauseKind::axis_jerk);
  wait_for_trials();
  std::vector<SetupState> wanted;
  QObject::connect(&view, &WhyView::run_wanted, [&](const SetupState& setup) { wanted.push_back(setup); });
  for (int row = 0; row < view.remedies().rowCount(); ++row) {
    view.table()->setCurrentIndex(view.remedies().index(row, 0));
    const bool in_program = view.remedies().remedy(row)->changes.empty();
    EXPECT_EQ(action("New run")->isEnabled(), !in_program);
    action("New run")->trigger();
  }
  ASSERT_GT(wanted.size(), 2U);
  EXPECT_FALSE(wanted.front().edits().empty());
}

TEST_F(WhyViewTest, AnotherCauseDropsTheChanges) {
  go_to(CauseKind::axis_jerk);
  wait_for_trials();
  go_to(CauseKind::programmed_feed);
  EXPECT_EQ(view.remedies().rowCount(), 0);
}

TEST_F(WhyViewTest, FitsIntoANarrowDock) {
  for (const CauseKind kind : {CauseKind::axis_jerk, CauseKind::ramp_down, CauseKind::blend_radial_jerk}) {
    go_to(kind);
    view.try_remedies();
    wait_for_trials();
    auto* area = view.findChild<QScrollArea*>();
    EXPECT_EQ(area->horizontalScrollBar()->maximum(), 0);
    EXPECT_LE(view.table()->horizontalHeader()->length(), view.table()->viewport()->width());
  }
}

TEST_F(WhyViewTest, WithoutARunItSaysWhatToDo) {
  view.set_run(nullptr, *state);
  cursor.set_trajectory(nullptr);
  EXPECT_THAT(view.sentence_text().toStdString(), HasSubstr("Open a program"));
  view.try_remedies();
  EXPECT_EQ(view.remedies().rowCount(), 0);
}

TEST_F(WhyViewTest, EveryModelIsExplainedEverywhere) {
  for (const ControlModel* model : all_models()) {
    show_sample("essid_table1.nc", {"spinner-mvc850", model->info().id, {}, {}});
    for (int i = 0; i <= 40; ++i) {
      cursor.set_time(trajectory().duration() * i / 40);
      EXPECT_FALSE(view.sentence_text().isEmpty());
      EXPECT_FALSE(view.sentence_text().contains("nan"));
      EXPECT_FALSE(view.formula_text().contains("nan"));
    }
  }
}

}  // namespace
}  // namespace feedscope::ui
