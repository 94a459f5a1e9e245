#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "core/base/units.h"
#include "core/program/path/plane_distance.h"
#include "tests/core/program/path/line_writer.h"

namespace feedscope {
namespace {

using units::pi;

std::vector<Diagnostic> said(LineWriter& writer) {
  return writer.finish().diagnostics;
}

LineWriter& through(LineWriter& writer, const std::vector<Vec3>& points) {
  for (const Vec3& point : points) {
    writer.line(point);
  }
  return writer;
}

/// Two rooms, 60 long and 40 wide, with a neck of this width and length 20 between them, counter-clockwise.
std::vector<Vec3> rooms(double neck, double level = 0) {
  const double h = neck / 2;
  return {{60, -20, level}, {60, -h, level}, {80, -h, level}, {80, -20, level}, {140, -20, level},
          {140, 20, level}, {80, 20, level}, {80, h, level},  {60, h, level},   {60, 20, level},
          {0, 20, level},   {0, -20, level}, {30, -20, level}};
}

TEST(CompensationGouge, ANeckNarrowerThanTheToolIsSeenFromFarBehind) {
  LineWriter writer;
  writer.rapid({30, 0, 0}).on(ToolSide::left, 5).line({30, -20, 0});
  const std::vector<Diagnostic> found = said(through(writer, rooms(9.9)).off().line({30, 0, 0}));
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(format(found[0], "f"),
            "f:5: error: at this block a tool of radius 5.0000 mm cuts 0.1000 mm into the contour of line 10 "
            "[compensation-gouge] (use a smaller tool, or do not begin the contour in an inside corner)");
}

TEST(CompensationGouge, ANeckThatIsWideEnoughIsNotSaid) {
  LineWriter writer;
  writer.rapid({30, 0, 0}).on(ToolSide::left, 5).line({30, -20, 0});
  through(writer, rooms(10)).off().line({30, 0, 0}).finish_clean();
}

TEST(CompensationGouge, RoundsAtSeveralDepthsAreSound) {
  LineWriter writer;
  writer.rapid({30, 0, 0}).on(ToolSide::left, 5).line({30, -20, 0});
  for (const double level : {0.0, -1.0, -2.0}) {
    writer.line({30, -20, level});
    through(writer, rooms(10.5, level));
  }
  writer.off().line({30, 0, -2}).finish_clean();
}

TEST(CompensationGouge, PassesOfASpiralOutwardsAreSound) {
  LineWriter writer;
  writer.on(ToolSide::left, 5).line({0, -20, 0});
  double size = 20;
  for (int i = 0; i < 12; ++i, size += 3) {
    through(writer, {{size, -size, 0}, {size, size, 0}, {-size, size, 0}, {-size, -size - 3, 0}});
  }
  writer.off().line({0, 0, 0}).finish_clean();
}

TEST(CompensationGouge, LinesThatLeadInAndOutMayCross) {
  for (const double radius : {1.0, 5.0, 12.0}) {
    LineWriter writer;
    writer.rapid({-50, -30, 0}).on(ToolSide::right, radius).line({-20, 0, 0});
    through(writer, {{0, 0, 0}, {100, 0, 0}, {100, 100, 0}, {0, 100, 0}, {0, 0, 0}, {0, -20, 0}});
    writer.off().line({0, -60, 0}).finish_clean();
  }
}

TEST(CompensationGouge, ArcsThatLeadInAndOutOfARoundWithAnOverlapMayCross) {
  for (const double lead : {6.0, 9.0}) {
    LineWriter writer;
    writer.rapid({0, 0, 0}).on(ToolSide::left, 5).line({50 - lead, -lead, 0});
    writer.arc({50, 0, 0}, {50 - lead, 0, 0}, Vec3::UnitZ());
    writer.arc({50, 0, 0}, {0, 0, 0}, Vec3::UnitZ());
    writer.arc({50 * std::cos(0.1), 50 * std::sin(0.1), 0}, {0, 0, 0}, Vec3::UnitZ());
    const Vec3 out(50 * std::cos(0.1), 50 * std::sin(0.1), 0);
    const Vec3 center = out * (1 - lead / 50);
    writer.arc(center + lead * Vec3(-std::sin(0.1), std::cos(0.1), 0), center, Vec3::UnitZ());
    writer.off().line({0, 0, 0}).finish_clean();
  }
}

TEST(CompensationGouge, AShallowDishOfShortLinesSwallowsThemOneByOne) {
  // A circle of radius 4 in chords of 0.8 mm: none of them alone is too short, the dish as a whole is.
  LineWriter writer;
  writer.rapid({-20, 10, 0}).on(ToolSide::left, 5).line({-20, 0, 0}).line({-4, 0, 0});
  for (int i = 1; i <= 15; ++i) {
    const double angle = pi + i * pi / 15;
    writer.line({4 * std::cos(angle), 4 * std::sin(angle), 0});
  }
  writer.line({20, 0, 0}).off().line({20, 10, 0});
  EXPECT_FALSE(said(writer).empty());
}

TEST(CompensationGouge, AFingerThatPointsAtAWallIsSeen) {
  // The finger's tip is 8 mm from the wall that was passed before; the tool is 10 mm across.
  LineWriter writer;
  writer.rapid({0, 20, 0}).on(ToolSide::left, 5).line({0, 0, 0});
  through(writer, {{100, 0, 0}, {100, 60, 0}, {55, 60, 0}, {50, 8, 0}, {45, 60, 0}, {0, 60, 0}});
  const std::vector<Diagnostic> found = said(writer.off().line({0, 100, 0}));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].line, 3U);
  EXPECT_NE(found[0].message.english().find("cuts 2.0000 mm into the contour of line 6"), std::string::npos)
      << found[0].message.english();
}

