#pragma once

#include <cstddef>
#include <cstdlib>

namespace feedscope::test {

/// Of so many cases one is taken.
template <class Count>
Count one_of() {
  static const bool thorough = std::getenv("FEEDSCOPE_THOROUGH") != nullptr;
  return thorough ? 1 : 4;
}

/// How many of `whole` cases, each as good as any other, a test takes: a quarter, which every change is
/// checked with; all where FEEDSCOPE_THOROUGH is set, as packaging/check does before a release.
template <class Count>
Count random_cases(Count whole) {
  return (whole + one_of<Count>() - 1) / one_of<Count>();
}

/// Whether the case with this number is among them, of cases that come in turns.
inline bool in_turn(std::size_t number) {
  return number % one_of<std::size_t>() == 0;
}

}  // namespace feedscope::test
