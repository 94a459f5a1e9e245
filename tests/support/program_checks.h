#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "core/program/program.h"

namespace feedscope {

/// What nothing that follows could work with in a program read from any text whatever; "" if all is well.
inline std::string insane_part(const ReadProgram& program) {
  for (std::size_t i = 0; i < program.motions.size(); ++i) {
    const MotionBlock& block = program.motions[i];
    const bool numbers = block.target.allFinite() && std::isfinite(block.feed) && block.feed >= 0 &&
                         std::isfinite(block.dwell) && block.dwell >= 0;
    const bool line = block.line >= 1 && block.line <= program.source->line_count();
    const bool control = block.path_control < program.path_controls.size();
    if (!numbers || !line || !control) {
      return fmt::format("motion {} of line {}", i, block.line);
    }
    if (block.motion == Motion::arc) {
      const ArcWords& arc = program.arcs.at(static_cast<std::size_t>(block.arc));
      if (!arc.center.allFinite() || !(std::abs(arc.axis.norm() - 1) < 1e-6) || !(arc.turns >= 0)) {
        return fmt::format("arc of motion {}, line {}", i, block.line);
      }
    }
  }
  for (const Diagnostic& diagnostic : program.diagnostics) {
    const bool in_program = diagnostic.file.empty();
    const bool line = !in_program || diagnostic.line <= program.source->line_count();
    // A column one beyond the line is where something is missing.
    const bool column = !in_program || diagnostic.line == 0 ||
                        diagnostic.column <= program.source->line(diagnostic.line).size() + 1;
    if (!line || !column || diagnostic.message.empty() || diagnostic.code.empty()) {
      return fmt::format("diagnostic {} of line {}, column {}", diagnostic.code, diagnostic.line,
                         diagnostic.column);
    }
  }
  return "";
}

}  // namespace feedscope
