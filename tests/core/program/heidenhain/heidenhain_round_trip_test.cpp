#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/base/units.h"
#include "tests/core/program/heidenhain/read_heidenhain.h"

namespace feedscope {
namespace {

struct Move {
  Motion motion = Motion::line;
  Vec3 target;
  Vec3 center;
  bool ccw = true;
  double sweep = 0;  ///< whole turns included
};

struct Style {
  bool incremental = false;
  bool inch = false;
  bool comma = false;
  bool numbered = false;
  int arc = 0;  ///< 0: CC and C, 1: CR, 2: CC and CP by its angle
};

std::vector<Move> random_path(std::mt19937& random, int axis, bool helices) {
  std::uniform_real_distribution<double> number(-100, 100);
  std::uniform_real_distribution<double> angle(0.05, 2 * units::pi - 0.05);
  const Vec3 normal = Vec3::Unit(axis);
  std::vector<Move> path;
  Vec3 position = Vec3::Zero();
  for (int i = 0; i < 40; ++i) {
    Move move;
    const int kind = static_cast<int>(random() % 3);
    move.target = {number(random), number(random), number(random)};
    if (kind < 2) {
      move.motion = kind == 0 ? Motion::rapid : Motion::line;
    } else {
      move.motion = Motion::arc;
      move.ccw = random() % 2 == 0;
      const double partial = angle(random);
      Vec3 offset(number(random), number(random), number(random));
      offset[axis] = 0;
      move.center = position + offset;
      const double turn = move.ccw ? partial : -partial;
      move.target = move.center - std::cos(turn) * offset - std::sin(turn) * normal.cross(offset);
      move.sweep = partial + (helices ? static_cast<double>(random() % 4) * 2 * units::pi : 0.0);
      move.target[axis] += number(random);
    }
    path.push_back(move);
    position = move.target;
  }
  return path;
}

class Writer {
 public:
  Writer(int axis, const Style& style) : axis_(axis), style_(style), unit_(style.inch ? 25.4 : 1) {
    text_ = fmt::format("BEGIN PGM A {}\nTOOL CALL 1 {} S100\n", style.inch ? "INCH" : "MM", "XYZ"[axis]);
  }

  void add(const Move& move) {
    const std::string numbers = style_.numbered ? fmt::format("{} ", ++number_) : "";
    const std::string feed =
        move.motion == Motion::rapid ? " FMAX" : fmt::format(" F{}", style_.inch ? 6000 / 25.4 : 600);
    if (move.motion != Motion::arc) {
      text_ += numbers + "L" + coordinates(move.target) + feed;
    } else if (style_.arc == 1) {
      const double radius = (move.center - position_).norm();
      text_ +=
          numbers + "CR" + coordinates(move.target) +
          fmt::format(" R{:+.9f} DR{}", (move.sweep < units::pi ? radius : -radius) / unit_, sign(move)) +
          feed;
    } else {
      text_ += numbers + "CC" + pole(move.center) + "\n" + numbers;
      text_ += style_.arc == 0 ? "C" + coordinates(move.target)
                               : fmt::format("CP IPA{:+.12f} {}{:+.9f}",
                                             units::to_deg(move.ccw ? move.sweep : -move.sweep), "XYZ"[axis_],
                                             move.target[axis_] / unit_);
      text_ += fmt::format(" DR{}", sign(move)) + feed;
    }
    text_ += "\n";
    position_ = move.target;
  }

  std::string text() const {
    std::string text = text_ + "END PGM A MM\n";
    if (style_.comma) {
      std::replace(text.begin(), text.end(), '.', ',');
    }
    return text;
  }

 private:
  static char sign(const Move& move) { return move.ccw ? '+' : '-'; }
  std::string coordinates(const Vec3& target) const {
    const Vec3 words = (target - (style_.incremental ? position_ : Vec3::Zero())) / unit_;
    const char* const i = style_.incremental ? "I" : "";
    return fmt::format(" {0}X{1:+.9f} {0}Y{2:+.9f} {0}Z{3:+.9f}", i, words.x(), words.y(), words.z());
  }
  std::string pole(const Vec3& center) const {
    std::string text;
    for (int axis = 0; axis < 3; ++axis) {
      if (axis != axis_) {
        text += fmt::format(" {}{:+.9f}", "XYZ"[axis], center[axis] / unit_);
      }
    }
    return text;
  }

  int axis_;
  Style style_;
  double unit_;
  int number_ = 0;
  std::string text_;
  Vec3 position_ = Vec3::Zero();
};

void expect_same(const std::vector<Move>& path, const Program& program, int axis) {
  ASSERT_EQ(program.motions.size(), path.size());
  for (std::size_t i = 0; i < path.size(); ++i) {
    const MotionBlock& block = program.motions[i];
    ASSERT_EQ(block.motion, path[i].motion) << i;
    ASSERT_LT((block.target - path[i].target).norm(), 1e-5) << i;
    if (block.motion != Motion::rapid) {
      ASSERT_NEAR(block.feed, 10, 1e-9) << i;
    }
    if (block.motion == Motion::arc) {
      const ArcWords& arc = program.arcs.at(static_cast<std::size_t>(block.arc));
      Vec3 offset = arc.center - path[i].center;
      offset[axis] = 0;
      ASSERT_LT(offset.norm(), 1e-2) << i;
      ASSERT_EQ(arc.axis, (path[i].ccw ? 1 : -1) * Vec3(Vec3::Unit(axis))) << i;
      ASSERT_EQ(arc.turns, std::floor(path[i].sweep / (2 * units::pi))) << i;
    }
  }
}

TEST(HeidenhainRoundTrip, RandomPathsReadBackTheSameInEveryStyle) {
  std::mt19937 random(2026);
  for (int round = 0; round < 60; ++round) {
    for (int bits = 0; bits < 48; ++bits) {
      const int axis = round % 3;
      const Style style{.incremental = (bits & 1) != 0,
                        .inch = (bits & 2) != 0,
                        .comma = (bits & 4) != 0,
                        .numbered = (bits & 8) != 0,
                        .arc = bits / 16};
      const std::vector<Move> path = random_path(random, axis, style.arc == 2);
      Writer writer(axis, style);
      for (const Move& move : path) {
        writer.add(move);
      }
      const Program program = read_clean_heidenhain(writer.text());
      expect_same(path, program, axis);
      if (HasFailure()) {
        FAIL() << "round " << round << ", style " << bits << "\n" << writer.text();
      }
    }
  }
}

}  // namespace
}  // namespace feedscope
