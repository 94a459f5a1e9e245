#include "core/analysis/envelope/envelope.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/support/parts.h"
#include "tests/ui/run_fixture.h"

namespace feedscope {
namespace {

constexpr int fine_samples = 400;

/// Lines and arcs of a few millimetres, seeded; no corner turns by more than 150 degrees.
std::string random_program(unsigned seed, int blocks) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> forward(2, 8);
  std::uniform_real_distribution<double> sideways(-7, 7);
  std::string text = "G21 G91 G94 F6000\n";
  for (int i = 0; i < blocks; ++i) {
    const std::string x = std::to_string(forward(random));
    const std::string y = std::to_string(sideways(random));
    text += i % 5 == 4 ? "G2 X" + x + " Y" + y + " R20\n" : "G1 X" + x + " Y" + y + "\n";
  }
  return text;
}

/// Extents found by looking at very many states.
MotionBand brute_force(const Trajectory& trajectory, double from, double to) {
  MotionBand band;
  for (const Part& part : feedscope::testing::parts_of(trajectory)) {
    const double begin = std::max(from, part.time) - part.time;
    const double end = std::min(to - part.time, part.duration);
    for (int k = 0; k <= fine_samples && end > begin; ++k) {
      band.add(feedscope::testing::state_in(trajectory, part, begin + (end - begin) * k / fine_samples));
    }
  }
  return band;
}

double tolerance_of(const Extent& overall) {
  return 0.02 * std::max({double{overall.max}, -double{overall.min}, 1e-6});
}

/// `band` holds all of `least` and nothing beyond `most`.
template <typename Least>
void expect_between(const Band& band, const Least& least, const Least& most, const Band& overall,
                    const std::string& place) {
  for (std::size_t i = 0; i < charted_of_motion.count; ++i) {
    const double tolerance = tolerance_of(overall.extents[i]);
    const Extent& extent = band.extents[i];
    const std::string where = place + " channel " + std::to_string(i);
    EXPECT_LE(double{extent.min}, double{least.extents[i].min} + tolerance) << where;
    EXPECT_GE(double{extent.max}, double{least.extents[i].max} - tolerance) << where;
    EXPECT_GE(double{extent.min}, double{most.extents[i].min} - tolerance) << where;
    EXPECT_LE(double{extent.max}, double{most.extents[i].max} + tolerance) << where;
  }
}

TEST(Envelope, AgreesWithBruteForceOnRandomPrograms) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    const std::string text = random_program(seed, 30);
    const auto run = test::simulate_text(text);
    const Envelope envelope(run.trajectory);
    const Band overall = envelope.overall();
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> anywhere(0, run.trajectory->duration());
    for (int i = 0; i < 20; ++i) {
      const auto [from, wide] = std::minmax({anywhere(random), anywhere(random)});
      const double to = i % 2 == 0 ? wide : from + (wide - from) / 100;
      const std::vector<double> times{from, to};
      const double beyond = (to - from) / 8;
      expect_between(envelope.columns(times).front(), brute_force(*run.trajectory, from, to),
                     brute_force(*run.trajectory, from - beyond, to + beyond), overall,
                     "seed " + std::to_string(seed) + " " + std::to_string(from) + ".." + std::to_string(to));
    }
  }
}

TEST(Envelope, NeighbouringColumnsAddUpToTheWhole) {
  const auto run = test::simulate_text(random_program(7, 200));
  const Envelope envelope(run.trajectory);
  std::vector<double> times;
  for (int i = 0; i <= 333; ++i) {
    times.push_back(run.trajectory->duration() * i / 333);
  }
  const std::vector<Band> columns = envelope.columns(times);
  ASSERT_EQ(columns.size(), 333U);
  Band sum;
  for (const Band& column : columns) {
    sum.add(column);
  }
  expect_between(sum, envelope.overall(), envelope.overall(), envelope.overall(), "sum");
}

TEST(Envelope, StraightBlockAtItsFeedIsExact) {
  // 100 mm along X at 6000 mm/min: X moves at 100 mm/s, nothing accelerates.
  const auto run = test::simulate_text("G21 G90 F6000\nG1 X100\n", "cam");
  const Envelope envelope(run.trajectory);
  const std::vector<double> times{0.2, 0.4};
  const Band column = envelope.columns(times).front();
  EXPECT_FLOAT_EQ(column[QuantityId::velocity_x].min, 100);
  EXPECT_FLOAT_EQ(column[QuantityId::velocity_x].max, 100);
  EXPECT_FLOAT_EQ(column[QuantityId::feed].max, 100);
  EXPECT_FLOAT_EQ(column[QuantityId::programmed_feed].max, 100);
  EXPECT_FLOAT_EQ(column[QuantityId::velocity_y].max, 0);
  EXPECT_FLOAT_EQ(column[QuantityId::acceleration_x].max, 0);
}

