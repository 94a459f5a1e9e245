#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/program/language/line_runner.h"
#include "core/program/program.h"

namespace feedscope {

/// How an axis other than X, Y and Z moves.
enum class AxisMotion : std::uint8_t {
  positions,  ///< on its own, or with a rapid: the path beside it is right
  cuts,       ///< in a feed move
  at_tip,     ///< in a feed move whose X, Y and Z are those of the tool's tip
};

/// Axes other than X, Y and Z, which are not simulated: Program::other_axes names those that move, and each
/// is reported once for each kind of motion.
class OtherAxes {
 public:
  /// All outlive it.
  OtherAxes(Program& program, const LineRunner& lines, DiagnosticLog& log)
      : program_(program), lines_(lines), log_(log) {}

  /// It goes to `target`; a name with a blank in it, "tool orientation", stands for several axes.
  void move(std::string_view axis, double target, AxisMotion motion, std::uint32_t column);

 private:
  struct Axis {
    std::string name;
    std::array<bool, 3> reported{};  ///< by AxisMotion
  };

  Program& program_;
  const LineRunner& lines_;
  DiagnosticLog& log_;
  std::vector<Axis> axes_;
};

}  // namespace feedscope
