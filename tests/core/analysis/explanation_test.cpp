#include "core/analysis/explanation/explanation.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>

#include "core/base/units.h"
#include "tests/support/folders.h"

namespace feedscope {
namespace {

using ::testing::StartsWith;
using SimulatedRun = feedscope::Run;  // in tests Run is a member of testing::Test

SimulatedRun run_of(const LoadedProgram& program, const std::string& model, const std::string& machine,
                    const std::vector<std::string>& assignments = {}) {
  SetupRequest request;
  request.model = model;
  request.machine = machine;
  request.assignments = assignments;
  return simulate_run(program, make_setup(request));
}

LoadedProgram sample(const std::string& name) {
  return load_program(std::filesystem::path(FEEDSCOPE_SOURCE_DIR) / "resources/programs" / name);
}

LoadedProgram text(const std::string& program) {
  return load_program(std::make_shared<const SourceText>("test.nc", program));
}

double number(const Reason& reason, Symbol symbol) {
  const Quantity* found = reason.formula.find(symbol);
  return found == nullptr ? std::nan("") : found->value;
}

/// The explanation of the first of many instants that has `kind` for a cause.
Explanation first_with(const SimulatedRun& run, CauseKind kind) {
  constexpr int instants = 2000;
  for (int i = 0; i < instants; ++i) {
    const State state = run.trajectory->state(run.trajectory->duration() * (i + 0.5) / instants);
    if (state.cause.kind == kind) {
      return explain(run, state);
    }
  }
  ADD_FAILURE() << "never limited by " << cause_title({kind});
  return {};
}

TEST(Explanation, CircleOfTapieIsLimitedByTheCurvilinearJerk) {
  const SimulatedRun run = run_of(sample("tapie_circle_2_5.nc"), "tapie", "mikron-ucp710");
  const Reason reason = first_with(run, CauseKind::curvilinear_jerk).reason;
  EXPECT_EQ(reason.formula.left() + " = " + reason.formula.text(), "V = (J_curv r_jct R^2)^(1/3)");
  EXPECT_NEAR(number(reason, Symbol::radius), 2.5, 1e-9);
  EXPECT_EQ(number(reason, Symbol::curvilinear_jerk), 10'000);
  EXPECT_EQ(number(reason, Symbol::tangential_share), 0.6);
  EXPECT_NEAR(units::to_m_min(reason.formula.value()), 2.008, 0.001);
  EXPECT_NEAR(reason.reached, reason.formula.value(), 1e-9 * reason.reached);
  EXPECT_THAT(reason.source, StartsWith("Tapie 2007"));
}

TEST(Explanation, CrossingFromRadius14To16IsTheOneOfThePaper) {
  const SimulatedRun run = run_of(sample("tapie_quarter_spiral_0.nc"), "tapie", "mikron-ucp710");
  double found = 0;
  for (int i = 0; i < 2000; ++i) {
    const State state = run.trajectory->state(run.trajectory->duration() * (i + 0.5) / 2000);
    const Explanation why = explain(run, state);
    if (why.ahead && why.ahead->reason.cause.kind == CauseKind::curvature_crossing &&
        std::abs(number(why.ahead->reason, Symbol::curvature_step) - (1 / 14.0 - 1 / 16.0)) < 1e-9) {
      found = why.ahead->reason.formula.value();
      EXPECT_NEAR(why.ahead->speed, found, 1e-6 * found);
      EXPECT_GT(why.ahead->time, state.time);
    }
  }
  EXPECT_NEAR(units::to_m_min(found), 4.919, 0.001);
}

TEST(Explanation, ShortBlocksAreLimitedByTheInterpolationPeriod) {
  std::string program = "G1 G90 F9600\n";
  for (int i = 1; i <= 200; ++i) {
    program += "X" + std::to_string(i * 0.1) + "\n";
  }
  const SimulatedRun run = run_of(text(program + "M30\n"), "msaddek", "huron-kx10", {"compaction_mm=0.001"});
  const Reason reason = first_with(run, CauseKind::interpolation_period).reason;
  EXPECT_NEAR(number(reason, Symbol::block_length), 0.1, 1e-9);
  EXPECT_EQ(number(reason, Symbol::period), 0.002);
  EXPECT_NEAR(units::to_mm_min(reason.formula.value()), 3000, 1e-6);
  EXPECT_TRUE(reason.sets_it());
}

TEST(Explanation, BlockTimeSaysTheLengthOfTheBlock) {
  std::string program = "G1 G90 F9600\n";
  for (int i = 1; i <= 200; ++i) {
    program += fmt::format("X{}\n", i * 0.4);
  }
  for (const char* model : {"tapie", "essid", "gassara", "msaddek", "ward"}) {
    SCOPED_TRACE(model);
    const SimulatedRun run = run_of(text(program + "M30\n"), model, "spinner-mvc850", {"block_time_ms=8"});
    const Reason reason = first_with(run, CauseKind::block_time).reason;
    EXPECT_NEAR(number(reason, Symbol::block_length), 0.4, 1e-5);
    EXPECT_EQ(number(reason, Symbol::block_time), 0.008);
    EXPECT_NEAR(units::to_mm_min(reason.formula.value()), 3000, 0.1);
  }
}

/// Its limit is one of the machine, not the feed of the program: V_X / t_X of the cutting feed of X.
TEST(Explanation, ACuttingFeedOfAnAxisIsAVelocityOfThatAxis) {
  const LoadedProgram program = text("G21 G17 G90 G94\nG1 X80 Y60 F5000\nM30\n");
  for (const auto& [model, machine] : std::map<std::string, std::string>{{"cam", "spinner-mvc850"},
                                                                         {"essid", "spinner-mvc850"},
                                                                         {"gassara", "spinner-mvc850"},
                                                                         {"tapie", "spinner-mvc850"},
                                                                         {"msaddek", "spinner-mvc850"},
                                                                         {"ward", "spinner-mvc850"},
                                                                         {"optimal", "spinner-mvc850"},
                                                                         {"linuxcnc", "linuxcnc-mill"},
                                                                         {"grbl", "grbl-router"},
                                                                         {"klipper", "klipper-corexy"}}) {
    SCOPED_TRACE(model);
    const SimulatedRun run = run_of(program, model, machine, {"cutting_feed_x_m_min=2"});
    const Reason reason = first_with(run, CauseKind::axis_velocity).reason;
    EXPECT_EQ(cause_key(reason.cause), "axis_velocity_x");
    EXPECT_NEAR(units::to_m_min(reason.formula.value()), 2 / 0.8, 1e-9);
    EXPECT_NEAR(units::to_m_min(number(reason, Symbol::axis_velocity)), 2, 1e-12);
    // grbl meets a feed to whole steps of a timer.
    EXPECT_TRUE(model == "ward" || model == "grbl" || reason.sets_it());
    EXPECT_EQ(run.summary.time_by_cause[cause_index({CauseKind::programmed_feed})], 0);
  }
}

TEST(Explanation, BlendOfEssidIsEnteredAtItsLimit) {
  const SimulatedRun run = run_of(sample("essid_table1.nc"), "essid", "spinner-mvc850",
                                  {"contour_tolerance_mm=0.1", "program_tolerance=off"});
  for (std::size_t i = 0; i < run.trajectory->blend_count(); ++i) {
    const BlendRecord blend = run.trajectory->blend(i);
    const State before = run.trajectory->state_at_path(run.trajectory->path().s(blend.element) - 1e-3);
    ASSERT_EQ(before.cause.kind, CauseKind::ramp_down);
    const auto ahead = explain(run, before).ahead;
    ASSERT_TRUE(ahead);
    EXPECT_NEAR(ahead->speed, blend.entry_speed, 1e-6 * blend.entry_speed);
    EXPECT_NEAR(ahead->reason.formula.value(), blend.entry_speed, 1e-6 * blend.entry_speed);
    EXPECT_EQ(ahead->reason.cause.kind, CauseKind::blend_radial_jerk);
    EXPECT_EQ(number(ahead->reason, Symbol::jerk_share), 0.2);
  }
}

TEST(Explanation, FullStopAheadIsAnExactStopWithItsBrakingLength) {
  const SimulatedRun run = run_of(text("G1 G90 F3000 X50\nG4 P1\nX100\nM30\n"), "tapie", "mikron-ucp710");
  const Explanation why = first_with(run, CauseKind::ramp_down);
  ASSERT_TRUE(why.ahead);
  EXPECT_EQ(why.ahead->reason.cause.kind, CauseKind::exact_stop);
  EXPECT_NEAR(why.ahead->speed, 0, 1e-6);
  EXPECT_EQ(why.ahead->path_length, 50);
  // 50 mm/s with 5 m/s3 needs V^(3/2) / J^(1/2).
  EXPECT_EQ(why.reason.formula.id, FormulaId::braking_jerk);
  EXPECT_NEAR(why.reason.formula.value(), std::pow(50, 1.5) / std::sqrt(5000), 1e-6);
  EXPECT_TRUE(why.reason.sets_it());
}

TEST(Explanation, AStopSaysWhatItIsFor) {
  const auto reasons = [](const std::string& program, const std::string& tolerance) {
    const SimulatedRun run = run_of(text(program), "essid", "spinner-mvc850",
                                    {"contour_tolerance_mm=" + tolerance, "program_tolerance=off"});
    std::vector<StopReason> found;
    for (double time = 0; time < run.trajectory->duration(); time += 2e-3) {
      const Explanation why = explain(run, run.trajectory->state(time));
      if (why.ahead && why.ahead->reason.cause.kind == CauseKind::exact_stop &&
          (found.empty() || found.back() != why.ahead->reason.stop)) {
        found.push_back(why.ahead->reason.stop);
      }
    }
    return found;
  };
  using enum StopReason;
  EXPECT_EQ(reasons("G1 G90 F3000 X50\nG0 Y50\nG1 X0\nM30\n", "0.05"), (std::vector{rapid, end}));
  EXPECT_EQ(reasons("G1 G90 F3000 X50\nY50\nM30\n", "0"), (std::vector{tolerance, end}));
  EXPECT_EQ(reasons("G1 G90 F3000 X50\nY50\nM30\n", "0.05"), (std::vector{end}));
}

/// LinuxCNC stops at a reversal, whether or not rapids are beside it.
TEST(Explanation, ARapidIsNoReasonToStopForAModelThatRunsThroughThem) {
  const SimulatedRun run =
      run_of(text("G21 G90 G64\nG0 X50\nG0 X0\nG1 X10 F3000\nM2\n"), "linuxcnc", "linuxcnc-mill");
  for (double time = 0; time < run.trajectory->duration(); time += 2e-3) {
    const Explanation why = explain(run, run.trajectory->state(time));
    EXPECT_NE((why.ahead ? why.ahead->reason : why.reason).stop, StopReason::rapid) << time;
  }
}

TEST(Explanation, LookAheadThatIsTooShortNamesItsHorizon) {
  std::string program = "G1 G90 F9600\n";
  for (int i = 1; i <= 400; ++i) {
    program += "X" + std::to_string(i) + "\n";
  }
  const SimulatedRun run = run_of(text(program + "M30\n"), "tapie", "mikron-ucp710", {"lookahead_blocks=4"});
  bool found = false;
  for (int i = 0; i < 2000; ++i) {
    const Explanation why =
        explain(run, run.trajectory->state(run.trajectory->duration() * (i + 0.5) / 2000));
    if (why.ahead && why.ahead->reason.cause.kind == CauseKind::lookahead_horizon) {
      found = true;
      EXPECT_TRUE(why.ahead->reason.sets_it());
    }
  }
  EXPECT_TRUE(found);
}

/// Share of the explained instants of a sample whose formula gives what the run has, by what it gives.
struct Tally {
  int all = 0;
  int exact = 0;
  double share() const { return all == 0 ? 1 : static_cast<double>(exact) / all; }
};

class ExplanationOfSamples : public ::testing::TestWithParam<const char*> {};

TEST_P(ExplanationOfSamples, FormulasGiveWhatTheRunHas) {
  const std::string model = GetParam();
  Tally ramps;
  Tally speeds;
  Tally ahead;
  for (const char* name : {"essid_table1.nc", "essid_spline.nc", "tapie_circle_30.nc", "tapie_half_spiral.nc",
                           "msaddek_pocket.nc", "fanuc_flange.nc"}) {
    const SimulatedRun run = run_of(sample(name), model, "spinner-mvc850");
    constexpr int instants = 300;
    for (int i = 0; i < instants; ++i) {
      const State state = run.trajectory->state(run.trajectory->duration() * (i + 0.5) / instants);
      const Explanation why = explain(run, state);
      ASSERT_TRUE(std::isfinite(why.reason.formula.value()));
      const auto count = [](Tally& tally, const Reason& reason) {
        tally.all += reason.formula.empty() ? 0 : 1;
        tally.exact += reason.sets_it() ? 1 : 0;
      };
      const bool on_sampled_blend = state.cause.kind >= CauseKind::blend_velocity &&
                                    state.cause.kind <= CauseKind::blend_tangential_jerk &&
                                    std::abs(state.tangential_jerk) > 0;
      const bool at_constant_speed = state.tangential_acceleration == 0 && state.tangential_jerk == 0;
      const bool ramp = why.reason.formula.dimension() != Dimension::feed;
      if (!on_sampled_blend && !(ramp && at_constant_speed)) {
        count(ramp ? ramps : speeds, why.reason);
      }
      if (why.ahead) {
        count(ahead, why.ahead->reason);
      }
    }
  }
  EXPECT_GT(ramps.all, 100);
  EXPECT_GT(speeds.all, 100);
  EXPECT_GT(ramps.share(), 0.98) << ramps.exact << " of " << ramps.all;
  EXPECT_GT(speeds.share(), 0.98) << speeds.exact << " of " << speeds.all;
  EXPECT_GT(ahead.share(), 0.98) << ahead.exact << " of " << ahead.all;
}

/// What is summed up within the bars of |a_t + a_n| has a sign; every other number is a size.
bool has_sign(Symbol symbol) {
  return symbol == Symbol::acceleration_along || symbol == Symbol::acceleration_across ||
         symbol == Symbol::jerk_along || symbol == Symbol::jerk_across;
}

/// At standstills, on stops and blends too: sizes are not negative, and what is ahead is not behind.
class ExplanationNumbers : public testing::TestWithParam<const char*> {};
TEST_P(ExplanationNumbers, AreSizes) {
  for (const char* name :
       {"essid_table1.nc", "tapie_circle_30.nc", "msaddek_pocket.nc", "fanuc_flange.nc", "lesson_corners.nc",
        "lesson_short_blocks.nc", "trochoidal_slot.nc", "heidenhain_plate.h", "sinumerik_plate.mpf",
        "lesson_lookahead.nc", "tapie_bore.nc"}) {
    const SimulatedRun run = run_of(sample(name), GetParam(), "spinner-mvc850");
    const auto check = [&](const Reason& reason, double time) {
      for (const Quantity& quantity : reason.formula.numbers) {
        EXPECT_TRUE(quantity.value >= 0 || has_sign(quantity.symbol))
            << quantity.value << ", " << name << " at " << time << " s: " << reason.formula.text();
        EXPECT_TRUE(std::isfinite(quantity.value)) << name << " at " << time << " s";
      }
      EXPECT_GE(reason.formula.value(), 0) << name << " at " << time << " s: " << reason.formula.text();
    };
    const auto look = [&](const State& state) {
      const Explanation why = explain(run, state);
      check(why.reason, state.time);
      if (why.ahead) {
        check(why.ahead->reason, state.time);
        EXPECT_GE(why.ahead->path_length - state.path_length, -1e-9) << name << " at " << state.time << " s";
        EXPECT_GE(why.ahead->time, state.time) << name;
        EXPECT_LE(why.ahead->speed, 1.001 * state.speed + 1e-6) << name << " at " << state.time << " s";
      }
    };
    const Trajectory& trajectory = *run.trajectory;
    constexpr std::size_t instants = 400;
    for (std::size_t i = 0; i <= instants; ++i) {
      look(trajectory.state(trajectory.duration() * static_cast<double>(i) / instants));
    }
    const std::size_t count = trajectory.pieces().size();
    for (std::size_t i = 0; i < count; i += 1 + count / instants) {
      constexpr double just = 1e-7;  // [s]
      look(trajectory.state(trajectory.piece_end(i) - just));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Models, ExplanationNumbers,
                         ::testing::Values("essid", "gassara", "tapie", "msaddek", "ward", "optimal"),
                         [](const auto& instance) { return std::string(instance.param); });

INSTANTIATE_TEST_SUITE_P(Models, ExplanationOfSamples,
                         ::testing::Values("essid", "gassara", "tapie", "msaddek"),
                         [](const auto& instance) { return std::string(instance.param); });

TEST(Explanation, OfTimeOptimalRunIsASaturatedAxis) {
  const SimulatedRun run = run_of(sample("essid_table1.nc"), "optimal", "spinner-mvc850");
  const Explanation why = first_with(run, CauseKind::axis_acceleration);
  const auto axis = static_cast<Eigen::Index>(why.state.cause.axis);
  EXPECT_NEAR(why.reason.formula.value(), std::abs(why.state.acceleration[axis]), 1e-9);
  EXPECT_EQ(why.reason.reached, 1000);
}

TEST(Explanation, CornerOfWardKeepsTheTolerance) {
  const SimulatedRun run = run_of(text("G1 G90 F3000 X20\nY20\nM30\n"), "ward", "dmg-mori-evo40",
                                  {"contour_tolerance_mm=0.05", "program_tolerance=off"});
  const Reason reason = first_with(run, CauseKind::contour_tolerance).reason;
  EXPECT_NEAR(number(reason, Symbol::turn), units::pi / 2, 1e-9);
  EXPECT_NEAR(reason.formula.value(), 0.05, 1e-6);
}

TEST(CauseStretches, FollowEachOtherWithoutGaps) {
  const SimulatedRun run = run_of(sample("essid_table1.nc"), "essid", "spinner-mvc850");
  const Trajectory& trajectory = *run.trajectory;
  std::map<std::size_t, double> times;
  CauseStretch stretch = stretch_at(trajectory, 0);
  EXPECT_EQ(stretch.from, 0);
  EXPECT_FALSE(stretch_before(trajectory, stretch));
  for (int i = 0; i < 10'000; ++i) {
    times[cause_index(stretch.cause)] += stretch.to - stretch.from;
    EXPECT_EQ(trajectory.state((stretch.from + stretch.to) / 2).cause, stretch.cause);
    const auto next = stretch_after(trajectory, stretch);
    if (!next) {
      break;
    }
    EXPECT_EQ(next->from, stretch.to);
    EXPECT_NE(next->cause, stretch.cause);
    const auto back = stretch_before(trajectory, *next);
    ASSERT_TRUE(back);
    EXPECT_EQ(back->cause, stretch.cause);
    EXPECT_EQ(back->from, stretch.from);
    stretch = *next;
  }
  EXPECT_EQ(stretch.to, trajectory.duration());
  for (const auto& [cause, time] : times) {
    EXPECT_NEAR(time, run.summary.time_by_cause[cause], 1e-9);
  }
}

TEST(Formula, PutsNumbersInThePlaceOfSymbols) {
  const Formula formula{
      FormulaId::radial_jerk,
      {{Symbol::axis_jerk, 0, 5000}, {Symbol::radius, -1, 2.5}, {Symbol::tangent_part, 0, 0.8}}};
  EXPECT_EQ(formula.text(), "(J_X R^2 / |t_X|)^(1/3)");
  EXPECT_EQ(formula.with_numbers([](const Quantity& number) {
    return number.symbol == Symbol::radius ? std::string("2.5 mm") : std::string("n");
  }),
            "(n \u00b7 (2.5 mm)^2 / n)^(1/3)");
  EXPECT_NEAR(formula.value(), std::cbrt(5000 * 6.25 / 0.8), 1e-12);
}

}  // namespace
}  // namespace feedscope
