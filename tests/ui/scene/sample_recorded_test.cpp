#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "core/analysis/agreement/agreement.h"
#include "tests/ui/run_fixture.h"
#include "ui/scene/sampled_path.h"

namespace feedscope::ui {
namespace {

constexpr double step = 2e-3;          // [s]
constexpr double found_within = 2e-3;  // of the place of the whole trace: corners pull it inwards [mm]

/// A run of a program with a right angle and a half circle, recorded without noise.
class SampleRecorded : public testing::Test {
 protected:
  SampledPath sample(const Trace& trace) const {
    const ProgrammedCourse course(toolpath(), {trace.has(0), trace.has(1), trace.has(2)});
    const double deviation = deviation_of(*run_.trajectory, course, 1e-3);
    return sample_recorded(find_on_program(trace, course, deviation), course, toolpath());
  }
  Trace recorded() const {
    const MotionRecord record = record_of(*run_.trajectory, step);
    Trace trace;
    trace.period = step;
    trace.time = record.time;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const Vec3& place : record.place) {
        trace.place[axis].push_back(place[static_cast<Eigen::Index>(axis)]);
      }
    }
    return trace;
  }
  const Toolpath& toolpath() const { return *run_.path; }

  const feedscope::Run run_ =
      test::simulate_text("G21 G17 G90\nG0 X0 Y0 Z0\nG1 X20 F3000\nY20\nG3 X0 Y20 I-10 J0\nM30\n");
};

TEST_F(SampleRecorded, PlacesAreTheRecordedOnesAndDeviationsThoseOfTheRun) {
  const SampledPath path = sample(recorded());
  ASSERT_GT(path.size(), 100U);
  double largest = 0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Vec3 of_run = run_.trajectory->state(path.times[i]).position;
    EXPECT_LT((path.position(i) - of_run).norm(), found_within);
    largest = std::max(largest, path.deviation(i).norm());
  }
  // Along the bisector of the right angle; the samples lie beside its middle.
  EXPECT_NEAR(largest, std::numbers::sqrt2 * run_.summary.max_contour_error, 4e-3);
}

TEST_F(SampleRecorded, WhatDoesNotFitIsAGap) {
  Trace trace = recorded();
  const std::size_t from = trace.time.size() / 3;
  for (std::size_t i = from; i < from + 20; ++i) {
    trace.place[2][i] += 5;
  }
  const SampledPath path = sample(trace);
  const auto gaps = std::ranges::count(path.kinds, SpanKind::gap);
  EXPECT_EQ(gaps, 2) << "the end is one too";
  for (std::size_t i = 0; i < path.size(); ++i) {
    EXPECT_LT(path.position(i).z(), 1);
  }
}

TEST_F(SampleRecorded, AnAxisThatIsNotRecordedIsWhereTheProgramHasIt) {
  Trace trace = recorded();
  trace.place[2].clear();
  const SampledPath path = sample(trace);
  ASSERT_GT(path.size(), 100U);
  for (std::size_t i = 0; i < path.size(); ++i) {
    EXPECT_DOUBLE_EQ(path.position(i).z(), 0);
  }
}

}  // namespace
}  // namespace feedscope::ui
