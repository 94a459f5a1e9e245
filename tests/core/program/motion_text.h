#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

#include "core/program/program.h"

namespace feedscope {

using Lines = std::vector<std::string>;

/// The motions of a program to a nanometre: "line 1 2 3 @4" goes to X1 Y2 Z3 in line 4. Tool changes, spindle
/// starts and stops are no motions.
inline Lines text_of(const ReadProgram& program) {
  constexpr const char* names[] = {"rapid", "line", "arc", "dwell"};
  const auto tidy = [](double v) { return std::round(v * 1e6) / 1e6 + 0.0; };
  Lines lines;
  for (const MotionBlock& block : program.motions) {
    const bool moves = block.pause == Pause::machine_move;
    if (block.motion == Motion::dwell && block.pause != Pause::dwell && !moves) {
      continue;
    }
    lines.push_back(
        fmt::format("{} {} {} {} @{}", moves ? "machine move" : names[static_cast<int>(block.motion)],
                    tidy(block.target.x()), tidy(block.target.y()), tidy(block.target.z()), block.line));
  }
  return lines;
}

}  // namespace feedscope
