#pragma once

#include <memory>
#include <string>
#include <utility>

#include "core/program/program.h"

namespace feedscope {

/// Reads a program given as text.
inline ReadProgram read_text(std::string text, const ReadOptions& options = {}) {
  ReadOptions metric = options;
  metric.unit = options.unit.value_or(LengthUnit::mm);  // without a warning that it is assumed
  return read_program(std::make_shared<const SourceText>("test.nc", std::move(text)), nullptr, metric);
}

/// The program without tool changes, spindle starts and stops, which do not move the tool.
inline ReadProgram without_events(ReadProgram program) {
  std::erase_if(program.motions, [](const MotionBlock& block) {
    return block.motion == Motion::dwell && block.pause != Pause::dwell && block.pause != Pause::machine_move;
  });
  return program;
}

}  // namespace feedscope
