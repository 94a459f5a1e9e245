#include "core/models/linuxcnc/linuxcnc_model.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>
#include <sstream>

#include "core/analysis/explanation/explanation.h"
#include "core/analysis/notes/remarks.h"
#include "core/analysis/run/run.h"
#include "core/export/export.h"
#include "core/machine/import/machine_import.h"
#include "tests/support/folders.h"

namespace feedscope {
namespace {

using std::numbers::pi;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

constexpr double acceleration = 1000;  // [mm/s2]

/// Axes of 200 mm/s and 1000 mm/s2.
Machine machine() {
  Machine made;
  made.id = made.name = made.control = made.reference = "linuxcnc";
  for (const char axis : coordinate_names) {
    set_axis_limit(made, axis, "velocity", 12);
    set_axis_limit(made, axis, "acceleration", acceleration / 1000);
    set_axis_limit(made, axis, "jerk", 500);
    set_axis_limit(made, axis, "blend_jerk", 500);
  }
  return made;
}

/// `text` on machine(), with path control `mode` where the text says nothing.
Trajectory run(const std::string& text, const std::string& mode = "G64",
               const std::vector<std::string>& assignments = {}) {
  const LoadedProgram loaded = load_program(std::make_shared<const SourceText>(SourceText("test.ngc", text)));
  const ControlModel& linuxcnc = find_model("linuxcnc");
  Settings settings = complete_settings(linuxcnc, machine());
  settings.set("blend_mode", mode);
  Machine of_run = machine();
  for (const std::string& assignment : assignments) {
    apply_setting(assignment, linuxcnc, of_run, settings);
  }
  return linuxcnc.simulate(loaded.toolpath, of_run, settings);
}

std::string blends_csv(const Trajectory& motion) {
  std::ostringstream out;
  write_blends(out, motion);
  const std::string text = out.str();
  return text.substr(text.find('\n') + 1);
}

/// The circle that touches both lines and passes the corner at P: its radius R has P = R (sqrt(2) - 1), and
/// its speed takes 0.866 of the acceleration across it.
TEST(LinuxCncModel, RoundsASquareCornerByAnArcWithinP) {
  constexpr double tolerance = 0.05;
  const double radius = tolerance / (std::numbers::sqrt2 - 1);
  const double speed = std::sqrt(std::sqrt(3) / 2 * acceleration * radius);
  const Trajectory motion = run("G21 G90 G64 P0.05\nG1 X20 F3000\nY20\nM2\n");
  ASSERT_EQ(motion.blend_count(), 1U);
  const BlendRecord blend = motion.blend(0);
  EXPECT_EQ(blend.line, 2U);
  EXPECT_EQ(motion.path().kind(blend.element), ElementKind::arc);
  EXPECT_NEAR((blend.corner - Vec3(20, 0, 0)).norm(), 0, 1e-12);
  EXPECT_NEAR(blend.turn, pi / 2, 1e-12);
  EXPECT_NEAR(blend.epsilon, tolerance, 1e-9);
  EXPECT_NEAR(blend.min_radius, radius, 1e-9);
  EXPECT_NEAR(blend.transition, radius, 1e-9);
  EXPECT_NEAR(blend.length, radius * pi / 2, 1e-9);
  EXPECT_NEAR(blend.entry_speed, speed, 1e-6);
  EXPECT_NEAR(blend.exit_speed, speed, 1e-6);
  EXPECT_THAT(blends_csv(motion), StartsWith("2,arc,20,0,0,90,"));
}

/// A helix cannot be shortened for an arc: it begins while the line before it ends.
/// Of 0.025 mm height over chords of 10 mm, below Q: two lines each, which become one with their neighbours.
TEST(LinuxCncModel, ShallowArcsAreLinesWhetherTheyRiseOrNot) {
  for (const char* rise : {"", " Z1"}) {
    const Trajectory motion =
        run(std::string("G21 G90 G64 P0.05 Q0.03\nG3 X10 Y0 R500") + rise + " F3000\nM2\n");
    ASSERT_EQ(motion.path().size(), 1U);
    EXPECT_EQ(motion.path().kind(0), ElementKind::line);
    EXPECT_EQ(
        run(std::string("G21 G90 G64 P0.05 Q0.02\nG3 X10 Y0 R500") + rise + " F3000\nM2\n").path().kind(0),
        ElementKind::arc);
  }
}

TEST(LinuxCncModel, BlocksThatOverlapRoundOneCornerOfUnknownRadius) {
  const Trajectory motion = run("G21 G90 G64 P0.05\nG1 X20 F3000\nG2 X40 Z2 I10 J0\nM2\n");
  ASSERT_EQ(motion.blend_count(), 1U);
  const BlendRecord blend = motion.blend(0);
  EXPECT_EQ(motion.path().kind(blend.element), ElementKind::line);
  EXPECT_NEAR(blend.turn, pi / 2, 1e-12);
  EXPECT_GT(blend.epsilon, 0);
  EXPECT_LT(blend.epsilon, blend.transition);
  EXPECT_TRUE(std::isnan(blend.min_radius));
  EXPECT_TRUE(motion.path().rounds_corner(blend.element));
  EXPECT_FALSE(motion.path().rounds_corner(blend.element - 1));
  EXPECT_FALSE(motion.path().rounds_corner(motion.path().size() - 1));
  EXPECT_THAT(blends_csv(motion), StartsWith("2,overlap,20,0,0,"));
  EXPECT_THAT(blends_csv(motion), HasSubstr(",,"));
}

/// Two lines in one direction: G61 passes their joint, G61.1 stops in it, which takes v/a more.
TEST(LinuxCncModel, StopsInTangentialJointsUnderG61Point1Alone) {
  const double whole = run("G21 G90 G61\nG1 X40 F3000\nM2\n").duration();
  EXPECT_NEAR(run("G21 G90 G61\nG1 X20 F3000\nX40\nM2\n").duration(), whole, 2e-3);
  EXPECT_NEAR(run("G21 G90 G61.1\nG1 X20 F3000\nX40\nM2\n").duration(), whole + 50 / acceleration, 4e-3);
}

/// A mode of the settings is that of the program, but for the period that the word of the program takes.
/// A dwell of 347 days and a line that takes as long are computed period by period nowhere: each is its own
/// time, and four periods at most for speeding up and for whole periods at the ends.
TEST(LinuxCncModel, RunsLongDwellsAndSlowMovesAsQuicklyAsOthers) {
  constexpr double period = 0.001;
  constexpr double days = 3e7;  // [s]
  const std::string short_dwell = "G21 G90 G61\nG1 X10 F1000\nG4 P1\nX20\n";
  const std::string long_dwell = "G21 G90 G61\nG1 X10 F1000\nG4 P30000000\nX20\n";
  EXPECT_NEAR(run(long_dwell).duration() - run(short_dwell).duration(), days - 1, 1e-6);
  EXPECT_NEAR(run("G21 G90 G61\nG1 X500 F0.001\n").duration(), days, 4 * period);
}

TEST(LinuxCncModel, TakesItsModeFromTheSettingsWhereTheProgramHasNone) {
  const std::string moves = "G1 X20 F3000\nX40\nY20\nM2\n";
  for (const std::string mode : {"G61", "G61.1", "G64"}) {
    EXPECT_NEAR(run("G21 G90\n" + moves, mode).duration(), run("G21 G90 " + mode + "\n" + moves).duration(),
                1.5e-3)
        << mode;
  }
  EXPECT_GT(run("G21 G90\n" + moves, "G61.1").duration(), run("G21 G90\n" + moves, "G61").duration() + 0.04);
}

/// Flat arcs of a spline become lines, which run as fast as the axes allow where the program gives no feed.
TEST(LinuxCncModel, RunsAsFastAsTheAxesAllowWithoutAFeed) {
  for (const std::string motion : {"G1 X40 Y10", "G2 X40 Y0 I20 J0", "G5 X40 Y0 I5 J10 P-5 Q10"}) {
    const std::string start = "G21 G90 G17 G64 P0.1 Q0.1\nG0 X0 Y0 Z0\n";
    EXPECT_NEAR(run(start + motion + "\nM2\n").duration(),
                run(start + "F100000\n" + motion + "\nM2\n").duration(), 2e-3)
        << motion;
  }
}

/// Words behind a loop of another dialect are run once, those in it at every turn, as if it were unrolled.
TEST(LinuxCncModel, WaitsForWordsOfALoopAsOftenAsTheyAreRun) {
  const std::string turn = "G1 X10\nM8\nX0\nM9\n";
  std::string unrolled = "G21 G90\nM3 S1000\nF3000\n";
  std::string loop = unrolled + "#1=0\nWHILE [#1 LT 20] DO1\n" + turn + "#1=#1+1\nEND1\n";
  for (int i = 0; i < 20; ++i) {
    unrolled += turn;
  }
  const std::string end = "M5\nM9\nG0 Z10\nM30\n";
  EXPECT_NEAR(run(loop + end).duration(), run(unrolled + end).duration(), 1e-9);
}

/// The limit that sets the speed and the acceleration of an arc is named where a rotary axis sets it.
TEST(LinuxCncModel, NamesTheRotaryAxisThatSlowsAnArcDown) {
  SetupRequest request;
  request.machine = "five-axis-table-ac";
  request.model = "linuxcnc";
  const auto setup = make_setup(request);
  const LoadedProgram program = load_program(
      std::make_shared<const SourceText>("t.ngc", "G21 G90 G17\nG1 X1 F9000\nG2 X11 Y0 I5 J0 C720\nM2\n"),
      nullptr, reading_on({}, setup.machine));
  const Summary summary = simulate_run(program, setup).summary;
  const auto of = [&](CauseKind kind) {
    return summary.time_by_cause[cause_index({kind, static_cast<std::int8_t>(*cause_axes.find('C'))})];
  };
  EXPECT_GT(of(CauseKind::axis_velocity), 0.4 * summary.cycle_time);
  EXPECT_GT(of(CauseKind::axis_acceleration), 0);
}

/// P and Q of G64 in the program go before those of the settings unless program_tolerance is off; a Q that
/// the settings do not have stays that of the program.
TEST(LinuxCncModel, TakesTolerancesOfTheSettingsWhereThoseOfTheProgramAreOff) {
  const auto text = [](const std::string& g64) {
    return "G21 G90\n" + g64 + "\nG1 X20 F3000\nX40 Y0.01\nX60\nY20\nX80 Y20\nM2\n";
  };
  const auto with = [&](const std::string& g64, const std::vector<std::string>& settings) {
    return run(text(g64), "G64", settings).duration();
  };
  const std::string wide = "blend_tolerance_mm=0.4";
  const std::string off = "program_tolerance=off";
  const double fine = with("G64 P0.02", {});
  EXPECT_LT(with("G64 P0.4", {}), fine - 0.01);
  EXPECT_EQ(with("G64 P0.02", {wide}), fine);
  EXPECT_EQ(with("G64 P0.02", {wide, off}), with("G64 P0.4", {}));
  EXPECT_EQ(with("G64 P0.02 Q0", {wide, off}), with("G64 P0.4 Q0", {}));
  EXPECT_EQ(with("G64 P0.02 Q0", {wide, "naive_tolerance_mm=0.05", off}), with("G64 P0.4 Q0.05", {}));
  EXPECT_EQ(with("G61", {wide, off}), with("G61", {})) << "exact stops stay";
}

/// Where rotary axes turn beside a joint, neither of its blocks has half of its acceleration for the other's
/// sake. Times of the control itself on its table xyzac-trt (tests/oracle/table.ini), to the millisecond.
TEST(LinuxCncModel, TakesAsLongAsTheControlWhereBlocksWithAndWithoutRotaryAxesMeet) {
  const auto time = [](const std::string& text) {
    feedscope::Setup setup;
    setup.machine = import_machine(std::filesystem::path(FEEDSCOPE_SOURCE_DIR) / "tests/oracle/table.ini",
                                   machine_file_settings())
                        .machine;
    setup.model = &find_model("linuxcnc");
    setup.settings = complete_settings(*setup.model, setup.machine);
    const auto source = std::make_shared<const SourceText>("t.ngc", text);
    return simulate_run(load_program(source, nullptr, reading_on({}, setup.machine)), setup)
        .summary.cycle_time;
  };
  EXPECT_NEAR(time("G21 G90 G94 G17 G64\nG0 X20 Y5 Z4 A-10 C20\nG0 Z1\nG0 X20.05 Y5.1\nG1 Z-2 F3000\n"
                   "X40 Y12 A-20 C25\nX60 Y12 Z-3\nX61 Y12.5\nX61.5 Y13 A-21 C25.4\nX62 Y13.4 A-22 C26\n"
                   "Y40 C40\nY60\nX0 Z2\nG0 Z10\nX10 A0 C0\nZ20\nM2\n"),
              4.481, 1e-9);
  EXPECT_NEAR(time("G21 G90 G17 G64 P0.02\nG0 X-20 Y5 Z4 A-40 C120\nG0 Z1\nG93\n"
                   "G1 X-21 Y5.4 Z0 A-41 C121 F160\nX-22 Y6 Z-1 A-42.5 C122.4 F160\n"
                   "X-23.5 Y6.8 Z-1.6 A-43.1 C124 F160\nX-25 Y7.1 Z-2 F160\n"
                   "X-26.2 Y7.3 Z-2.1 A-44 C126 F320\nX-27 Y7.2 Z-2.1 A-45 C128.5 F320\n"
                   "X-27.4 Y7 Z-2 A-45.5 C130 F640\nG94\nX-40 Y0 F2000\nG0 Z20\nM2\n"),
              3.924, 1e-9);
}

/// A quarter of the way is their arc, in the air: it is no cutting.
TEST(LinuxCncModel, RoundsCornersBetweenRapidsAsRapids) {
  const Trajectory motion = run("G21 G90 G64\nG0 X50\nY50\nG1 X60 F3000\nM2\n");
  double rapid = 0;
  double cut = 0;
  std::size_t arcs = 0;
  for (std::uint32_t element = 0; element < motion.path().size(); ++element) {
    (motion.is_rapid(element) ? rapid : cut) += motion.path().length(element);
    arcs += motion.path().kind(element) == ElementKind::arc ? 1 : 0;
  }
  EXPECT_EQ(arcs, 1u);
  const double shorter = 2 - pi / 2;  // of the radius: the arc in place of the corner
  EXPECT_NEAR(rapid, 100 - 25 * shorter, 1e-6) << "the arc takes half of each block";
  EXPECT_NEAR(cut, 10, 1e-6);
}

TEST(LinuxCncModel, RoundsNothingUnderAnExactStop) {
  EXPECT_EQ(run("G21 G90 G61\nG1 X20 F3000\nY20\nM2\n").blend_count(), 0U);
}

/// An arc that the control puts into a corner of rapids has a direction at each place, not one as a line.
TEST(LinuxCncModel, ExplainsTheVelocityInACornerByTheArcThere) {
  const struct Setup setup = make_setup({.machine = "klipper-corexy", .model = "linuxcnc"});
  const auto text =
      std::make_shared<const SourceText>("test.ngc", "G21 G90 G64\nG0 X-70 Y-70 Z20\nG0 Z2\nG0 X0\nM2\n");
  const auto run = simulate_run(load_program(text), setup);
  const Trajectory& motion = *run.trajectory;
  int on_arcs = 0;
  for (int i = 0; i < 4000; ++i) {
    const State state = motion.state(motion.duration() * (i + 0.5) / 4000);
    const Formula formula = explain(run, state).reason.formula;
    if (formula.id != FormulaId::axis_velocity || !motion.path().curve(state.element).is_arc()) {
      continue;
    }
    ++on_arcs;
    const double part = formula.find(Symbol::tangent_part)->value;
    EXPECT_GT(part, 0.01) << state.time;
    EXPECT_LE(part, 1 + 1e-9) << state.time;
  }
  EXPECT_GT(on_arcs, 0);
}

/// A run says what of the control its model has not: rotary axes that turn alone, and waits for coolant.
TEST(LinuxCncLeavesOut, WhatItsRunsName) {
  const auto notes = [](const std::string& text, const std::string& model) {
    const struct Setup setup = make_setup({.machine = "five-axis-table-ac", .model = model});
    const LoadedProgram loaded = load_program(std::make_shared<const SourceText>("test.ngc", text));
    std::string all;
    for (const Remark& remark : remarks(simulate_run(loaded, setup))) {
      all += remark.text.english() + '\n';
    }
    return all;
  };
  const std::string plain = "G21 G64 P0.01\nG1 X10 F1000\n(no M8)\nM8000\nX20 ;M8\nM2\n";
  EXPECT_THAT(notes(plain, "linuxcnc"), Not(HasSubstr("coolant")));
  EXPECT_THAT(notes(plain, "linuxcnc"), Not(HasSubstr("turn alone")));
  const std::string both = "G21 G64 P0.01\nG1 X10 F1000\nM08\nA10\nX20\nM2\n";
  EXPECT_THAT(notes(both, "linuxcnc"), HasSubstr("coolant"));
  EXPECT_THAT(notes(both, "linuxcnc"), HasSubstr("turn alone"));
  EXPECT_THAT(notes(both, "essid"), Not(HasSubstr("coolant")));
}

}  // namespace
}  // namespace feedscope