TEST(Envelope, FullCircleReachesBothSignsOfTheFeedInOnePiece) {
  const auto run = test::simulate_text("G21 G90 F6000\nG2 X0 Y0 I10 J0\n", "cam");
  const Band band = Envelope(run.trajectory).overall();
  EXPECT_NEAR(band[QuantityId::velocity_x].min, -100, 0.4);
  EXPECT_NEAR(band[QuantityId::velocity_x].max, 100, 0.4);
  EXPECT_NEAR(band[QuantityId::velocity_y].max, 100, 0.4);
}

TEST(Envelope, ColumnsOutsideTheRunAreEmpty) {
  const auto run = test::simulate_text(test::small_program);
  const Envelope envelope(run.trajectory);
  const double end = run.trajectory->duration();
  const std::vector<double> times{-2, -1, 0, end, end + 1, end + 2};
  const std::vector<Band> columns = envelope.columns(times);
  EXPECT_TRUE(columns[0][QuantityId::feed].empty());
  EXPECT_FALSE(columns[2][QuantityId::feed].empty());
  EXPECT_TRUE(columns[4][QuantityId::feed].empty());
}

TEST(Envelope, OfNothingIsEmpty) {
  EXPECT_TRUE(Envelope().overall()[QuantityId::feed].empty());
  const Envelope still(std::make_shared<const Trajectory>());
  EXPECT_TRUE(still.overall()[QuantityId::feed].empty());
  const std::vector<double> times{0, 1};
  EXPECT_TRUE(still.columns(times).front()[QuantityId::feed].empty());
}

TEST(Envelope, HasNothingOfDrivesWithoutThem) {
  const auto run = test::simulate_text(test::small_program);
  const Envelope envelope(run.trajectory);
  EXPECT_FALSE(envelope.has(QuantitySource::drives));
  EXPECT_TRUE(envelope.overall()[QuantityId::following_error_x].empty());
}

/// All axes without feed-forward, X slower than the others.
RunSources with_drives(const Run& run) {
  Machine machine = run.setup.machine;
  for (const char axis : {'X', 'Y', 'Z'}) {
    set_axis_value(machine, axis, "kv", axis == 'X' ? 40.0 : 60.0);
    set_axis_value(machine, axis, "velocity_lag", 3.0);
  }
  RunSources sources;
  sources.actual = std::make_shared<const ActualPath>(run.trajectory, machine);
  return sources;
}

TEST(Envelope, SteadyFollowingErrorIsVelocityOverGain) {
  // 100 mm/s over a gain of 40 1/s leave the axis 2.5 mm behind, along the path.
  const auto run = test::simulate_text("G21 G90 F6000\nG1 X100\n", "cam");
  const Envelope envelope(run.trajectory, with_drives(run));
  ASSERT_TRUE(envelope.has(QuantitySource::drives));
  const std::vector<double> times{0.6, 0.8};
  const Band column = envelope.columns(times).front();
  EXPECT_NEAR(column[QuantityId::following_error_x].min, 2.5, 1e-5);
  EXPECT_NEAR(column[QuantityId::following_error_x].max, 2.5, 1e-5);
  EXPECT_NEAR(column[QuantityId::following_error_across].max, 0, 1e-9);
  EXPECT_EQ(column[QuantityId::following_error_y].max, 0);
}

TEST(Envelope, OfDrivesHoldsWhatEveryInstantHasAndLittleMore) {
  const auto run = test::simulate_text(random_program(5, 60));
  const RunSources sources = with_drives(run);
  const Envelope envelope(run.trajectory, sources);
  const double duration = run.trajectory->duration();
  std::mt19937 random(5);
  std::uniform_real_distribution<double> anywhere(0, duration);
  for (int i = 0; i < 12; ++i) {
    const auto [from, wide] = std::minmax({anywhere(random), anywhere(random)});
    const double to = i % 2 == 0 ? wide : from + (wide - from) / 100;
    DriveBand least;
    DriveBand most;
    const double beyond = (to - from) / 8;
    for (int k = -500; k <= 4500; ++k) {
      const double time = from + (to - from) * k / 4000;
      if (time < 0 || time > duration || time < from - beyond || time > to + beyond) {
        continue;
      }
      const State state = run.trajectory->state(time);
      const ActualSample sample = sources.actual->at(state);
      most.add(Instant(state, &sample));
      if (k >= 0 && k <= 4000) {
        least.add(Instant(state, &sample));
      }
    }
    const std::vector<double> times{from, to};
    const Band column = envelope.columns(times).front();
    for (std::size_t q = 0; q < charted_of_drives.count; ++q) {
      const Extent& extent = column.extents[charted_of_drives.index + q];
      const double tolerance = tolerance_of(most.extents[q]);
      EXPECT_LE(double{extent.min}, double{least.extents[q].min} + tolerance) << q;
      EXPECT_GE(double{extent.max}, double{least.extents[q].max} - tolerance) << q;
      EXPECT_GE(double{extent.min}, double{most.extents[q].min} - tolerance) << q;
      EXPECT_LE(double{extent.max}, double{most.extents[q].max} + tolerance) << q;
    }
  }
}

