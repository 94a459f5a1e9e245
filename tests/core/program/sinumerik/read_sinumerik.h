#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/core/program/read_text.h"

namespace feedscope {

/// Its motions: see without_events().
inline ReadProgram read_sinumerik(const std::string& text) {
  return without_events(read_text(text, ReadOptions{.dialect = Dialect::sinumerik}));
}

/// Reads a program that has nothing to be said about it.
inline ReadProgram read_clean(const std::string& text) {
  ReadProgram program = read_sinumerik(text);
  for (const Diagnostic& diagnostic : program.diagnostics) {
    if (diagnostic.code != "machining-mode") {  // every CYCLE832 has one
      ADD_FAILURE() << format(diagnostic, "program") << "\n" << text;
    }
  }
  return program;
}

/// The end of the program's last motion.
inline Vec3 end_of(const std::string& text) {
  const ReadProgram program = read_clean(text);
  return program.motions.empty() ? Vec3(Vec3::Constant(-1)) : program.motions.back().target;
}

/// X of every motion's end, for programs that count.
inline std::vector<double> xs_of(const std::string& text) {
  std::vector<double> xs;
  for (const MotionBlock& block : read_clean(text).motions) {
    xs.push_back(block.target.x());
  }
  return xs;
}

inline void expect_near(const Vec3& actual, const Vec3& expected, double tolerance = 1e-9) {
  EXPECT_LT((actual - expected).norm(), tolerance)
      << actual.transpose() << " instead of " << expected.transpose();
}

}  // namespace feedscope