TEST(CompensationGouge, OfAnotherLevelIsNotSaid) {
  LineWriter writer;
  writer.rapid({0, 20, 0}).on(ToolSide::left, 5).line({0, 0, 0});
  through(writer, {{100, 0, 0}, {100, 60, 0}, {100, 60, -3}, {55, 60, -3}, {50, 8, -3}, {45, 60, -3}});
  writer.line({0, 60, -3}).off().line({0, 100, -3}).finish_clean();
}

TEST(CompensationGouge, ANotchWithoutWidthIsAnInsideCorner) {
  // Two half circles of radius 10 that meet in a notch: the paths of radius 15 about X10 and X30 meet at X20.
  LineWriter notch;
  notch.rapid({-20, -20, 0}).on(ToolSide::left, 5).line({0, -10, 0}).line({0, 0, 0});
  notch.arc({20, 0, 0}, {10, 0, 0}, -Vec3::UnitZ()).arc({40, 0, 0}, {30, 0, 0}, -Vec3::UnitZ());
  const ReadProgram program = notch.line({40, -10, 0}).off().line({60, -20, 0}).finish_clean();
  ASSERT_EQ(program.motions.size(), 7U);
  EXPECT_NEAR((program.motions[3].target - Vec3(20, std::sqrt(15 * 15 - 10 * 10), 0)).norm(), 0, 1e-9);

  // Mirrored at the X axis, and so with the other one of the two meetings first.
  LineWriter mirrored;
  mirrored.rapid({-20, 20, 0}).on(ToolSide::right, 5).line({0, 10, 0}).line({0, 0, 0});
  mirrored.arc({20, 0, 0}, {10, 0, 0}, Vec3::UnitZ()).arc({44, 0, 0}, {32, 0, 0}, Vec3::UnitZ());
  const ReadProgram below = mirrored.line({44, 10, 0}).off().line({60, 20, 0}).finish_clean();
  EXPECT_LT(below.motions.at(3).target.y(), -10);

  // From the other side the same place is a tip.
  LineWriter tip;
  tip.rapid({-20, -20, 0}).on(ToolSide::right, 5).line({0, -10, 0}).line({0, 0, 0});
  tip.arc({20, 0, 0}, {10, 0, 0}, -Vec3::UnitZ()).arc({40, 0, 0}, {30, 0, 0}, -Vec3::UnitZ());
  const ReadProgram around = tip.line({40, -10, 0}).off().line({60, -20, 0}).finish_clean();
  ASSERT_EQ(around.arcs.size(), 3U);
  EXPECT_NEAR((around.arcs[1].center - Vec3(20, 0, 0)).norm(), 0, 1e-9);
}

/// A closed contour without crossings around the origin.
std::vector<Vec3> random_star(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  const std::size_t count = 4 + random() % 14;
  std::vector<Vec3> corners;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = 2 * pi * (static_cast<double>(i) + 0.7 * unit(random)) / static_cast<double>(count);
    const double size = 30 + 40 * unit(random);
    corners.push_back(size * Vec3(std::cos(angle), std::sin(angle), 0));
  }
  return corners;
}

