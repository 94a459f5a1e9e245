#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/program/program.h"
#include "tests/core/program/read_text.h"

namespace feedscope {

inline ReadProgram read_as(Dialect dialect, std::string text) {
  return read_text(std::move(text), {.dialect = dialect});
}

/// Reads a program that must be free of diagnostics.
inline ReadProgram read_clean_as(Dialect dialect, const std::string& text) {
  ReadProgram program = read_as(dialect, text);
  for (const Diagnostic& diagnostic : program.diagnostics) {
    ADD_FAILURE() << format(diagnostic, "test.nc") << "\n" << text;
  }
  return program;
}

/// The X positions that a program goes to, one a motion; it must be free of diagnostics.
inline std::vector<double> way(Dialect dialect, const std::string& text) {
  std::vector<double> positions;
  const ReadProgram program = without_events(read_clean_as(dialect, text));
  for (const MotionBlock& block : program.motions) {
    positions.push_back(block.target.x());
  }
  return positions;
}

/// The only diagnostic of a text, as printed.
inline std::string said_of(Dialect dialect, const std::string& text) {
  const ReadProgram program = read_as(dialect, text);
  EXPECT_EQ(program.diagnostics.size(), 1U) << text;
  return program.diagnostics.empty() ? "" : format(program.diagnostics.front(), "f");
}

}  // namespace feedscope
