#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <random>

#include "core/analysis/contour/contour_errors.h"
#include "core/analysis/run/run.h"
#include "core/base/units.h"
#include "core/trajectory/part_walk.h"
#include "tests/support/brute_force.h"
#include "tests/support/folders.h"
#include "tests/support/paths.h"
#include "tests/support/random_cases.h"

namespace feedscope {
namespace {

using testing::append_arc;
using testing::append_line;
using testing::brute_force_distance;
using testing::polyline;

constexpr double nanometre = 1e-6;  // [mm]
using units::pi;

class RandomCourse {
 public:
  explicit RandomCourse(std::uint32_t seed) : random_(seed) {}

  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  double spread(double low, double high) { return low * std::pow(high / low, between(0, 1)); }
  double feed() { return spread(5, 300); }

  /// Paths that come near themselves in all ways: kind 0 to 7.
  Toolpath path(std::uint32_t kind) {
    switch (kind) {
      case 0:
        return testing::random_path(random_, 5 + static_cast<int>(between(0, 30)));
      case 1:
        return testing::spiral(spread(0.5, 20), spread(0.01, 1), 12, between(0, 6), between(0.6, 3), feed());
      case 2:
        return circles();
      case 3:
        return short_blocks();
      case 4:
        return crossing_itself();
      case 5:
        return trochoid();
      case 6:
        return zigzag();
      default:
        return helices();
    }
  }

 private:
  Vec3 point(double size) { return {between(-size, size), between(-size, size), 0}; }

  Toolpath circles() {
    Toolpath path;
    const double size = spread(0.5, 20);
    const double speed = feed();
    path.start = point(size);
    for (int i = 0; i < 6; ++i) {
      append_line(path, point(size), speed);
      const Vec3 centre = path.segments.back().end + point(size);
      append_arc(path, centre, (i % 2 == 0 ? 1 : -1) * (i % 3 == 0 ? 2 * pi : between(3, 6.28)), speed);
    }
    return path;
  }

  Toolpath short_blocks() {
    std::vector<Vec3> points;
    const double step = spread(0.005, 0.5);
    const double bend = between(0.01, 0.4);
    const double noise = spread(1e-5, 0.3) * step;
    double direction = 0;
    Vec3 at(0, 0, 0);
    for (int i = 0; i < 50; ++i) {
      points.emplace_back(at + point(noise));
      direction += bend * std::cos(0.05 * i);
      at += step * Vec3(std::cos(direction), std::sin(direction), 0);
    }
    return polyline(points, feed());
  }

  Toolpath crossing_itself() {
    std::vector<Vec3> points;
    const double size = spread(0.1, 20);
    for (int i = 0; i < 20; ++i) {
      points.push_back(point(size));
    }
    return polyline(points, feed());
  }

  Toolpath trochoid() {
    std::vector<Vec3> points;
    const double radius = spread(0.2, 5);
    const double advance = radius * spread(0.005, 0.5);
    for (int i = 0; i < 60; ++i) {
      const double turn = i * pi / 10;
      points.emplace_back(radius * std::cos(turn) + advance * turn / (2 * pi), radius * std::sin(turn), 0);
    }
    return polyline(points, feed());
  }

  Toolpath zigzag() {
    std::vector<Vec3> points;
    const double width = spread(0.5, 20);
    const double pitch = spread(0.003, 0.5);
    for (int i = 0; i < 20; ++i) {
      points.emplace_back((i + 1) / 2 % 2 == 0 ? 0 : width, pitch * (i / 2), 0);
    }
    return polyline(points, feed());
  }

  Toolpath helices() {
    Toolpath path = circles();
    for (std::size_t i = 0; i + 1 < path.segments.size(); i += 2) {
      Arc& arc = path.arcs[static_cast<std::size_t>(path.segments[i + 1].index)];
      arc.rise = Vec3(0, 0, between(-1, 1) * spread(0.01, 1) * arc.radius);
      arc.sweep *= between(0.3, 3);
      path.segments[i + 1].length = arc.length();
      path.segments[i + 1].end = arc.at(arc.length()).position;
      if (i + 3 < path.segments.size()) {  // the next line leads to the next arc
        Segment& line = path.segments[i + 2];
        const Vec3 shift(0, 0, path.segments[i + 1].end.z());
        Arc& next = path.arcs[static_cast<std::size_t>(path.segments[i + 3].index)];
        line.end += shift;
        next.center += shift;
        line.length = (line.end - path.segments[i + 1].end).norm();
        path.segments[i + 3].end += shift;
      }
    }
    return path;
  }

