#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "core/base/units.h"
#include "core/program/program.h"
#include "tests/core/program/random_path.h"
#include "tests/core/program/read_text.h"

namespace feedscope {
namespace {

using units::pi;

/// How a path is written down.
struct Style {
  bool incremental = false;
  bool inch = false;
  bool radius = false;  ///< R instead of I J K
  bool absolute_center = false;
  bool tight = false;  ///< no blanks, lower case
  const char* line_end = "\n";
};

std::string written(const std::vector<Move>& path, const Style& style) {
  const double scale = style.inch ? 25.4 : 1;
  std::string text =
      fmt::format("{} {} {} F{}{}", style.incremental ? "G91" : "G90", style.inch ? "G20" : "G21",
                  style.absolute_center ? "G90.1" : "G91.1", 600 / scale, style.line_end);
  Vec3 position = Vec3::Zero();
  for (const Move& move : path) {
    const Vec3 base = style.incremental ? position : Vec3::Zero();
    const Vec3 words = (move.target - base) / scale;
    const std::string to = fmt::format("X{:.9f} Y{:.9f} Z{:.9f}", words.x(), words.y(), words.z());
    if (move.motion == Motion::arc) {
      const Vec3 offset = move.center - position;
      const Vec3 center = (style.absolute_center ? move.center : offset) / scale;
      const double radius = std::copysign(offset.norm(), pi - move.sweep) / scale;
      constexpr const char* planes[] = {"G19", "G18", "G17"};
      const std::string middle =
          style.radius ? fmt::format("R{:.9f}", radius)
                       : fmt::format("I{:.9f} J{:.9f} K{:.9f}", center.x(), center.y(), center.z());
      text += fmt::format("{} G{} {} {}", planes[move.axis], move.ccw ? 3 : 2, to, middle);
    } else {
      text += fmt::format("G{} {}", move.motion == Motion::rapid ? 0 : 1, to);
    }
    text += style.line_end;
    position = move.target;
  }
  if (style.tight) {
    std::erase(text, ' ');
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  }
  return text;
}

TEST(RoundTrip, RandomPathsReadBackTheSameInEveryStyle) {
  std::mt19937 random(2026);
  for (int round = 0; round < 200; ++round) {
    const std::vector<Move> path = random_path(random);
    for (int bits = 0; bits < 32; ++bits) {
      const Style style{.incremental = (bits & 1) != 0,
                        .inch = (bits & 2) != 0,
                        .radius = (bits & 4) != 0,
                        .absolute_center = (bits & 8) != 0,
                        .tight = (bits & 16) != 0,
                        .line_end = round % 2 == 0 ? "\n" : "\r\n"};
      const std::string text = written(path, style);
      const ReadProgram program = read_text(text);
      EXPECT_FALSE(has_errors(program.diagnostics)) << format(program.diagnostics.front(), "text") << "\n"
                                                    << text;
      expect_same(path, program, 2);
      if (HasFatalFailure() || HasNonfatalFailure()) {
        FAIL() << "round " << round << ", style " << bits << "\n" << text;
      }
    }
  }
}

}  // namespace
}  // namespace feedscope