/// One tool over all feed motions.
RunSources with_load(const Run& run) {
  Engagement operation;
  operation.diameter = 10;
  operation.teeth = 2;
  operation.radial_depth = 3;
  operation.axial_depth = 4;
  operation.material = "aluminium-7075-t6";
  operation.spindle_speed = 100;
  RunSources sources;
  sources.load = std::make_shared<const RunLoad>(run.trajectory,
                                                 LoadModel({{operation}, {}}, *run.input.program, *run.path));
  return sources;
}

TEST(Envelope, SteadyChipThicknessFollowsFromTheFeed) {
  // 100 mm/s over 100 turns a second and two teeth: 0.5 mm a tooth; largest chip at the border of 3 mm of 10.
  const auto run = test::simulate_text("G21 G90 F6000\nG1 X100\n", "cam");
  const Envelope envelope(run.trajectory, with_load(run));
  ASSERT_TRUE(envelope.has(QuantitySource::load));
  const std::vector<double> times{0.6, 0.8};
  const Band column = envelope.columns(times).front();
  const double thickest = 0.5 * std::sin(std::acos(1 - 2 * 0.3));
  EXPECT_NEAR(column[QuantityId::chip_thickness].min, thickest, 1e-6);
  EXPECT_NEAR(column[QuantityId::chip_thickness_programmed].max, thickest, 1e-6);
  EXPECT_FALSE(envelope.has(QuantitySource::drives));
  EXPECT_TRUE(column[QuantityId::following_error_x].empty());
}

TEST(Envelope, OfTheLoadHoldsWhatEveryInstantHas) {
  const auto run = test::simulate_text(random_program(7, 60));
  const RunSources sources = with_load(run);
  const Envelope envelope(run.trajectory, sources);
  const double duration = run.trajectory->duration();
  std::mt19937 random(7);
  std::uniform_real_distribution<double> anywhere(0, duration);
  for (int i = 0; i < 12; ++i) {
    const auto [from, wide] = std::minmax({anywhere(random), anywhere(random)});
    const double to = i % 2 == 0 ? wide : from + (wide - from) / 100;
    LoadBand least;
    InstantSampler sampler(sources, from);
    for (int k = 0; k <= 4000; ++k) {
      const State state = run.trajectory->state(from + (to - from) * k / 4000);
      least.add(sampler.at(state));
    }
    const std::vector<double> times{from, to};
    const Band column = envelope.columns(times).front();
    for (std::size_t q = 0; q < charted_of_load.count; ++q) {
      if (least.extents[q].empty()) {
        continue;  // rapids
      }
      const Extent& extent = column.extents[charted_of_load.index + q];
      EXPECT_LE(double{extent.min}, double{least.extents[q].min} + tolerance_of(least.extents[q])) << q;
      EXPECT_GE(double{extent.max}, double{least.extents[q].max} - tolerance_of(least.extents[q])) << q;
    }
  }
}

TEST(PartLooks, AreInOrderAndHoldTheTurnOfTheFeed) {
  const auto run = test::simulate_text(random_program(3, 40));
  std::size_t turns = 0;
  for (PartWalk walk(*run.trajectory); !walk.done(); walk.next()) {
    const Part& part = walk.part();
    const PartMotion motion = walk.motion();
    const PartLooks looks(*run.trajectory, part, motion.curve());
    EXPECT_DOUBLE_EQ(looks.at(0), part.time);
    EXPECT_NEAR(looks.at(looks.count() - 1), part.time + part.duration, 1e-9);
    bool has_turn = false;
    const double turn = part.j != 0 ? part.time - part.a / part.j : -1;
    for (int k = 0; k < looks.count(); ++k) {
      EXPECT_TRUE(k == 0 || looks.at(k) >= looks.at(k - 1));
      has_turn = has_turn || std::abs(looks.at(k) - turn) < 1e-12;
    }
    if (turn > part.time && turn < part.time + part.duration) {
      EXPECT_TRUE(has_turn);
      ++turns;
    }
    const double middle = part.time + part.duration / 3;
    const int next = looks.first_after(middle);
    EXPECT_TRUE(next == looks.count() || looks.at(next) > middle);
    EXPECT_TRUE(next == 0 || looks.at(next - 1) <= middle);
  }
  EXPECT_GT(turns, 0U);
}

TEST(Envelope, StopsWhenCancelled) {
  const auto run = test::simulate_text(test::small_program);
  Progress progress;
  progress.cancel();
  EXPECT_THROW(Envelope(run.trajectory, {}, &progress), Cancelled);
}

}  // namespace
}  // namespace feedscope
