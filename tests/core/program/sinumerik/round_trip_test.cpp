#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "core/base/units.h"
#include "tests/core/program/random_path.h"
#include "tests/core/program/sinumerik/read_sinumerik.h"

namespace feedscope {
namespace {

using units::pi;

/// How arcs are written.
enum class ArcStyle { offset, position, radius, angle_and_end, angle_and_center, through };
constexpr int arc_styles = 6;

struct Style {
  bool incremental = false;
  bool inch = false;
  bool assigned = false;  ///< "X=R1+..." instead of "X1"
  ArcStyle arc = ArcStyle::offset;
};

class Writer {
 public:
  explicit Writer(const Style& style) : style_(style), scale_(style.inch ? 25.4 : 1) {
    line(fmt::format("{} {} F{} R1=1.25", style.incremental ? "G91" : "G90", style.inch ? "G700" : "G710",
                     600 / scale_));
  }

  void add(const Move& move) {
    if (move.motion != Motion::arc) {
      line(fmt::format("G{}{}", move.motion == Motion::rapid ? 0 : 1, end(move)));
    } else if (style_.arc == ArcStyle::through) {
      const Vec3 normal = Vec3::Unit(move.axis);
      const Vec3 from = position_ - move.center;
      const double half = (move.ccw ? 1 : -1) * move.sweep / 2;
      const Vec3 middle = move.center + std::cos(half) * from + std::sin(half) * normal.cross(from);
      const Vec3 words = (style_.incremental ? Vec3(middle - position_) : middle) / scale_;
      line(fmt::format("CIP{} I1={:.9f} J1={:.9f} K1={:.9f}", end(move), words.x(), words.y(), words.z()));
    } else {
      constexpr const char* planes[] = {"G19", "G18", "G17"};
      line(fmt::format("{} G{}{}", planes[move.axis], move.ccw ? 3 : 2, arc(move)));
    }
    position_ = move.target;
  }

  const std::string& text() const { return text_; }

 private:
  std::string arc(const Move& move) const {
    const Vec3 offset = (move.center - position_) / scale_;
    const Vec3 center = move.center / scale_;
    const double degrees = move.sweep * 180 / pi;
    const std::string by_offset = fmt::format(" I{:.9f} J{:.9f} K{:.9f}", offset.x(), offset.y(), offset.z());
    switch (style_.arc) {
      case ArcStyle::offset:
        return end(move) + by_offset;
      case ArcStyle::position:
        return end(move) +
               fmt::format(" I=AC({:.9f}) J=AC({:.9f}) K=AC({:.9f})", center.x(), center.y(), center.z());
      case ArcStyle::radius:
        return end(move) + fmt::format(" CR={:.9f}", std::copysign(offset.norm(), pi - move.sweep));
      case ArcStyle::angle_and_end:
        return end(move) + fmt::format(" AR={:.9f}", degrees);
      default:
        return by_offset + fmt::format(" AR={:.9f}", degrees);
    }
  }

  std::string end(const Move& move) const {
    const Vec3 words = (style_.incremental ? Vec3(move.target - position_) : move.target) / scale_;
    return style_.assigned ? fmt::format(" X={:.9f}+R1 Y={}({:.9f}) Z={:.9f}*1EX0", words.x() - 1.25,
                                         style_.incremental ? "IC" : "AC", words.y(), words.z())
                           : fmt::format(" X{:.9f} Y{:.9f} Z{:.9f}", words.x(), words.y(), words.z());
  }

  void line(const std::string& words) { text_ += words + "\n"; }

  Style style_;
  double scale_;
  std::string text_;
  Vec3 position_ = Vec3::Zero();
};

TEST(SinumerikRoundTrip, RandomPathsReadBackTheSameInEveryStyle) {
  std::mt19937 random(2026);
  for (int round = 0; round < 60; ++round) {
    const std::vector<Move> path = random_path(random, false);
    for (int i = 0; i < 8 * arc_styles; ++i) {
      const Style style{.incremental = (i & 1) != 0,
                        .inch = (i & 2) != 0,
                        .assigned = (i & 4) != 0,
                        .arc = static_cast<ArcStyle>(i / 8)};
      Writer writer(style);
      for (const Move& move : path) {
        writer.add(move);
      }
      const ReadProgram program = read_sinumerik(writer.text());
      EXPECT_TRUE(program.diagnostics.empty()) << format(program.diagnostics.front(), "text");
      expect_same(path, program, 2);
      if (HasFatalFailure() || HasNonfatalFailure()) {
        FAIL() << "round " << round << ", style " << i << "\n" << writer.text();
      }
    }
  }
}

}  // namespace
}  // namespace feedscope
