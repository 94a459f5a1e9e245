#pragma once

#include <gtest/gtest.h>

#include <string>

#include "tests/core/program/read_text.h"

namespace feedscope {

/// Reads a conversational program, whatever it looks like. Its motions: see without_events().
inline ReadProgram read_heidenhain(std::string text, ReadOptions options = {}) {
  options.dialect = options.dialect.value_or(Dialect::heidenhain);
  return without_events(read_text(std::move(text), options));
}

/// The same for one that must be free of diagnostics.
inline ReadProgram read_clean_heidenhain(std::string text, ReadOptions options = {}) {
  ReadProgram program = read_heidenhain(std::move(text), options);
  for (const Diagnostic& diagnostic : program.diagnostics) {
    ADD_FAILURE() << format(diagnostic, "test.h");
  }
  return program;
}

inline Vec3 end_of(const ReadProgram& program) {
  return program.motions.back().target;
}

/// Ends of all motions, "X,Y,Z " each to three decimals without needless zeros; rapids with r before them,
/// arcs with their turn, dwells with their time.
std::string path_of(const ReadProgram& program);

}  // namespace feedscope
