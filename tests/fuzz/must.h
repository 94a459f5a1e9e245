#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>

namespace feedscope::fuzz {

/// Ends the fuzzer, which keeps the text, where something does not hold of it.
inline void must(bool holds, const std::string& what) {
  if (!holds) {
    std::fprintf(stderr, "wrong: %s\n", what.c_str());
    std::abort();
  }
}

}  // namespace feedscope::fuzz
