#include "core/analysis/explanation/remedies.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace feedscope {
namespace {

using SimulatedRun = feedscope::Run;  // in tests Run is a member of testing::Test

LoadedProgram text(const std::string& program) {
  return load_program(std::make_shared<const SourceText>("test.nc", program));
}

SimulatedRun run_of(const std::string& program, const std::string& model,
                    const std::vector<std::string>& assignments = {}) {
  SetupRequest request;
  request.model = model;
  request.assignments = assignments;
  return simulate_run(text(program), make_setup(request));
}

const std::string one_line = "G1 G90 F3000 X20\nM30\n";
const std::string corner = "G1 G90 F3000 X20\nY20\nX40\nM30\n";

Explanation caused_by(Cause cause) {
  Explanation why;
  why.reason.cause = cause;
  return why;
}

bool has(const std::vector<Remedy>& list, const Remedy& remedy) {
  return std::ranges::find(list, remedy) != list.end();
}

TEST(Remedies, BeginWithWhatTheCauseNames) {
  const auto setup = make_setup({});
  const double jerk = axis_limit(setup.machine, 'Y', "jerk");
  const auto by_jerk = remedies(setup, caused_by({CauseKind::axis_jerk, 1}));
  EXPECT_EQ(by_jerk.front(), (Remedy{{{"Y.jerk", 1.5 * jerk}}}));
  EXPECT_EQ(remedies(setup, caused_by({CauseKind::programmed_feed})).front(),
            (Remedy{{{"feed_override_percent", 120.0}}}));
  SetupRequest cutting;
  cutting.assignments = {"cutting_feed_x_m_min=12"};
  EXPECT_EQ(remedies(make_setup(cutting), caused_by({CauseKind::axis_velocity, 0})).front(),
            (Remedy{{{"cutting_feed_x_m_min", 18.0}}}));
}

TEST(Remedies, SetOnlyWhatTheModelReadsWithinItsBounds) {
  for (const ControlModel* model : all_models()) {
    SetupRequest request;
    request.model = model->info().id;
    const auto setup = make_setup(request);
    for (const Cause cause : all_causes()) {
      const auto list = remedies(setup, caused_by(cause));
      EXPECT_FALSE(list.empty());
      for (const Remedy& remedy : list) {
        EXPECT_NO_THROW({
          const auto changed = with_remedy(setup, remedy);
          EXPECT_NE(changed, setup);
        });
        EXPECT_EQ(std::ranges::count(list, remedy), 1);
      }
    }
  }
}

TEST(Remedies, StayWithinTheBoundsWhereALimitIsAtItsEnd) {
  SetupRequest request;
  request.model = "ward";
  request.assignments = {"X.jerk=900000000", "Y.jerk=1000000000", "Z.jerk=1000000000",
                         "filter_time_s=0.0001"};
  const auto setup = make_setup(request);
  for (const Cause cause : all_causes()) {
    for (const Remedy& remedy : remedies(setup, caused_by(cause))) {
      EXPECT_NO_THROW(EXPECT_NE(with_remedy(setup, remedy), setup));
    }
  }
}

TEST(Remedies, ALargerToleranceIsTwiceTheOneInForce) {
  PathControl fine;
  fine.contour_tolerance = 0.02;
  const auto setup = make_setup({});
  const auto list = remedies(setup, caused_by({CauseKind::blend_radial_jerk, 0}), std::span(&fine, 1));
  EXPECT_TRUE(has(list, {{{"contour_tolerance_mm", 0.04}, {"program_tolerance", std::string("off")}}, 0.02}));
}

/// P of G64 as well as the setting of a program without one; without a P there is nothing larger.
TEST(Remedies, ALargerBlendToleranceIsTwiceTheOneInForce) {
  SetupRequest request;
  request.model = "linuxcnc";
  request.assignments = {"blend_tolerance_mm=0.2"};
  const auto setup = make_setup(request);
  const auto found = [&](const PathControl& control) {
    return remedies(setup, caused_by({CauseKind::contour_tolerance}), std::span(&control, 1));
  };
  PathControl g64;
  g64.mode = PathMode::continuous;
  g64.contour_tolerance = 0.1;
  const std::pair<std::string, SettingValue> off("program_tolerance", std::string("off"));
  EXPECT_TRUE(has(found(g64), {{{"blend_tolerance_mm", 0.2}, off}, 0.1}))
      << "though it is that of the setting";
  EXPECT_TRUE(has(found(PathControl()), {{{"blend_tolerance_mm", 0.4}}, 0.2}));
  g64.contour_tolerance.reset();
  const auto as_far_as_blocks_allow = found(g64);
  EXPECT_TRUE(std::ranges::none_of(as_far_as_blocks_allow, [](const Remedy& remedy) {
    return remedy.changes.front().first == "blend_tolerance_mm";
  }));
}

TEST(Remedies, ASlowerPlaceAheadNamesWhatIsToBeChanged) {
  Explanation why = caused_by({CauseKind::ramp_down});
  why.ahead.emplace();
  why.ahead->reason.cause = {CauseKind::blend_radial_jerk, 0};
  const auto setup = make_setup({});
  const double share = setup.settings.number("radial_jerk_share");
  const auto list = remedies(setup, why);
  const auto found = std::ranges::find_if(
      list, [](const Remedy& remedy) { return remedy.changes.front().first == "radial_jerk_share"; });
  ASSERT_NE(found, list.end());
  EXPECT_NEAR(std::get<double>(found->changes.front().second), 1.5 * share, 5e-4);
}

TEST(Remedies, JerkOfALineThatIsTooShortForMoreGainsTheCubeRoot) {
  // 20 mm in two ramps of jerk J each up and down take 4 (20 / (2 J))^(1/3).
  const std::vector<std::string> loose{"X.acceleration=100", "X.velocity=600"};
  const SimulatedRun run = run_of("G1 G90 F600000 X20\nM30\n", "tapie", loose);
  const double jerk = axis_limit(run.setup.machine, 'X', "jerk");
  const Trajectory faster = try_remedy(run.input, run.setup, {{{"X.jerk", 1.5 * jerk}}});
  EXPECT_NEAR(faster.duration() / run.trajectory->duration(), std::cbrt(1 / 1.5), 1e-6);
}

TEST(Remedies, MoreFeedShortensWhatTheFeedLimits) {
  const SimulatedRun run = run_of(one_line, "cam");
  const Remedy remedy{{{"feed_override_percent", 120.0}}};
  EXPECT_NEAR(try_remedy(run.input, run.setup, remedy).duration(), run.trajectory->duration() / 1.2, 1e-9);
}

TEST(Remedies, CancelledTrialsStop) {
  const SimulatedRun run = run_of(corner, "essid");
  Progress progress;
  progress.cancel();
  EXPECT_THROW(try_remedy(run.input, run.setup, {}, &progress), Cancelled);
}

TEST(PassageTime, OfAllBlocksIsTheCycleTime) {
  for (const ControlModel* model : all_models()) {
    const SimulatedRun run = run_of(corner, model->info().id);
    const auto last = static_cast<std::uint32_t>(run.path->segments.size() - 1);
    EXPECT_NEAR(passage_time(*run.trajectory, {0, last}), run.trajectory->duration(), 1e-9);
    double sum = 0;
    for (std::uint32_t i = 0; i <= last; ++i) {
      sum += passage_time(*run.trajectory, {i, i});
    }
    EXPECT_NEAR(sum, run.trajectory->duration(), 1e-9);
  }
}

std::string dense_wave() {
  std::string program = "G21 G90\nG0 X0 Y0\nG1 F6000\n";
  for (int i = 1; i <= 200; ++i) {
    program += fmt::format("X{:.4f} Y{:.4f}\n", 0.2 * i, 3 * std::sin(0.2 * i / 3));
  }
  return program + "M30\n";
}

TEST(Remedies, ProposeTheCompressorWhereItIsNotAtWork) {
  const Remedy compressor{{{"compressor", std::string("on")}}};
  const Explanation why = caused_by({CauseKind::blend_radial_jerk, 0});
  for (const char* id : {"essid", "msaddek", "optimal"}) {
    EXPECT_TRUE(has(remedies(make_setup({"", id, {}}), why), compressor)) << id;
    EXPECT_FALSE(has(remedies(make_setup({"", id, {}, {"compressor=on"}}), why), compressor)) << id;
    PathControl asks;
    asks.compressor = Switch::on;
    EXPECT_FALSE(has(remedies(make_setup({"", id, {}}), why, std::span(&asks, 1)), compressor)) << id;
    EXPECT_TRUE(
        has(remedies(make_setup({"", id, {}, {"compressor=off"}}), why, std::span(&asks, 1)), compressor));
  }
  for (const char* id : {"gassara", "ward"}) {  // the one has none, the other gains nothing by it
    EXPECT_FALSE(has(remedies(make_setup({"", id, {}}), why), compressor)) << id;
  }
}

TEST(Remedies, TheCompressorGainsOnDensePrograms) {
  const SimulatedRun run = run_of(dense_wave(), "essid");
  const Trajectory smooth = try_remedy(run.input, run.setup, {{{"compressor", std::string("on")}}});
  EXPECT_LT(smooth.duration(), 0.7 * run.trajectory->duration());
  const SegmentRange middle{80, 120};
  EXPECT_LT(passage_time(smooth, middle), 0.7 * passage_time(*run.trajectory, middle));
}

TEST(PassageTime, OfBlocksUnderASmoothCurveIsThatBetweenTheirPoints) {
  for (const char* id : {"essid", "msaddek"}) {
    const SimulatedRun run = run_of(dense_wave(), id, {"compressor=on"});
    const auto& segments = run.path->segments;
    for (std::uint32_t i = 20; i < 180; ++i) {
      const double time = passage_time(*run.trajectory, {i, i});
      EXPECT_GT(time, 0.5 * segments[i].length / 100) << id << " " << i;
      EXPECT_LT(time, segments[i].length / 10) << id << " " << i;
    }
  }
}

TEST(PassageTime, BlocksUnderWayAreThoseOfTheirInstants) {
  const SimulatedRun run = run_of(corner, "cam");
  const double t = run.trajectory->duration() / 3;
  const SegmentRange middle = segments_between(*run.trajectory, 1.1 * t, 1.9 * t);
  EXPECT_EQ(middle.first, 1U);
  EXPECT_EQ(middle.last, 1U);
}

}  // namespace
}  // namespace feedscope
