#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <random>

#include "core/analysis/run.h"
#include "core/base/units.h"
#include "tests/support/folders.h"
#include "tests/support/paths.h"

namespace feedscope {
namespace {

/// A number in [-1, 1) that belongs to axis `j` of a point: equal points are moved to equal places.
double noise(const Vec3& point, int j, std::uint64_t seed) {
  std::uint64_t hash = seed * 0x9E3779B97F4A7C15U + static_cast<std::uint64_t>(j);
  for (int i = 0; i < 3; ++i) {
    const double value = point[i] + 0.0;  // no -0
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    hash ^= bits;
    for (const std::uint64_t factor : {0xff51afd7ed558ccdU, 0xc4ceb9fe1a85ec53U}) {
      hash *= factor;
      hash ^= hash >> 33;
    }
  }
  return 2 * static_cast<double>(hash >> 11) * 0x1p-53 - 1;
}

/// Every point moved by up to `distance` [mm] along X and Y, and Z where no arc lies; arcs go on through
/// them.
Toolpath moved(const Toolpath& path, double distance, std::uint64_t seed) {
  Toolpath out = path;
  const auto move = [&](const Vec3& p) {
    const double z = path.arcs.empty() ? noise(p, 2, seed) : 0;
    return Vec3(p + distance * Vec3(noise(p, 0, seed), noise(p, 1, seed), z));
  };
  out.start = move(path.start);
  for (std::size_t i = 0; i < path.segments.size(); ++i) {
    Segment& segment = out.segments[i];
    segment.end = move(path.segments[i].end);
    const Vec3 from = out.start_of(i);
    if (segment.kind == SegmentKind::line) {
      segment.length = (segment.end - from).norm();
    } else if (segment.kind == SegmentKind::arc) {
      Arc& arc = out.arcs[static_cast<std::size_t>(segment.index)];
      const Vec3 axis = arc.x.cross(arc.y);
      const Vec3 centre = arc.center + (from - path.start_of(i) + segment.end - path.segments[i].end) / 2;
      arc.center = centre + axis * (from - centre).dot(axis);
      const Vec3 first = from - arc.center;
      arc.radius = first.norm();
      arc.x = first / arc.radius;
      arc.y = axis.cross(arc.x);
      const Vec3 last = segment.end - arc.center;
      const double angle = std::atan2(last.dot(arc.y), last.dot(arc.x));
      arc.sweep = angle + 2 * units::pi * std::round((arc.sweep - angle) / (2 * units::pi));
      segment.length = arc.length();
    }
  }
  return out;
}

/// Settings that change how a model goes about a corner or a bound.
struct Choice {
  const char* model;
  const char* key;
  const char* value;
  /// false: on the DMG only. With enforce=off the feeds of a thousand short blocks depend on each other, and
  /// on the other machines have not settled after as many passes as they are given.
  bool every_machine = true;
};

class Rounding : public ::testing::TestWithParam<Choice> {
 protected:
  static constexpr double distance = 1e-9;  // mm
  static constexpr double most = 1e-5;      // of a time

  static void expect_same_time(const Toolpath& path, const std::string& machine, const std::string& name) {
    const ControlModel& model = find_model(GetParam().model);
    const Machine loaded = shipped_machines().load(machine);
    Settings settings = complete_settings(model, loaded);
    if (*GetParam().key != 0) {
      settings.set(GetParam().key, std::string(GetParam().value));
    }
    const double time = model.simulate(path, loaded, settings).duration();
    for (const std::uint64_t seed : {1U, 2U}) {
      const double other = model.simulate(moved(path, distance, seed), loaded, settings).duration();
      EXPECT_NEAR(other / time, 1, most)
          << name << " on " << machine << ", noise " << seed << ": " << time << " s becomes " << other;
    }
  }
};

TEST_P(Rounding, OfASampleChangesNoTime) {
  const MachineLibrary machines = shipped_machines();
  const std::vector<std::string> few{"dmg-mori-evo40"};
  for (const auto& file : std::filesystem::directory_iterator(std::filesystem::path(FEEDSCOPE_SOURCE_DIR) /
                                                              "resources/programs")) {
    constexpr std::uintmax_t small = 100000;
    if (file.path().extension() == ".md" || file.file_size() > small) {
      continue;
    }
    const LoadedProgram program = load_program(file.path());
    for (const std::string& machine : GetParam().every_machine ? machines.ids() : few) {
      // Blends of `essid` on machines whose controls limit no jerk: a choice of the law flips by 1e-9 mm.
      if (machine == "grbl-router" || machine == "klipper-corexy" || machine == "linuxcnc-mill") {
        continue;
      }
      expect_same_time(*program.toolpath, machine, file.path().filename().string());
    }
  }
}

/// Lines and tangent arcs as programs have them: steps of 0.05 to 20 mm, many along an axis, straight on,
/// symmetric or as long as the one before, rounded to three decimals.
Toolpath usual_path(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  Toolpath path;
  Vec3 at = Vec3::Zero();
  double heading = 0;
  double length = 1;
  const double size = 0.05 * std::pow(400.0, unit(random));
  const double turns = std::pow(10.0, -2.5 * unit(random));
  for (int i = 0; i < 60; ++i) {
    const double choice = unit(random);
    if (choice < 0.4) {
      length = size * (0.5 + unit(random));
    }
    if (choice < 0.1) {
      heading = units::pi / 2 * std::floor(4 * unit(random));
    } else if (choice < 0.8) {
      heading += turns * (unit(random) < 0.5 ? 1 : unit(random) - 0.5);
    }
    if (choice > 0.95 && i > 0) {
      const Vec3 left(-std::sin(heading), std::cos(heading), 0);
      testing::append_arc(path, at + length * left, 1 + unit(random), 50);
      at = path.segments.back().end;
      heading += path.arcs.back().sweep;
      continue;
    }
    const Vec3 next = at + length * Vec3(std::cos(heading), std::sin(heading), 0);
    at = (next * 1000).array().round() / 1000;
    testing::append_line(path, at, unit(random) < 0.1 ? 20 : 50);
  }
  return path;
}

TEST_P(Rounding, OfARandomProgramChangesNoTime) {
  std::mt19937 random(3);
  constexpr int programs = 60;
  for (int i = 0; i < programs; ++i) {
    expect_same_time(usual_path(random), i % 2 == 0 ? "spinner-mvc850" : "dmg-mori-evo40",
                     "program " + std::to_string(i));
  }
}

INSTANTIATE_TEST_SUITE_P(
    Models, Rounding,
    ::testing::Values(Choice{"cam", "", ""}, Choice{"essid", "reading", "corrected"},
                      Choice{"essid", "reading", "published"}, Choice{"essid", "reading", "strict"},
                      Choice{"gassara", "", ""}, Choice{"tapie", "", ""}, Choice{"msaddek", "law", "dynamic"},
                      Choice{"msaddek", "law", "static"}, Choice{"ward", "enforce", "on"},
                      Choice{"ward", "enforce", "off", false}, Choice{"optimal", "path", "essid"},
                      Choice{"optimal", "path", "msaddek"}),
    [](const auto& choice) { return std::string(choice.param.model) + choice.param.value; });

}  // namespace
}  // namespace feedscope
