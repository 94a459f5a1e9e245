#include "core/analysis/contour/contour_errors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numeric>
#include <random>

#include "core/analysis/contour/contour_histogram.h"
#include "core/analysis/contour/contour_report.h"
#include "core/analysis/contour/contour_search.h"
#include "core/analysis/contour/path_deviation.h"
#include "core/analysis/run/run.h"
#include "core/trajectory/part_walk.h"
#include "tests/support/folders.h"
#include "tests/support/paths.h"

namespace feedscope {
namespace {

using testing::polyline;
using testing::random_path;

Trajectory run(const Toolpath& path, const std::string& model, double tolerance,
               const std::vector<std::pair<std::string, SettingValue>>& more = {}) {
  const ControlModel& control = find_model(model);
  const Machine machine = testing::spinner();
  Settings settings = complete_settings(control, machine);
  settings.set("contour_tolerance_mm", tolerance);
  for (const auto& [key, value] : more) {
    settings.set(key, value);
  }
  return control.simulate(path, machine, settings);
}

double largest_contour_error(const Trajectory& trajectory) {
  ContourRequest request;
  request.places = 1;
  return contour_errors(trajectory, request).largest;
}

/// Largest distance from the programmed path of `count` instants of every part.
double sampled_error(const Trajectory& trajectory, int count) {
  PathDeviation deviation(*trajectory.path().programmed());
  double largest = 0;
  for (PartWalk walk(trajectory); !walk.done(); walk.next()) {
    const PartMotion motion = walk.motion();
    for (int i = 0; i <= count; ++i) {
      const Vec3 at = motion.kinematics(walk.part().duration * i / count).position;
      const auto segment = trajectory.path().segment(walk.part().element);
      largest = std::max(largest, deviation(at, segment).nearest.norm());
    }
  }
  return largest;
}

Toolpath corner(double turn) {
  return polyline({{0, 0, 0}, {20, 0, 0}, Vec3(20 + 20 * std::cos(turn), 20 * std::sin(turn), 0)}, 50);
}

class ContourErrorOfCorners : public ::testing::TestWithParam<const char*> {};

TEST_P(ContourErrorOfCorners, IsTheDistanceOfTheMiddleFromBothLines) {
  for (const double turn : {0.1, 0.7, 1.5707963, 2.2, 3.0}) {
    const Trajectory trajectory = run(corner(turn), GetParam(), 0.05);
    const BlendRecord blend = trajectory.blend(0);
    const ContourErrors errors = contour_errors(trajectory);
    EXPECT_NEAR(errors.largest, blend.epsilon * std::cos(turn / 2), 1e-12) << turn;
    EXPECT_EQ(errors.uncertainty, 0);
    EXPECT_NEAR(errors.largest, sampled_error(trajectory, 3000), 1e-5) << turn;
    EXPECT_GE(errors.largest, sampled_error(trajectory, 3000) - 1e-12) << turn;
    ASSERT_EQ(errors.worst.size(), 1u);
    const ContourPlace& place = errors.worst[0];
    EXPECT_NEAR((place.position - blend.corner).norm(), blend.epsilon, 1e-9);
    EXPECT_NEAR((place.position - place.programmed).norm(), place.error, 1e-12);
    EXPECT_NEAR((trajectory.state(place.time).position - place.position).norm(), 0, 1e-9);
    EXPECT_NEAR(place.side, place.error, 1e-12) << "a left turn is cut on its left side";
  }
}

TEST_P(ContourErrorOfCorners, IsRightOfATurnToTheRight) {
  const ContourErrors errors = contour_errors(run(corner(-1), GetParam(), 0.05));
  ASSERT_EQ(errors.worst.size(), 1u);
  EXPECT_NEAR(errors.worst[0].side, -errors.largest, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Models, ContourErrorOfCorners, ::testing::Values("essid", "gassara", "msaddek"),
                         [](const auto& test) { return std::string(test.param); });

TEST(ContourErrors, OfAModelThatFollowsExactlyAreNone) {
  std::mt19937 random(2);
  const Toolpath path = random_path(random, 40);
  const Machine machine = testing::spinner();
  for (const char* id : {"cam", "tapie"}) {
    const ControlModel& model = find_model(id);
    ContourRequest request;
    request.bins = ContourBins::sides;
    const Trajectory trajectory = model.simulate(path, machine, complete_settings(model, machine));
    const ContourErrors errors = contour_errors(trajectory, request);
    EXPECT_EQ(errors.largest, 0);
    EXPECT_TRUE(errors.worst.empty());
    const auto& length = errors.histogram.length;
    EXPECT_NEAR(length[length.size() / 2], trajectory.path_length(), 1e-9) << "the bin around 0";
  }
}

TEST(ContourErrors, OfArcsThatAControlLaysInCornersMatchFineSampling) {
  const ControlModel& control = find_model("linuxcnc");
  const Machine machine = testing::spinner();
  for (const double tolerance : {0.0, 0.2}) {
    Settings settings = complete_settings(control, machine);
    settings.set("blend_tolerance_mm", tolerance);
    const Trajectory trajectory = control.simulate(corner(1.2), machine, settings);
    const double largest = largest_contour_error(trajectory);
    EXPECT_GT(largest, 0.05) << tolerance;
    EXPECT_NEAR(largest, sampled_error(trajectory, 20000), 3e-5) << tolerance;
  }
}

TEST(ContourErrors, OfNothingAreNone) {
  EXPECT_EQ(contour_errors({}).largest, 0);
}

/// On random paths no sample is farther than what is found, and fine sampling comes close to it.
void expect_to_match_samples(const std::string& model,
                             const std::vector<std::pair<std::string, SettingValue>>& settings) {
  std::mt19937 random(11);
  for (int i = 0; i < 25; ++i) {
    SCOPED_TRACE(model + " " + std::to_string(i));
    const Trajectory trajectory = run(random_path(random, 1 + 3 * i), model, 0.02, settings);
    const ContourErrors errors = contour_errors(trajectory);
    EXPECT_LE(errors.uncertainty, 2e-6);
    const double sampled = sampled_error(trajectory, 400);
    EXPECT_GE(errors.largest, sampled - 2e-6);
    EXPECT_LE(errors.largest, sampled + 2e-5 + 0.01 * sampled);
    EXPECT_NEAR(largest_contour_error(trajectory), errors.largest, 2e-6);
    for (const ContourPlace& place : errors.worst) {
      EXPECT_NEAR((trajectory.state(place.time).position - place.position).norm(), 0, 1e-6);
      EXPECT_LE(std::abs(place.side), place.error + 1e-9);
    }
  }
}

TEST(ContourErrors, OfFilteredMotionMatchFineSampling) {
  expect_to_match_samples("ward", {{"filters", 2.0}});
  expect_to_match_samples("ward", {{"filters", 3.0}});
}

TEST(ContourErrors, OfCompactedPathsMatchFineSampling) {
  expect_to_match_samples("msaddek", {{"compaction_mm", 20.0}});
}

TEST(ContourErrors, OfAFittedPathAreThoseOfItsMotion) {
  std::mt19937 random(5);
  for (int i = 0; i < 6; ++i) {
    const Toolpath path = random_path(random, 4 + 4 * i);
    const double filtered = largest_contour_error(run(path, "ward", 0.02));
    const double fitted = largest_contour_error(run(path, "optimal", 0.02, {{"path", "ward"}}));
    EXPECT_NEAR(fitted, filtered, 4e-6) << i;
  }
}

TEST(ContourErrors, WorstPlacesAreApart) {
  std::vector<Vec3> points{{0, 0, 0}};
  for (int i = 1; i <= 12; ++i) {  // right angles to the left and to the right
    points.emplace_back(points.back() + (i % 2 == 1 ? Vec3(5, 0, 0) : Vec3(0, 5, 0)));
  }
  for (const char* model : {"essid", "ward"}) {
    ContourRequest request;
    request.places = 6;
    const ContourErrors errors = contour_errors(run(polyline(points, 50), model, 0.02), request);
    ASSERT_EQ(errors.worst.size(), 6u) << model;
    for (std::size_t i = 0; i < errors.worst.size(); ++i) {
      EXPECT_GT(errors.worst[i].error, 0);
      if (i > 0) {
        EXPECT_LE(errors.worst[i].error, errors.worst[i - 1].error);
      }
      for (std::size_t k = 0; k < i; ++k) {
        EXPECT_GT((errors.worst[i].position - errors.worst[k].position).norm(), 4) << model;
      }
    }
  }
}

TEST(ContourErrors, OfAllPartsOfAPathHoldThatOfTheWhole) {
  std::mt19937 random(3);
  for (const char* model : {"essid", "ward", "msaddek"}) {
    const Trajectory trajectory = run(random_path(random, 60), model, 0.02);
    const auto elements = static_cast<std::uint32_t>(trajectory.path().size());
    double largest = 0;
    for (std::uint32_t first = 0; first < elements; first += 7) {
      ContourRequest request;
      request.first_element = first;
      request.last_element = first + 7;
      largest = std::max(largest, contour_errors(trajectory, request).largest);
    }
    EXPECT_NEAR(largest, contour_errors(trajectory).largest, 2e-6) << model;
  }
}

TEST(ContourErrors, HistogramsCountThePathLength) {
  std::mt19937 random(8);
  const Toolpath path = random_path(random, 50);
  for (const char* model : {"essid", "ward", "msaddek"}) {
    const Trajectory trajectory = run(path, model, 0.02);
    for (const ContourBins bins : {ContourBins::sides, ContourBins::amounts, ContourBins::logarithmic}) {
      ContourRequest request;
      request.bins = bins;
      const ContourErrors errors = contour_errors(trajectory, request);
      const ContourHistogram& histogram = errors.histogram;
      ASSERT_EQ(histogram.edges.size(), histogram.length.size() + 1);
      EXPECT_TRUE(std::ranges::is_sorted(histogram.edges));
      EXPECT_GE(histogram.edges.back(), errors.largest * (1 - 1e-9));
      EXPECT_NEAR(std::accumulate(histogram.length.begin(), histogram.length.end(), 0.0),
                  trajectory.path_length(), 1e-3 * trajectory.path_length());
      EXPECT_GT(histogram.length[bins == ContourBins::sides ? histogram.length.size() / 2 : 0], 0);
    }
  }
}

/// Blocks that the control joins with almost nothing between two arcs: an element without length has no
/// direction, and one place that is not a number spoilt all lengths.
TEST(ContourErrors, HistogramsOfDenseBlocksCountThePathLength) {
  const feedscope::Run dense = simulate_run(
      load_program(std::filesystem::path(FEEDSCOPE_SOURCE_DIR "/resources/programs/freeform_finish.nc")),
      make_setup({"", "linuxcnc", {}, {}}));
  const BlendedPath& path = dense.trajectory->path();
  for (std::size_t i = 0; i < path.size(); ++i) {
    ASSERT_TRUE(path.curve(i).start.allFinite() && path.curve(i).end.allFinite()) << i;
  }
  ContourRequest request;
  request.bins = ContourBins::amounts;
  const ContourErrors errors = contour_errors(*dense.trajectory, request);
  const std::vector<double>& lengths = errors.histogram.length;
  EXPECT_NEAR(std::accumulate(lengths.begin(), lengths.end(), 0.0), path.length(), 1e-3 * path.length());
}

/// Corners between rapids are cut by millimetres, those of the part by hundredths.
feedscope::Run run_with_rapids() {
  return simulate_run(
      load_program(std::make_shared<const SourceText>("test.ngc",
                                                      "G21 G90 G64\nG0 X50 Z5\nG0 Y50\nG0 X0\nG64 P0.02\nG1 "
                                                      "Z0 F3000\nX40\nY90\nG64\nG0 Z5\nG0 X0\nM2\n")),
      make_setup({"", "linuxcnc", {}, {}}));
}

TEST(ContourErrors, OfFeedMotionsAloneLeaveOutRapids) {
  const feedscope::Run run = run_with_rapids();
  const ContourErrors all = contour_errors(*run.trajectory);
  ContourRequest request;
  request.cutting_only = true;
  const ContourErrors cutting = contour_errors(*run.trajectory, request);
  EXPECT_GT(all.largest, 0.1);
  EXPECT_LE(cutting.largest, 0.02 + 1e-6);
  EXPECT_GT(cutting.largest, 0.002);
  constexpr double found = 2 * ContourSearch::precision;  // with other numbers of places
  EXPECT_NEAR(cutting_contour_error(*run.trajectory, all), cutting.largest, found);
  EXPECT_NEAR(run.summary.cutting_contour_error, cutting.largest, found);
  EXPECT_NEAR(run.summary.max_contour_error, all.largest, found);
}

TEST(ContourErrors, OfFeedMotionsAloneCountTheLengthOfTheirPath) {
  const feedscope::Run run = run_with_rapids();
  const ContourReport report = contour_report(run, 100);
  ASSERT_FALSE(report.worst.empty());
  for (const ContourFinding& finding : report.worst) {
    EXPECT_LE(finding.place.error, 0.02 + 1e-6) << "line " << finding.place.line;
  }
  EXPECT_DOUBLE_EQ(report.rapids.value(), run.summary.max_contour_error);
  const std::vector<double>& lengths = report.spread.amount;
  constexpr double cut = 5 + 40 + 40;  // by the program [mm]
  EXPECT_NEAR(std::accumulate(lengths.begin(), lengths.end(), 0.0), cut, 1);
}

TEST(ContourErrors, BinsHaveRoundEdges) {
  ContourRequest request;
  request.bins = ContourBins::logarithmic;
  const auto errors = contour_errors(run(corner(1.5707963), "essid", 0.05), request);
  const auto& edges = errors.histogram.edges;  // 0.04 cos 45 = 0.0283
  EXPECT_EQ(edges.front(), 0);
  EXPECT_NEAR(edges.back(), 0.05, 1e-15);
  EXPECT_NEAR(edges[edges.size() - 2], 0.02, 1e-15);
  EXPECT_NEAR(edges[edges.size() - 3], 0.01, 1e-15);
  EXPECT_NEAR(edges[1], 5e-6, 1e-18);
}

TEST(ContourErrors, SpreadsAddUpToTheHistogramsOfTheirRun) {
  std::mt19937 random(11);
  const Toolpath path = random_path(random, 60);
  for (const char* model : {"essid", "ward", "msaddek"}) {
    const Trajectory trajectory = run(path, model, 0.02);
    for (const ContourBins bins : {ContourBins::sides, ContourBins::amounts}) {
      const ContourErrors errors = contour_errors(trajectory, {.bins = bins, .spread = true});
      EXPECT_LE(400 * errors.spread.step, errors.largest * (1 + 1e-9));
      const ContourHistogram summed = histogram_of(errors.spread, bins, errors.largest);
      ASSERT_EQ(summed.edges, errors.histogram.edges);
      for (std::size_t i = 0; i < summed.length.size(); ++i) {
        EXPECT_NEAR(summed.length[i], errors.histogram.length[i], 1e-9 * trajectory.path_length())
            << model << " bin " << i;
      }
      const ContourHistogram coarser = histogram_of(errors.spread, bins, 7 * errors.largest);
      EXPECT_NEAR(std::accumulate(coarser.length.begin(), coarser.length.end(), 0.0),
                  trajectory.path_length(), 1e-3 * trajectory.path_length());
    }
  }
}

TEST(ContourErrors, SpreadsTellWhetherTheDeviationLiesInXy) {
  const auto in_plane = [](const Toolpath& path) {
    return contour_errors(run(path, "essid", 0.05), {.spread = true}).spread.in_plane;
  };
  EXPECT_NEAR(in_plane(corner(1)), 1, 1e-9);
  EXPECT_NEAR(in_plane(polyline({{0, 0, 0}, {20, 0, 0}, {30, 0, 10}}, 50)), 0, 1e-9);
}

TEST(ContourErrors, AreExportedToAPicometre) {
  EXPECT_EQ(rounded_error(0.01000000000080466), 0.01);
  EXPECT_EQ(rounded_error(-0.0123456789123), -0.012345679);
  EXPECT_EQ(rounded_error(0), 0);
}

TEST(ContourErrors, CanBeStopped) {
  std::mt19937 random(3);
  const Trajectory trajectory = run(random_path(random, 20), "ward", 0.02);
  Progress progress;
  progress.cancel();
  EXPECT_THROW(contour_errors(trajectory, {}, &progress), Cancelled);
}

}  // namespace
}  // namespace feedscope
