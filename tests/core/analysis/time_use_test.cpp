#include "core/analysis/time/time_use.h"

#include <gtest/gtest.h>

#include <map>
#include <numeric>

#include "core/analysis/time/slow_groups.h"
#include "core/base/units.h"

namespace feedscope {
namespace {

using SimulatedRun = feedscope::Run;  // in tests Run is a member of testing::Test

SimulatedRun run_of(const std::string& program, const std::string& model,
                    const std::vector<std::string>& assignments = {}) {
  SetupRequest request;
  request.model = model;
  request.assignments = assignments;
  return simulate_run(load_program(std::make_shared<const SourceText>("test.nc", program)),
                      make_setup(request));
}

// Rapids, corners, an arc, a dwell, two tools with a spindle start each, and a loop of short lines.
const std::string mixed =
    "G21 G90 G17 F4000\nT1 M6\nM3 S8000\nG0 X0 Y0 Z5\nG1 Z-1 F500\nX30 F4000\nY20\nX25 Y24\nG2 X35 Y14 I10\n"
    "G4 P500\nG0 Z20\nT2 M6\nM3 S9000\nG0 X50 Y0\nG1 Z-1 F500\nX50.4 Y.1 F4000\nX50.8 Y.3\nX51.2 Y.6\n"
    "X51.6 Y1\nX80\nG0 Z50\nM30\n";
const std::vector<std::string> timed{"tool_change_time_s=4", "spindle_start_time_s=1.5"};

double sum_of(const TimeUse& use, double TimeShare::*part) {
  return std::accumulate(use.kinds.begin(), use.kinds.end(), 0.0,
                         [part](double sum, const TimeShare& share) { return sum + share.*part; });
}

TEST(TimeUse, AddsUpInEveryWayWithEveryModel) {
  for (const ControlModel* model : all_models()) {
    for (const auto& assignments : {std::vector<std::string>(), timed}) {
      const SimulatedRun run = run_of(mixed, model->info().id, assignments);
      SCOPED_TRACE(model->info().id);
      const TimeUse use = time_use(run);
      const double near = 1e-9 * use.cycle_time;
      EXPECT_EQ(use.cycle_time, run.summary.cycle_time);
      EXPECT_NEAR(use.programmed_time, run.summary.programmed_time, near);
      EXPECT_NEAR(sum_of(use, &TimeShare::time), use.cycle_time, near);
      EXPECT_NEAR(sum_of(use, &TimeShare::programmed), use.programmed_time, near);
      double time = 0, lost = 0;
      for (const CauseCost& cost : use.causes) {
        time += cost.time;
        lost += cost.lost;
      }
      EXPECT_NEAR(time, use.cycle_time, near);
      EXPECT_NEAR(use.programmed_time - use.saved_by_path + lost, use.cycle_time, near);
      ASSERT_GE(use.operations.size(), 2U);
      EXPECT_EQ(use.split, OperationSplit::tool);
      TimeShare all;
      for (const OperationTime& operation : use.operations) {
        all.time += operation.all.time;
        all.programmed += operation.all.programmed;
        EXPECT_LE(operation.rapid + operation.pause, operation.all.time + near);
      }
      EXPECT_NEAR(all.time, use.cycle_time, near);
      EXPECT_NEAR(all.programmed, use.programmed_time, near);
    }
  }
}

TEST(TimeUse, PausesAreWhatProgramAndMachineSay) {
  const TimeUse use = time_use(run_of(mixed, "essid", timed));
  EXPECT_NEAR(use.of(TimeKind::dwell).time, 0.5, 1e-9);
  EXPECT_NEAR(use.of(TimeKind::tool_change).time, 8, 1e-9);
  EXPECT_NEAR(use.of(TimeKind::spindle_start).time, 3, 1e-9);
  for (const TimeKind kind : {TimeKind::dwell, TimeKind::tool_change, TimeKind::spindle_start}) {
    EXPECT_NEAR(use.of(kind).lost(), 0, 1e-9);
  }
}

TEST(TimeUse, NothingIsLostAtTheProgrammedFeed) {
  // The reference model runs every motion at its programmed feed: 100 mm at 50 mm/s and 20 mm of rapid.
  const TimeUse use = time_use(run_of("G21 G90 F3000\nG1 X100\nG0 X120\nM30\n", "cam"));
  EXPECT_NEAR(use.of(TimeKind::cutting).time, 2, 1e-12);
  EXPECT_NEAR(use.of(TimeKind::cutting).lost(), 0, 1e-12);
  EXPECT_NEAR(use.lost(), 0, 1e-12);
  EXPECT_TRUE(use.operations.empty());
}

TEST(TimeUse, TheSlowerPlaceAheadBearsWhatBrakingCosts) {
  const TimeUse use = time_use(run_of("G21 G90 G61 F6000\nG1 X50\nY50\nM30\n", "essid"));
  for (const CauseCost& cost : use.causes) {
    EXPECT_NE(cost.cause.kind, CauseKind::ramp_down);
  }
  EXPECT_TRUE(std::ranges::any_of(
      use.causes, [](const CauseCost& cost) { return cost.cause.kind == CauseKind::exact_stop; }));
}

TEST(TimeUse, WhatThePathSavesIsNamedByWhatItIs) {
  const TimeUse cut = time_use(run_of("G21 G90 F6000\nG1 X50\nY50\nX0\nM30\n", "essid"));
  EXPECT_GT(cut.saved_by_path, 0);
  EXPECT_LT(cut.longer_path, 0);
  EXPECT_EQ(path_title(cut), "path shorter than programmed");
  // The blend runs at the lower of both feeds over all its length: a shorter path that takes longer.
  const TimeUse slow = time_use(run_of("G21 G90 F6000\nG1 X50 F10\nY50 F6000\nM30\n", "essid"));
  EXPECT_LT(slow.saved_by_path, 0);
  EXPECT_LT(slow.longer_path, 0);
  EXPECT_EQ(path_title(slow), "path at a lower programmed feed");
}

TEST(TimeUse, CommentsMakeOperationsWhereOneToolWorksAndALoopComesBackToOne) {
  const std::string loop =
      "#1=0\nWHILE [#1 LT 3] DO1\n(LEFT)\nG1 X10 F3000\n(RIGHT)\nX0\n#1=[#1+1]\nEND1\nM30\n";
  const SimulatedRun run = run_of(loop, "essid");
  const TimeUse use = time_use(run);
  EXPECT_EQ(use.split, OperationSplit::comment);
  ASSERT_EQ(use.operations.size(), 2U);
  EXPECT_EQ(use.operations[0].title, "LEFT");
  EXPECT_EQ(use.operations[1].title, "RIGHT");
  EXPECT_NEAR(use.operations[0].all.time + use.operations[1].all.time, use.cycle_time, 1e-9);
  EXPECT_NEAR(use.operations[0].all.programmed, 3 * 10 / 50.0, 1e-9);
  EXPECT_EQ(use.operations[0].start, 0);
}

TEST(TimeUse, StopsWhenCancelled) {
  const SimulatedRun run = run_of(mixed, "essid");
  Progress progress;
  progress.cancel();
  EXPECT_THROW(time_use(run, OperationSplit::none, &progress), Cancelled);
  EXPECT_THROW(find_slow_groups(*run.trajectory, &progress), Cancelled);
}

TEST(TimeUse, OfAnEmptyProgramIsNothing) {
  const SimulatedRun run = run_of("M30\n", "essid");
  EXPECT_EQ(time_use(run).cycle_time, 0);
  EXPECT_TRUE(find_slow_groups(*run.trajectory).groups.empty());
}

/// Right angles, one after the other, 20 mm apart.
std::string stairs(int corners) {
  std::string program = "G21 G90 F6000\nG1 X0 Y0\n";
  for (int i = 0; i < corners; ++i) {
    program += "G91 " + std::string(i % 2 == 0 ? "X20\n" : "Y20\n");
  }
  return program + "M30\n";
}

const SlowGroup* group_of(const SlowGroups& slow, PlaceShape shape) {
  const auto found = std::ranges::find(slow.groups, shape, &SlowGroup::shape);
  return found == slow.groups.end() ? nullptr : &*found;
}

TEST(SlowGroups, CornersOfOneKindAreOneGroup) {
  const SimulatedRun run = run_of(stairs(41), "essid");
  const SlowGroups slow = find_slow_groups(*run.trajectory);
  const SlowGroup* corners = group_of(slow, PlaceShape::corner);
  ASSERT_NE(corners, nullptr);
  EXPECT_NEAR(units::to_deg(corners->median), 90, 1e-3);
  EXPECT_EQ(corners->cause, Cause({CauseKind::blend_radial_jerk, -1})) << "X and Y limit alternately";
  std::size_t stops = 0;
  double loss = 0;
  for (const SlowGroup& group : slow.groups) {
    stops = group.shape == PlaceShape::stop ? std::max(stops, group.count) : stops;
    loss += group.loss;
    EXPECT_LE(group.worst.size(), SlowGroups::worst_places);
    EXPECT_GE(group.worst.front().loss, group.worst.back().loss);
  }
  EXPECT_EQ(corners->count, 40U);
  EXPECT_LT(slow.other, 0.01 * slow.loss) << "what is in no group is little";
  EXPECT_NEAR(loss + slow.other, slow.loss, 1e-9);
  EXPECT_LE(stops, 2U) << "the start and the end of the program";
}

TEST(SlowGroups, TimeIsLostToALowerFeedAheadNotToTheProgrammedFeed) {
  const SimulatedRun run = run_of("G21 G90\nG1 X50 F9000\nX80 F300\nM30\n", "essid");
  const SlowGroups slow = find_slow_groups(*run.trajectory);
  const auto lower = std::ranges::find(slow.groups, CauseKind::programmed_feed, &SlowGroup::kind);
  ASSERT_NE(lower, slow.groups.end());
  EXPECT_EQ(lost_to(*lower), "slowing for a lower programmed feed");
  for (const SlowGroup& group : slow.groups) {
    if (group.kind != CauseKind::programmed_feed) {
      EXPECT_EQ(lost_to(group), cause_title(group.cause));
    }
  }
}

TEST(SlowGroups, WithEveryModelLossesAddUpToAll) {
  for (const ControlModel* model : all_models()) {
    SCOPED_TRACE(model->info().id);
    const SimulatedRun run = run_of(mixed, model->info().id);
    const SlowGroups slow = find_slow_groups(*run.trajectory);
    const TimeUse use = time_use(run);
    double loss = slow.other;
    for (const SlowGroup& group : slow.groups) {
      loss += group.loss;
      EXPECT_LE(group.smallest, group.median);
      EXPECT_LE(group.median, group.largest);
    }
    EXPECT_NEAR(loss, use.lost() + use.saved_by_path, 1e-6 * use.cycle_time);
  }
}

/// Two tables, one number: what a kind of cause loses by shapes is no more than what it loses in all.
TEST(SlowGroups, NoKindOfCauseLosesMoreThanInTheTableOfCauses) {
  for (const ControlModel* model : all_models()) {
    SCOPED_TRACE(model->info().id);
    const SimulatedRun run = run_of(mixed, model->info().id);
    std::map<CauseKind, double> by_shapes;
    for (const SlowGroup& group : find_slow_groups(*run.trajectory).groups) {
      by_shapes[group.kind] += group.loss;
    }
    std::map<CauseKind, double> all;
    for (const CauseCost& cost : time_use(run).causes) {
      all[cost.cause.kind] += cost.lost;
    }
    for (const auto& [kind, loss] : by_shapes) {
      EXPECT_LE(loss, all[kind] + 1e-6 * run.summary.cycle_time) << cause_title(Cause{kind});
    }
  }
}

TEST(SlowGroups, WhatIsGainedAtPlacesOfAKindIsTakenFromTheirLoss) {
  // Segments of 10 ms of grbl run now a little above and now a little below the programmed feed.
  std::string program = "G21 G90\nG1 F600\n";
  for (int i = 1; i <= 40; ++i) {
    program += "X" + std::to_string(3 * i) + (i % 2 == 0 ? " Y0\n" : " Y1\n");
  }
  SetupRequest request;
  request.machine = "grbl-router";
  const SimulatedRun run =
      simulate_run(load_program(std::make_shared<const SourceText>("test.nc", program)), make_setup(request));
  const SlowGroups slow = find_slow_groups(*run.trajectory);
  double loss = slow.other;
  for (const SlowGroup& group : slow.groups) {
    EXPECT_GT(group.loss, 0);
    EXPECT_LT(group.loss, slow.loss);
    loss += group.loss;
  }
  EXPECT_NEAR(loss, slow.loss, 1e-9);
  ASSERT_FALSE(slow.groups.empty());
  double by_feed = 0;
  for (const SlowGroup& group : slow.groups) {
    by_feed += group.kind == CauseKind::programmed_feed ? group.loss : 0;
  }
  EXPECT_LT(by_feed, 0.5 * slow.loss);
}

TEST(SlowGroups, RapidsAreApartFromTheCutsBesideThem) {
  // Cuts in lines 2 and 5, rapids in lines 3 and 4: at rest in between, without a peak of the feed there.
  const std::string program = "G21 G90 G61 F6000\nG1 X50\nG0 Z20\nG0 X0\nG1 X30\nM30\n";
  // Also where the times of their ends have few digits left behind the point.
  for (const char* const pause : {"", "G4 P20000000 "}) {
    for (const ControlModel* model : all_models()) {
      SCOPED_TRACE(pause + std::string(model->info().id));
      if (model->info().id == "klipper") {  // knows no rapids: G0 is G1
        continue;
      }
      for (const SlowGroup& group :
           find_slow_groups(*run_of(pause + program, model->info().id).trajectory).groups) {
        for (const SlowPlace& place : group.worst) {
          const bool rapid = place.first_line >= 3 && place.last_line <= 4;
          const bool cut = place.last_line <= 2 || place.first_line >= 5;
          EXPECT_TRUE(rapid || cut) << place.first_line << " to " << place.last_line;
          EXPECT_EQ(group.shape == PlaceShape::rapid, rapid) << place.first_line;
        }
      }
    }
  }
}

TEST(SlowGroups, ArcsAreKnownByTheirRadius) {
  const SimulatedRun run =
      run_of("G21 G90 G17 F12000\nG1 X20\nG3 X20 Y4 J2\nG1 X0\nG2 X0 Y8 J2\nG1 X20\nM30\n", "tapie");
  const SlowGroups groups = find_slow_groups(*run.trajectory);
  const SlowGroup* arcs = group_of(groups, PlaceShape::arc);
  ASSERT_NE(arcs, nullptr);
  EXPECT_NEAR(arcs->median, 2, 1e-6);
}

}  // namespace
}  // namespace feedscope