/// How much closer than its radius the tool's centre comes to the contour, looked at all along its path.
double deepest_cut(const ReadProgram& program, const std::vector<Vec3>& corners, double radius) {
  double nearest = radius;
  Vec3 start = Vec3::Zero();
  for (const MotionBlock& block : program.motions) {
    const bool beside = block.line > 2 && block.line <= corners.size() + 2;
    for (int i = 0; beside && i <= 200; ++i) {
      Vec3 tool = start + i / 200.0 * (block.target - start);
      if (block.motion == Motion::arc) {
        const ArcWords& arc = program.arcs.at(static_cast<std::size_t>(block.arc));
        const Vec3 from = start - arc.center;
        const Vec3 to = block.target - arc.center;
        const double sweep = std::atan2(arc.axis.dot(from.cross(to)), from.dot(to));
        tool = arc.center + Eigen::AngleAxisd(i / 200.0 * sweep, arc.axis) * from;
      }
      for (std::size_t k = 0; k < corners.size(); ++k) {
        const PlaneElement wall =
            PlaneElement::line(corners[k].head<2>(), corners[(k + 1) % corners.size()].head<2>());
        nearest = std::min(nearest, distance(Vec2(tool.head<2>()), wall));
      }
    }
    start = block.target;
  }
  return radius - nearest;
}

TEST(CompensationGouge, InRandomContoursIsSaidIfAndOnlyIfTheToolCutsIn) {
  std::mt19937 random(11);
  int sound = 0;
  int cut = 0;
  for (int round = 0; round < 1200; ++round) {
    const std::vector<Vec3> corners = random_star(random);
    const double radius = 0.5 + static_cast<double>(random() % 1000) / (round % 2 == 0 ? 30 : 200);
    const ToolSide side = round % 4 < 2 ? ToolSide::left : ToolSide::right;
    LineWriter writer(round % 8 < 4 ? OutsideCorner::arc : OutsideCorner::lines);
    // From the far end of the last side, so that the first corner is one of the contour.
    const Vec3 start = (corners.back() + corners.front()) / 2;
    writer.rapid(start * (side == ToolSide::left ? 0.5 : 3)).on(side, radius).line(start);
    through(writer, corners).line(start).off();
    writer.line(start * (side == ToolSide::left ? 0.5 : 3));
    const ReadProgram program = writer.finish();
    const double depth = deepest_cut(program, corners, radius);
    if (depth > 0.011) {
      EXPECT_FALSE(program.diagnostics.empty()) << "round " << round << ": " << depth << " mm at " << radius;
      ++cut;
    } else if (depth < 1e-3) {
      for (const Diagnostic& diagnostic : program.diagnostics) {
        ADD_FAILURE() << "round " << round << ": " << format(diagnostic, "f");
      }
      ++sound;
    }
  }
  EXPECT_GT(sound, 100);
  EXPECT_GT(cut, 50);
}

double from_line(const Vec3& p, const Vec3& from, const Vec3& to) {
  return distance(Vec2(p.head<2>()), PlaneElement::line(from.head<2>(), to.head<2>()));
}

/// Whether the line comes to a side of the contour other than the first and the last.
bool comes_to_another_side(const std::vector<Vec3>& corners, const Vec3& from, const Vec3& to) {
  const PlaneElement line = PlaneElement::line(from.head<2>(), to.head<2>());
  for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
    if (distance(PlaneElement::line(corners[k].head<2>(), corners[k + 1].head<2>()), line) < 1e-6) {
      return true;
    }
  }
  return false;
}

