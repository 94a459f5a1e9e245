#include "core/analysis/study/compare.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/error.h"

namespace feedscope {
namespace {

LoadedProgram corner() {
  return load_program(std::make_shared<const SourceText>("corner.nc", "G1 X20 F3000\nY20\n"));
}

TEST(SetupsToCompare, AreEveryMachineWithEveryModelAndTolerance) {
  const auto setups = setups_to_compare({"huron-kx10", "spinner-mvc850"}, {"essid", "msaddek"}, {0.01, 0.05});
  ASSERT_EQ(setups.size(), 8u);
  EXPECT_EQ(setups[0].machine.id, "huron-kx10");
  EXPECT_EQ(setups[3].model->info().id, "msaddek");
  EXPECT_EQ(setups[3].settings.number("contour_tolerance_mm"), 0.05);
  EXPECT_EQ(setups[4].machine.id, "spinner-mvc850");
}

TEST(SetupsToCompare, TakeAModelWithoutToleranceOnce) {
  EXPECT_EQ(setups_to_compare({}, {"cam", "essid"}, {0.01, 0.05}).size(), 3u);
}

TEST(SetupsToCompare, AreAllModelsWhereNoneIsNamed) {
  EXPECT_EQ(setups_to_compare({}, {}, {}).size(), all_models().size());
}

TEST(SetupsToCompare, RefuseAToleranceOutOfBounds) {
  EXPECT_THROW(setups_to_compare({}, {"essid"}, {-1}), InputError);
}

TEST(SetupsToCompare, TakeAnAssignmentWhereTheModelKnowsIt) {
  const auto setups = setups_to_compare({}, {"cam", "essid"}, {}, {"alpha=2", "X.jerk=5"});
  ASSERT_EQ(setups.size(), 2u);
  EXPECT_FALSE(setups[0].settings.has("alpha"));
  EXPECT_EQ(setups[1].settings.number("alpha"), 2);
  for (const auto& setup : setups) {
    EXPECT_EQ(axis_limit(setup.machine, 'X', "jerk"), 5);
  }
}

TEST(SetupsToCompare, RefuseAnAssignmentThatNoModelTakes) {
  const auto message = [](const std::string& assignment) {
    return [assignment] { setups_to_compare({}, {"cam", "tapie"}, {}, {assignment}); };
  };
  EXPECT_THAT(message("alpha=2"), ::testing::ThrowsMessage<InputError>(
                                      ::testing::HasSubstr("'alpha' is unknown to the models cam, tapie; ")));
  EXPECT_THAT(message("X.jrek=2"),
              ::testing::ThrowsMessage<InputError>(::testing::HasSubstr("did you mean 'X.jerk'?")));
  EXPECT_THAT(message("X.jerk"), ::testing::ThrowsMessage<InputError>(::testing::HasSubstr("has no value")));
}

TEST(CompareRuns, GiveTheFiguresOfSingleRunsInTheOrderOfTheSetups) {
  const LoadedProgram program = corner();
  const auto setups = setups_to_compare({"spinner-mvc850", "huron-kx10"}, {}, {0.01, 0.02, 0.05});
  const auto runs = compare_runs(program, setups);
  ASSERT_EQ(runs.size(), setups.size());
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const auto alone = simulate_run(program, setups[i]);
    EXPECT_EQ(runs[i].setup.machine.id, setups[i].machine.id);
    EXPECT_EQ(runs[i].setup.model, setups[i].model);
    EXPECT_EQ(runs[i].setup.settings, setups[i].settings);
    EXPECT_EQ(runs[i].summary.cycle_time, alone.summary.cycle_time);
    EXPECT_EQ(runs[i].summary.time_by_cause, alone.summary.time_by_cause);
    EXPECT_EQ(runs[i].path_length, alone.trajectory->path_length());
    EXPECT_EQ(runs[i].blends, alone.trajectory->blend_count());
  }
}

TEST(CompareRuns, MeasureAgainstTheTimeThatCamPromises) {
  const auto runs = compare_runs(corner(), setups_to_compare({}, {"cam", "essid"}, {}));
  EXPECT_DOUBLE_EQ(runs[0].against_cam(), 1);
  EXPECT_DOUBLE_EQ(runs[1].against_cam(), runs[1].summary.cycle_time / runs[0].summary.cycle_time);
}

TEST(CompareRuns, PassOnWhatTheFirstFailedRunThrew) {
  auto setups = setups_to_compare({}, {"cam", "essid", "msaddek"}, {});
  setups[1].machine.axes[1].jerk = 0;
  setups[1].machine.id = "first";
  setups[2].machine.axes[0].jerk = 0;
  EXPECT_THAT([&] { compare_runs(corner(), setups); },
              ::testing::ThrowsMessage<InputError>(::testing::HasSubstr("machine 'first': axis Y")));
}

TEST(CompareRuns, OfNoSetupIsNothing) {
  EXPECT_TRUE(compare_runs(corner(), {}).empty());
}

TEST(CompareRuns, ReportTheWholeWhenTheyAreDone) {
  Progress progress;
  compare_runs(corner(), setups_to_compare({}, {}, {}), &progress);
  EXPECT_EQ(progress.fraction(), 1);
}

TEST(CompareRuns, StopWhenCancelled) {
  Progress progress;
  progress.cancel();
  EXPECT_THROW(compare_runs(corner(), setups_to_compare({}, {}, {0.01, 0.02}), &progress), Cancelled);
}

}  // namespace
}  // namespace feedscope
