#include "core/analysis/load/load_sampler.h"

#include <gmock/gmock.h>

#include <cmath>

#include "core/analysis/run/run.h"

namespace feedscope {
namespace {

Engagement mill(const std::string& tool = "") {
  Engagement operation;
  operation.tool = tool;
  operation.diameter = 10;
  operation.teeth = 2;
  operation.radial_depth = 10;
  operation.axial_depth = 5;
  operation.material = "aluminium-7075-t6";
  return operation;
}

Run run_of(const std::string& text, const Engagement& operation, const char* model = "cam") {
  SetupRequest request;
  request.model = model;
  Setup setup = make_setup(request);
  setup.load.operations = {operation};
  return simulate_run(load_program(std::make_shared<const SourceText>("part.nc", text)), setup);
}

/// In the middle of the time of `line`.
LoadSample in_line(const Run& run, std::uint32_t line) {
  const Trajectory& motion = *run.trajectory;
  double from = -1;
  double to = 0;
  for (std::size_t i = 0; i < motion.pieces().size(); ++i) {
    if (motion.line_of(motion.pieces()[i].element) == line) {
      from = from < 0 ? motion.pieces()[i].time : from;
      to = motion.piece_end(i);
    }
  }
  LoadSampler sampler(*run.sources.load);
  return sampler.at(motion.state((from + to) / 2));
}

/// F 1200 mm/min over 6000/min and two teeth is 0.1 mm.
TEST(LoadSampler, OfASteadyFeedIsThatOfTheFeedPerTooth) {
  const auto run = run_of("G21\nS6000 M3\nG1 X100 F1200\n", mill());
  const LoadSample sample = in_line(run, 3);
  ASSERT_TRUE(sample.has_load());
  EXPECT_NEAR(sample.predicted.feed_per_tooth, 0.1, 1e-9);
  EXPECT_NEAR(sample.predicted.chip_thickness, 0.1, 1e-9);
  EXPECT_NEAR(sample.programmed.feed_per_tooth, 0.1, 1e-12);
  const auto figures = run.sources.load->model().operations()[0].force.at(0.1);
  EXPECT_NEAR(sample.predicted.peak_force, figures.peak, 1e-6);
  EXPECT_NEAR(sample.predicted.mean_force, std::hypot(figures.mean.x(), figures.mean.y()), 1e-6);
  EXPECT_NEAR(sample.predicted.torque, figures.torque, 1e-6);
  // torque times 2 pi 100/s
  EXPECT_NEAR(sample.predicted.power, figures.torque * 628.318530718, 1e-3);
}

/// Power is mean tangential force times cutting speed.
TEST(LoadSampler, PowerIsTangentialForceTimesCuttingSpeed) {
  const auto run = run_of("G21\nS6000 M3\nG1 X100 F1200\n", mill());
  const CuttingLoad load = in_line(run, 3).predicted;
  const double mean_tangential = load.torque / 5;
  EXPECT_NEAR(load.power, mean_tangential * 3.14159265358979 * 10 * 100, 1e-6 * load.power);
}

TEST(LoadSampler, SaysWhyThereIsNone) {
  const auto run = run_of(
      "G21\nT1 M6\nS6000 M3\nG0 X10\nG1 X50 F1000\nZ-20\nX90 Z-30\nG4 P1\nM5\nG1 X120\nT2 M6\nS500 "
      "M3\nX150\nM30\n",
      mill("1"));
  EXPECT_EQ(in_line(run, 4).state, LoadState::rapid);
  EXPECT_EQ(in_line(run, 5).state, LoadState::cutting);
  EXPECT_EQ(in_line(run, 6).state, LoadState::plunge);
  EXPECT_EQ(in_line(run, 7).state, LoadState::cutting);
  EXPECT_EQ(in_line(run, 8).state, LoadState::dwell);
  EXPECT_EQ(in_line(run, 10).state, LoadState::no_spindle);
  EXPECT_EQ(in_line(run, 13).state, LoadState::no_operation);
  EXPECT_EQ(in_line(run, 4).predicted.peak_force, 0);
}

/// Down a slope of 3 by 4 the feed across the axis is four fifths.
TEST(LoadSampler, CountsTheFeedAcrossTheAxis) {
  const auto run = run_of("G21\nS6000 M3\nG1 X80 Z-60 F1200\n", mill());
  EXPECT_NEAR(in_line(run, 3).predicted.feed_per_tooth, 0.08, 1e-9);
  EXPECT_NEAR(in_line(run, 3).programmed.feed_per_tooth, 0.08, 1e-12);
}

TEST(LoadSampler, AtRestHasNoChipAndNoDivisionByZero) {
  const auto run = run_of("G21\nS6000 M3\nG1 X80 F1200\n", mill(), "essid");
  LoadSampler sampler(*run.sources.load);
  const LoadSample sample = sampler.at(run.trajectory->state(0));
  ASSERT_TRUE(sample.has_load());
  EXPECT_EQ(sample.predicted.chip_thickness, 0);
  EXPECT_NEAR(sample.programmed.feed_per_tooth, 0.1, 1e-12);
  const LoadSample standing = [&] {
    const auto none = run_of("G21\nS0 M3\nG1 X80 F1200\n", mill());
    return in_line(none, 3);
  }();
  EXPECT_EQ(standing.state, LoadState::no_spindle);
}

}  // namespace
}  // namespace feedscope
