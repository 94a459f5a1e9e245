#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <random>

#include "core/analysis/run/run.h"
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

/// Turned by a right angle about Z: what X did is done by Y.
Toolpath turned(const Toolpath& path) {
  const auto turn = [](const Vec3& p) { return Vec3(-p.y(), p.x(), p.z()); };
  Toolpath out = path;
  out.start = turn(path.start);
  for (Segment& segment : out.segments) {
    segment.end = turn(segment.end);
  }
  for (Arc& arc : out.arcs) {
    for (Vec3* vector : {&arc.center, &arc.x, &arc.y, &arc.rise}) {
      *vector = turn(*vector);
    }
  }
  return out;
}

/// Every line in pieces that end at these shares of its length.
Toolpath cut(const Toolpath& path, const std::vector<double>& shares) {
  Toolpath out = path;
  out.segments.clear();
  for (std::size_t i = 0; i < path.segments.size(); ++i) {
    Vec3 from = path.start_of(i);
    const Vec3 begin = from;
    for (const double share : shares) {
      Segment piece = path.segments[i];
      piece.end = share == 1 ? piece.end : Vec3(begin + share * (piece.end - begin));
      piece.length = (piece.end - from).norm();
      from = piece.end;
      out.segments.push_back(piece);
    }
  }
  return out;
}

double optimal_time(const Toolpath& path, const std::string& of, const Machine& machine) {
  const ControlModel& model = find_model("optimal");
  Settings settings = complete_settings(model, machine);
  settings.set("path", of);
  settings.set("jerk", std::string("on"));
  return model.simulate(path, machine, settings).duration();
}

TEST(RoundingOfOptimalWithJerk, OfARandomProgramChangesNoTime) {
  // The law is searched, and after any change in other cells. X and Y of the machine are alike.
  constexpr double searched = 5e-4;  // of a time
  std::mt19937 random(4);
  const Machine machine = testing::spinner();
  for (int i = 0; i < 20; ++i) {
    const Toolpath path = usual_path(random);
    const double time = optimal_time(path, "essid", machine);
    for (const Toolpath& other : {moved(path, 1e-9, 1), moved(path, 1e-9, 2), turned(path)}) {
      EXPECT_NEAR(optimal_time(other, "essid", machine) / time, 1, searched) << "program " << i;
    }
  }
}

TEST(RoundingOfOptimalWithJerk, LinesInPiecesTakeTheTimeOfTheWhole) {
  // With the stops of `tapie` pieces do not shape the path. The last ones are of less than a nanometre.
  constexpr double rounding = 1e-7;
  std::mt19937 random(5);
  const Machine machine = testing::spinner();
  for (int i = 0; i < 10; ++i) {
    Toolpath path;
    for (int k = 0; k < 20; ++k) {
      const Vec3 step = Vec3(std::cos(k * k), std::sin(k * k), 0) * (0.05 + 3 * (random() % 100) / 100.0);
      testing::append_line(path, (path.segments.empty() ? path.start : path.segments.back().end) + step, 50);
    }
    const double time = optimal_time(path, "tapie", machine);
    for (const std::vector<double>& shares : {std::vector<double>{0.5, 1},
                                              {1.0 / 7, 2.0 / 7, 0.7, 1},
                                              {1 - 2e-9, 1 - 1e-9, 1},
                                              {1e-7, 2e-7, 1}}) {
      EXPECT_NEAR(optimal_time(cut(path, shares), "tapie", machine) / time, 1, rounding) << "program " << i;
    }
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
