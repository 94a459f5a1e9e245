#pragma once

#include <memory>
#include <string>

#include "core/program/program.h"

namespace feedscope::test {

/// Reads a text of some dialect.
inline std::shared_ptr<const Program> program_of(const std::string& text, Dialect dialect = Dialect::iso) {
  ReadOptions options;
  options.dialect = dialect;
  return std::make_shared<const Program>(
      read_program(std::make_shared<const SourceText>("test.nc", text), nullptr, options));
}

}  // namespace feedscope::test
