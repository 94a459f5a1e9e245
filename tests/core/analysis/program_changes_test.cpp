#include "core/analysis/time/program_changes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <sstream>

namespace feedscope {
namespace {

using SimulatedRun = feedscope::Run;  // in tests Run is a member of testing::Test

SimulatedRun run_of(const SetupRequest& request) {
  std::string program = "G21 G90 F6000\nG1 X0 Y0\n";
  for (int i = 1; i <= 30; ++i) {
    program += "X" + std::to_string(5 * i) + "\nY" + std::to_string(3 * i) + "\n";
  }
  return simulate_run(load_program(std::make_shared<const SourceText>("test.nc", program + "M30\n")),
                      make_setup(request));
}

ChangeTrials trials_of(const SimulatedRun& run) {
  return try_changes(run, changes_worth_trying(run, time_use(run)));
}

TEST(ProgramChanges, GainWhatARunWithThemGains) {
  for (const char* model : {"essid", "tapie", "ward", "grbl", "klipper"}) {
    SetupRequest request;
    request.model = model;
    const SimulatedRun run = run_of(request);
    const ChangeTrials trials = trials_of(run);
    SCOPED_TRACE(model);
    ASSERT_FALSE(trials.tried.empty());
    for (const TriedChange& change : trials.tried) {
      ASSERT_EQ(change.failure, "");
      const SimulatedRun changed = simulate_run(run.input, with_remedy(run.setup, change.remedy));
      EXPECT_NEAR(change.cycle_time, changed.summary.cycle_time, 1e-9);
      if (change.max_contour_error) {
        EXPECT_NEAR(*change.max_contour_error, changed.summary.max_contour_error, 1e-9);
      }
    }
  }
}

TEST(ProgramChanges, TheBestAreOfDifferentKindsAndGainMost) {
  const SimulatedRun run = run_of({});
  const ChangeTrials trials = trials_of(run);
  ASSERT_GE(trials.best.size(), 2U);
  EXPECT_LE(trials.best.size(), ChangeTrials::most);
  EXPECT_TRUE(std::ranges::is_sorted(trials.tried, {}, &TriedChange::cycle_time));
  std::set<std::string> kinds;
  for (const std::size_t i : trials.best) {
    EXPECT_TRUE(kinds.insert(kind_of(trials.tried[i].remedy)).second);
    EXPECT_LT(trials.tried[i].cycle_time, run.summary.cycle_time);
    EXPECT_TRUE(trials.tried[i].max_contour_error.has_value());
  }
  EXPECT_EQ(trials.best.front(), 0U);
}

TEST(ProgramChanges, TogetherTheyAreOneRunWithAllOfThem) {
  const SimulatedRun run = run_of({});
  const ChangeTrials trials = trials_of(run);
  ASSERT_TRUE(trials.together.has_value());
  auto setup = run.setup;
  for (const std::size_t i : trials.best) {
    const Remedy& remedy = trials.tried[i].remedy;
    if (remedy.machine.empty()) {
      setup = with_remedy(std::move(setup), remedy);
    }
  }
  EXPECT_NEAR(trials.together->cycle_time, simulate_run(run.input, setup).summary.cycle_time, 1e-9);
}

TEST(ProgramChanges, OtherMachinesRunTheSameProgramsWithTheSameToleranceAndPauses) {
  SetupRequest request;
  request.machine = "spinner-mvc850";
  request.tolerance = 0.037;
  request.assignments = {"tool_change_time_s=3"};
  const SimulatedRun run = run_of(request);
  std::set<std::string> machines;
  for (const Remedy& remedy : changes_worth_trying(run, time_use(run))) {
    if (!remedy.machine.empty()) {
      machines.insert(remedy.machine);
      const auto setup = with_remedy(run.setup, remedy);
      EXPECT_EQ(setup.machine.id, remedy.machine);
      EXPECT_EQ(setup.model, run.setup.model);
      EXPECT_EQ(contour_tolerance(setup), 0.037);
      EXPECT_EQ(setup.settings.number("tool_change_time_s"), 3);
    }
  }
  EXPECT_TRUE(machines.contains("mikron-ucp710"));
  for (const char* other : {"spinner-mvc850", "klipper-corexy", "grbl-router", "dmg-mori-evo40"}) {
    EXPECT_FALSE(machines.contains(other)) << other;
  }
}

/// What the options ask for, beside `request`; --machine and --model take the place of its own.
Setup asked_setup(SetupRequest request, const std::string& options) {
  std::istringstream words(options);
  for (std::string option, value; words >> option >> value;) {
    if (option == "--machine") {
      request = {};
      request.machine = value;
    } else if (option == "--model") {
      request.model = value;
    } else if (option == "--tolerance") {
      request.tolerance = std::stod(value);
      std::erase_if(request.assignments, [](const std::string& assignment) {
        return assigned_key(assignment) == "contour_tolerance_mm";  // the one or the other
      });
    } else {
      EXPECT_EQ(option, "--set");
      request.assignments.push_back(value);
    }
  }
  return make_setup(request);
}

TEST(ProgramChanges, OptionsOfTheCommandLineMakeTheSameSetup) {
  SetupRequest own;
  own.machine = "spinner-mvc850";
  own.assignments = {"tool_change_time_s=3", "contour_tolerance_mm=0.03", "X.jerk=17"};
  SetupRequest finer;
  finer.machine = "spinner-mvc850";
  finer.model = "tapie";
  finer.tolerance = 0.02;
  std::size_t machines = 0;
  for (const SetupRequest& request : {SetupRequest(), own, finer}) {
    const SimulatedRun run = run_of(request);
    std::size_t checked = 0;
    for (const Remedy& remedy : changes_worth_trying(run, time_use(run))) {
      const std::string options = as_options(remedy, run.setup);
      EXPECT_EQ(asked_setup(request, options), with_remedy(run.setup, remedy)) << options;
      ++checked;
      machines += remedy.machine.empty() ? 0 : 1;
    }
    EXPECT_GE(checked, 4U);
  }
  EXPECT_GE(machines, 3U);
  EXPECT_EQ(as_options({{{"feed_override_percent", 120.0}}}, make_setup(own)),
            "--set feed_override_percent=120");
}

TEST(ProgramChanges, OptionsOfAnotherMachineNameTheModelAndTheToleranceOfTheRun) {
  SetupRequest request;
  request.machine = "spinner-mvc850";
  Remedy huron;
  huron.machine = "huron-kx10";
  EXPECT_EQ(as_options(huron, make_setup(request)),
            "--machine huron-kx10 --model essid --set contour_tolerance_mm=0.1");
  request.tolerance = 0.02;
  EXPECT_EQ(as_options(huron, make_setup(request)), "--machine huron-kx10 --model essid --tolerance 0.02");
}

TEST(ProgramChanges, AMachineWhoseOwnControlRefusesLinesIsNotTried) {
  const auto tries_klipper = [](const std::string& first_line) {
    SetupRequest request;
    request.machine = "grbl-router";
    const SimulatedRun run =
        simulate_run(load_program(std::make_shared<const SourceText>(
                         "test.nc", first_line + "G21\nG90\nG1 X50 F3000\nG1 Y50\nG1 X0\nG1 Y0\n")),
                     make_setup(request));
    EXPECT_TRUE(run.lines_not_run.empty());
    return std::ranges::any_of(changes_worth_trying(run, time_use(run)),
                               [](const Remedy& remedy) { return remedy.machine == "klipper-corexy"; });
  };
  EXPECT_TRUE(tries_klipper(""));
  EXPECT_FALSE(tries_klipper("F355\n")) << "Klipper refuses a line that is only a feed";
}

TEST(ProgramChanges, AreOfOneKindWhateverTheAxis) {
  EXPECT_EQ(kind_of({{{"X.jerk", 1.0}}}), "jerk");
  EXPECT_EQ(kind_of({{{"Y.blend_jerk", 1.0}}}), "jerk");
  EXPECT_EQ(kind_of({{{"X.acceleration", 1.0}, {"Y.acceleration", 1.0}}}), "acceleration");
  EXPECT_EQ(kind_of({{{"contour_tolerance_mm", 0.1}}}), "tolerance");
  EXPECT_EQ(kind_of({{{"compressor", std::string("on")}}}), "compressor");
  EXPECT_EQ(kind_of({{{"feed_override_percent", 120.0}}}), "feed");
}

TEST(ProgramChanges, StopWhenCancelled) {
  const SimulatedRun run = run_of({});
  Progress progress;
  progress.cancel();
  EXPECT_THROW(try_changes(run, changes_worth_trying(run, time_use(run)), &progress), Cancelled);
}

}  // namespace
}  // namespace feedscope
