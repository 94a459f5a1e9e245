#pragma once

#include <memory>
#include <string>

#include "core/program/program.h"

namespace feedscope {

/// Reads a program given as text.
inline Program read_text(std::string text, const ReadOptions& options = {}) {
  ReadOptions metric = options;
  metric.unit = options.unit.value_or(LengthUnit::mm);  // without a warning that it is assumed
  return read_program(std::make_shared<const SourceText>("test.nc", std::move(text)), nullptr, metric);
}

}  // namespace feedscope
