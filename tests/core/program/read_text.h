#pragma once

#include <memory>
#include <string>

#include "core/program/program.h"

namespace feedscope {

/// Reads a program given as text.
inline Program read_text(std::string text, const ReadOptions& options = {}) {
  return read_program(std::make_shared<const SourceText>("test.nc", std::move(text)), nullptr, options);
}

}  // namespace feedscope
