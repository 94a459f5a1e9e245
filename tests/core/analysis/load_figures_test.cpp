#include "core/analysis/load/load_figures.h"

#include <gmock/gmock.h>

#include <numeric>
#include <random>

#include "core/analysis/load/load_sampler.h"
#include "core/analysis/run/run.h"
#include "core/base/error.h"
#include "tests/support/folders.h"

namespace feedscope {
namespace {

constexpr std::size_t chip = 1;
constexpr std::size_t peak = 3;

Engagement mill() {
  Engagement operation;
  operation.diameter = 12;
  operation.teeth = 2;
  operation.helix = 0.5;
  operation.radial_depth = 3;
  operation.axial_depth = 6;
  operation.material = "aluminium-7075-t6";
  operation.spindle_speed = 8000.0 / 60;
  return operation;
}

Run run_of(LoadedProgram program, const std::vector<Engagement>& operations, const char* model = "essid") {
  SetupRequest request;
  request.model = model;
  request.tolerance = 0.02;
  Setup setup = make_setup(request);
  setup.load.operations = operations;
  return simulate_run(program, setup);
}

Run run_of_text(const std::string& text, const std::vector<Engagement>& operations,
                const char* model = "essid") {
  return run_of(load_program(std::make_shared<const SourceText>("part.nc", text)), operations, model);
}

/// The corner of Ward 2021, case 4, in shape: at the programmed feed the force would be the same everywhere;
/// slowed down, it falls where the control brakes.
TEST(LoadFigures, ForceFallsWhereTheControlSlowsDown) {
  const auto run = run_of_text("G21\nG1 X20 F3000\nY20\n", {mill()});
  const LoadFigures& load = run.summary.load.value();
  EXPECT_NEAR(load.all.cutting_time, run.trajectory->duration(), 1e-9);
  const LoadFigureList& predicted = load.all.predicted;
  const LoadFigureList& programmed = load.all.programmed;
  EXPECT_NEAR(programmed[peak].mean, programmed[peak].largest, 1e-6 * programmed[peak].largest);
  EXPECT_LT(predicted[peak].mean, 0.9 * programmed[peak].mean);
  EXPECT_LE(predicted[peak].largest, programmed[peak].largest * (1 + 1e-9));
  LoadSampler sampler(*run.sources.load);
  double least = 1e9;
  for (int i = 1; i < 1000; ++i) {
    const State state = run.trajectory->state(run.trajectory->duration() * i / 1000);
    if (std::abs(state.position.x() - 20) < 0.05 && state.position.y() < 0.05) {
      least = std::min(least, sampler.at(state).predicted.peak_force);
    }
  }
  EXPECT_LT(least, 0.8 * programmed[peak].largest);
}

/// Mean chip over the time is path over time: f_z mean = length/(time n z).
TEST(LoadFigures, MeanFeedPerToothIsPathOverTime) {
  const auto run = run_of_text("G21\nG1 X20 F3000\nY20\nX0\nG2 X0 Y0 J-10\n", {mill()});
  const LoadFigures& load = run.summary.load.value();
  const double expected = run.trajectory->path_length() / run.trajectory->duration() / (8000.0 / 60 * 2);
  EXPECT_NEAR(load.all.predicted[0].mean, expected, 1e-6 * expected);
  EXPECT_NEAR(load.all.programmed[0].mean, 3000.0 / 8000 / 2, 1e-9);
}

TEST(LoadFigures, ReportsThinChipsAtStartCornerAndEnd) {
  Engagement operation = mill();
  operation.least_chip = 0.02;
  const auto run = run_of_text("G21 G61\nG1 X20 F3000\nY20\nM30\n", {operation});
  const LoadFigures& load = run.summary.load.value();
  ASSERT_EQ(load.limits.size(), 1U);
  const LimitFigures& thin = load.limits[0];
  EXPECT_EQ(thin.limit, LoadLimit::least_chip);
  ASSERT_EQ(thin.count, 3U) << "rest at start, exact stop and end";
  EXPECT_EQ(thin.places[0].from, 0);
  EXPECT_EQ(thin.places[0].worst, 0);
  EXPECT_EQ(thin.places[1].first_line, 2U);
  EXPECT_EQ(thin.places[1].last_line, 3U);
  EXPECT_NEAR(thin.places[2].to, run.trajectory->duration(), 1e-9);
  EXPECT_EQ(thin.programmed_time, 0);
  // At both ends of every place that is not an end of the run the chip has its least thickness.
  LoadSampler sampler(*run.sources.load);
  EXPECT_NEAR(sampler.at(run.trajectory->state(thin.places[0].to)).predicted.chip_thickness, 0.02, 1e-5);
  EXPECT_NEAR(sampler.at(run.trajectory->state(thin.places[1].from)).predicted.chip_thickness, 0.02, 1e-5);
}

TEST(LoadFigures, ReportsBoundsThatTheProgrammedFeedPasses) {
  Engagement operation = mill();
  const auto free = run_of_text("G21\nG1 X20 F3000\nY20\n", {operation});
  const double programmed = free.summary.load->all.programmed[peak].largest;
  operation.max_force = 0.99 * programmed;
  operation.max_power = 1e9;
  const auto bounded = run_of_text("G21\nG1 X20 F3000\nY20\n", {operation});
  const std::vector<LimitFigures>& limits = bounded.summary.load->limits;
  ASSERT_EQ(limits.size(), 2U);
  EXPECT_EQ(key_of(limits[0].limit), "max_force_n");
  EXPECT_NEAR(limits[0].programmed_time, bounded.trajectory->duration(), 1e-9);
  EXPECT_LT(limits[0].time, 0.9 * limits[0].programmed_time);
  EXPECT_EQ(limits[1].count, 0U);
}

TEST(LoadFigures, OfATrochoidHaveLessForceThanProgrammed) {
  SetupRequest request;
  request.machine = "dmg-mori-evo40";
  auto setup = make_setup(request);
  setup.load = read_load_file(FEEDSCOPE_SOURCE_DIR "/resources/examples/trochoidal_slot_load.toml");
  const auto run =
      simulate_run(load_program(FEEDSCOPE_SOURCE_DIR "/resources/programs/trochoidal_slot.nc"), setup);
  const LoadFigures& load = run.summary.load.value();
  EXPECT_LT(load.all.predicted[peak].mean, 0.8 * load.all.programmed[peak].mean);
  EXPECT_LT(load.all.predicted[peak].largest, load.all.programmed[peak].largest);
  EXPECT_GT(load.time[static_cast<std::size_t>(LoadState::no_operation)], 10) << "the ways back";
  EXPECT_GT(load.limits.at(1).programmed_time, 0.99 * load.all.cutting_time);
  EXPECT_EQ(load.limits.at(1).time, 0);
}

TEST(LoadFigures, ProgramsThatTheLoadFileDoesNotFitAreRefused) {
  Engagement operation = mill();
  operation.tool = "9";
  EXPECT_THAT([&] { run_of_text("G21\nG1 X20 F3000\n", {operation}); },
              testing::ThrowsMessage<InputError>(testing::HasSubstr("changes to no tool")));
}

/// Times add up, peaks bound means, force grows with feed, thin chips are thin: whatever the program.
TEST(LoadFigures, HoldOnRandomPrograms) {
  std::mt19937 random(21);
  std::uniform_real_distribution<double> place(-20, 20);
  std::uniform_int_distribution<int> kind(0, 7);
  for (int i = 0; i < 20; ++i) {
    std::string text = "G21 G90\nT1 M6\nS6000 M3\n";
    for (int block = 0; block < 40; ++block) {
      const auto word = [&](char axis) { return axis + std::to_string(place(random)) + " "; };
      switch (kind(random)) {
        case 0:
          text += "G0 " + word('X') + word('Y') + "\n";
          break;
        case 1:
          text += "G1 " + word('Z') + "F500\n";
          break;
        case 2:
          text += "G4 P0.1\n";
          break;
        case 3:
          text += block % 2 == 0 ? "M5\n" : "M3 S4000\n";
          break;
        default:
          text += "G1 " + word('X') + word('Y') + "F" + std::to_string(500 + 100 * (block % 30)) + "\n";
      }
    }
    Engagement operation = mill();
    operation.least_chip = 0.01;
    operation.max_force = 200;
    operation.lines = {{1, 30}};
    const auto run = run_of_text(text, {operation}, i % 3 == 0 ? "cam" : i % 3 == 1 ? "essid" : "ward");
    const LoadFigures& load = run.summary.load.value();
    const double sum = std::accumulate(load.time.begin(), load.time.end(), 0.0);
    EXPECT_NEAR(sum, run.trajectory->duration(), 1e-6) << text;
    EXPECT_NEAR(load.time[0], load.all.cutting_time, 1e-9) << text;
    for (const LoadFigureList* list : {&load.all.predicted, &load.all.programmed}) {
      for (const LoadFigure& figure : *list) {
        EXPECT_GE(figure.largest * (1 + 1e-9), figure.mean) << text;
        EXPECT_GE(figure.mean, 0) << text;
      }
    }
    for (const LimitFigures& limit : load.limits) {
      EXPECT_LE(limit.time, load.all.cutting_time + 1e-9) << text;
      double places = 0;
      for (const LoadPlace& one : limit.places) {
        places += one.to - one.from;
        EXPECT_LE(one.first_line, one.last_line);
        EXPECT_GE(one.first_line, 1U);
        EXPECT_LE(one.last_line, 30U);
      }
      EXPECT_NEAR(places, limit.time, 1e-6) << text;
    }
    // Against many samples.
    LoadSampler sampler(*run.sources.load);
    double largest = 0;
    for (int k = 0; k <= 2000; ++k) {
      const LoadSample sample = sampler.at(run.trajectory->state(run.trajectory->duration() * k / 2000));
      largest = std::max(largest, sample.predicted.chip_thickness);
    }
    EXPECT_GE(load.all.predicted[chip].largest * (1 + 1e-4) + 1e-9, largest) << text;
  }
}

}  // namespace
}  // namespace feedscope