  std::mt19937 random_;
};

struct Sampled {
  double error = 0;
  Part part;
  double tau = 0;
};

/// The farthest of `count` instants of every part, and from there uphill as far as the part goes.
Sampled sampled_error(const Trajectory& trajectory, int count) {
  const Toolpath& path = *trajectory.path().programmed();
  Sampled best;
  for (PartWalk walk(trajectory); !walk.done(); walk.next()) {
    const PartMotion motion = walk.motion();
    for (int i = 0; i <= count; ++i) {
      const double tau = walk.part().duration * i / count;
      const double error = brute_force_distance(path, motion.kinematics(tau).position);
      if (error > best.error) {
        best = {error, walk.part(), tau};
      }
    }
  }
  if (best.error > 0) {
    const PartMotion motion(trajectory, best.part);
    const auto error = [&](double tau) {
      return brute_force_distance(path, motion.kinematics(tau).position);
    };
    double low = std::max(0.0, best.tau - best.part.duration / count);
    double high = std::min(best.part.duration, best.tau + best.part.duration / count);
    for (int i = 0; i < 40; ++i) {
      const double first = low + (high - low) / 3;
      const double second = high - (high - low) / 3;
      const bool left = error(first) > error(second);
      best.error = std::max({best.error, error(first), error(second)});
      (left ? high : low) = left ? second : first;
    }
  }
  return best;
}

struct Setting {
  const char* key;
  SettingValue value;
};

struct Variant {
  const char* name;
  const char* model;
  std::vector<Setting> settings;
  std::uint32_t paths = 240;
};

const std::vector<Variant>& variants() {
  static const std::vector<Variant> all{
      {"cam", "cam", {}},
      {"essid", "essid", {{"reading", "corrected"}}},
      {"gassara", "gassara", {}},
      {"tapie", "tapie", {}},
      {"msaddek", "msaddek", {{"compaction_mm", 0.0}}},
      {"msaddek_compacted", "msaddek", {{"compaction_mm", 5.0}}},
      {"ward_2", "ward", {{"filters", 2.0}}},
      {"ward_3", "ward", {{"filters", 3.0}}},
      {"ward_not_enforced", "ward", {{"enforce", "off"}}},
      {"optimal_essid", "optimal", {{"path", "essid"}}},
      {"optimal_ward", "optimal", {{"path", "ward"}}, 16},  // a second each
  };
  return all;
}

Trajectory simulate(const Variant& variant, const Toolpath& path, double tolerance) {
  const ControlModel& model = find_model(variant.model);
  const Machine machine = testing::spinner();
  Settings settings = complete_settings(model, machine);
  if (settings.has("contour_tolerance_mm")) {
    settings.set("contour_tolerance_mm", tolerance);
  }
  for (const auto& [key, value] : variant.settings) {
    settings.set(key, value);
  }
  return model.simulate(path, machine, settings);
}

/// What is reported is the distance of a place that the run passes, and no sample is farther away.
void expect_equal_to_brute_force(const Trajectory& trajectory, int samples) {
  const Toolpath& path = *trajectory.path().programmed();
  const ContourErrors errors = contour_errors(trajectory);
  EXPECT_LE(errors.uncertainty, 2 * nanometre);
  if (errors.worst.empty()) {
    EXPECT_EQ(errors.largest, 0);
  } else {
    const ContourPlace& worst = errors.worst.front();
    EXPECT_EQ(worst.error, errors.largest);
    EXPECT_NEAR(brute_force_distance(path, worst.position), errors.largest, nanometre);
    EXPECT_LE((trajectory.state(worst.time).position - worst.position).norm(), 5 * nanometre);
    EXPECT_LE(brute_force_distance(path, worst.segment, worst.programmed), nanometre);
    EXPECT_NEAR((worst.position - worst.programmed).norm(), worst.error, 1e-9);
  }
  for (const ContourPlace& place : errors.worst) {
    EXPECT_NEAR(brute_force_distance(path, place.position), place.error, nanometre);
  }
  EXPECT_GE(errors.largest, sampled_error(trajectory, samples).error - nanometre);
}

class ContourErrorOfModel : public ::testing::TestWithParam<std::size_t> {};

TEST_P(ContourErrorOfModel, IsThatOfBruteForceOnRandomPaths) {
  const Variant& variant = variants()[GetParam()];
  for (std::uint32_t i = 0; i < test::random_cases(variant.paths); ++i) {
    RandomCourse course(i);
    const Toolpath path = course.path(i % 8);
    const double tolerance = course.spread(0.002, 0.5);
    SCOPED_TRACE("path " + std::to_string(i) + ", tolerance " + std::to_string(tolerance) + " mm");
    try {
      expect_equal_to_brute_force(simulate(variant, path, tolerance), 4);
    } catch (const std::runtime_error& refused) {
      EXPECT_STREQ(variant.model, "optimal") << refused.what();  // the path turns about too often
    }
    if (HasFailure()) {
      return;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Models, ContourErrorOfModel, ::testing::Range(std::size_t{0}, variants().size()),
                         [](const auto& test) { return std::string(variants()[test.param].name); });

TEST(ContourErrorOfSamples, IsThatOfBruteForce) {
  const std::filesystem::path folder = std::filesystem::path(FEEDSCOPE_SOURCE_DIR) / "resources" / "programs";
  std::mt19937 random(3);
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".md") {
      continue;
    }
    const LoadedProgram program = load_program(entry.path());
    const Toolpath& path = *program.toolpath;
    for (const char* model : {"essid", "gassara", "msaddek", "ward"}) {
      SCOPED_TRACE(entry.path().filename().string() + " " + model);
      const Trajectory trajectory = simulate({model, model, {}}, path, 0.02);
      const ContourErrors errors = contour_errors(trajectory, {.places = 3});
      for (const ContourPlace& place : errors.worst) {
        EXPECT_NEAR(brute_force_distance(path, place.position), place.error, nanometre);
        EXPECT_LE((trajectory.state(place.time).position - place.position).norm(), 5 * nanometre);
      }
      std::uniform_real_distribution<double> time(0, trajectory.duration());
      for (int i = 0; i < 100; ++i) {
        EXPECT_LE(brute_force_distance(path, trajectory.state(time(random)).position),
                  errors.largest + nanometre);
      }
    }
  }
}

}  // namespace
}  // namespace feedscope