TEST(CompensationGouge, OfARoundThatOverrunsItsFirstCornerIsSaidIfAndOnlyIfTheToolCutsIn) {
  // As written by hand: the first side begins before its corner, the last one goes on beyond it.
  std::mt19937 random(12);
  std::uniform_real_distribution<double> unit(0, 1);
  int sound = 0;
  int cut = 0;
  for (int round = 0; round < 800; ++round) {
    const std::vector<Vec3> corners = random_star(random);
    const double radius = 0.5 + static_cast<double>(random() % 1000) / (round % 2 == 0 ? 60 : 200);
    const ToolSide side = round % 4 < 2 ? ToolSide::left : ToolSide::right;
    const Vec3& corner = corners[0];
    const Vec3 first = (corners[1] - corner).normalized();
    const Vec3 last = (corner - corners.back()).normalized();
    const Vec3 start = corner - (round % 3 == 0 ? 0 : 15 * unit(random)) * first;
    const Vec3 end = corner + (round % 3 == 1 ? 0 : 15 * unit(random)) * last;
    if (comes_to_another_side(corners, start, corner) || comes_to_another_side(corners, corner, end)) {
      continue;
    }
    LineWriter writer;
    writer.rapid(start + 0.001 * first).on(side, radius).line(start);
    through(writer, {corners.begin() + 1, corners.end()}).line(end).off().line({200, 200, 0});
    const ReadProgram program = writer.finish();
    double depth = 0;
    bool backward = false;  // there is no room beside a side, were it longer
    Vec3 tool = Vec3::Zero();
    for (const MotionBlock& block : program.motions) {
      const bool of_last = block.line == corners.size() + 2;
      if (block.motion == Motion::line && block.line > 2 && block.line <= corners.size() + 2) {
        const std::size_t k = block.line - 3;
        const Vec3 along_side = corners[(k + 1) % corners.size()] - corners[k];
        backward = backward || (block.target - tool).dot(along_side) < 0;
      }
      for (int i = 0; i <= 80 && block.line > 2 && block.line <= corners.size() + 2; ++i) {
        const Vec3 at = tool + i / 80.0 * (block.target - tool);
        const bool beyond = of_last && (at - corner).dot(last) > 0;
        for (std::size_t k = 0; k < corners.size() && block.motion == Motion::line && !beyond; ++k) {
          depth = std::max(depth, radius - from_line(at, corners[k], corners[(k + 1) % corners.size()]));
        }
      }
      tool = block.target;
    }
    if (depth > 0.011) {
      EXPECT_FALSE(program.diagnostics.empty()) << "round " << round << ": " << depth << " mm at " << radius;
      ++cut;
    } else if (depth < 1e-3 && !backward) {
      for (const Diagnostic& diagnostic : program.diagnostics) {
        ADD_FAILURE() << "round " << round << ": " << format(diagnostic, "f") << " at " << radius;
      }
      ++sound;
    }
  }
  EXPECT_GT(sound, 80);
  EXPECT_GT(cut, 25);
}

TEST(CompensationGouge, ALongContourIsReadInLinearTime) {
  // Waves of short lines: far more than what is kept in view.
  LineWriter writer;
  writer.rapid({-10, 10, 0}).on(ToolSide::left, 1).line({-10, 0, 0});
  for (int i = 0; i < 40000; ++i) {
    const double x = 0.01 * i;
    writer.line({x, 3 - 3 * std::cos(x / 3), 0});
  }
  const ReadProgram program = writer.off().line({500, 50, 0}).finish_clean();
  EXPECT_GT(program.motions.size(), 40000U);
}

TEST(PlaneDistance, IsTheShortestOfAll) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto element = [&] {
    const Vec2 start = 10 * Vec2(unit(random), unit(random));
    const Vec2 center = start + 8 * Vec2(unit(random), unit(random));
    const double sweep = 6 * std::abs(unit(random));
    const Vec2 from = start - center;
    const int turn = unit(random) < 0 ? -1 : 1;
    const Vec2 end = center + std::cos(sweep) * from + turn * std::sin(sweep) * left_of(from);
    return unit(random) < 0 ? PlaneElement::line(start, center)
                            : PlaneElement::arc(start, end, center, turn, 0);
  };
  const auto at = [](const PlaneElement& e, double share) -> Vec2 {
    const Vec2 from = e.start - e.center;
    const double angle = share * e.sweep;
    return e.is_arc() ? Vec2(e.center + std::cos(angle) * from + e.turn * std::sin(angle) * left_of(from))
                      : Vec2(e.start + share * (e.end - e.start));
  };
  constexpr int looks = 400;
  for (int round = 0; round < 300; ++round) {
    const PlaneElement a = element();
    const PlaneElement b = element();
    const PlaneBox box = box_of(a);
    double nearest = 1e9;
    for (int i = 0; i <= looks; ++i) {
      const Vec2 point = at(a, static_cast<double>(i) / looks);
      nearest = std::min(nearest, distance(point, b));
      PlaneBox alone;
      alone.add(point);
      ASSERT_TRUE(box.is_near(alone, 1e-9));
    }
    ASSERT_LE(distance(a, b), nearest + 1e-9) << "round " << round;
    ASSERT_GE(distance(a, b), nearest - 0.08) << "round " << round;
    ASSERT_NEAR(distance(a, b), distance(b, a), 1e-9);
  }
}

}  // namespace
}  // namespace feedscope
