#pragma once

#include <cstddef>
#include <cstdlib>
#include <vector>

namespace feedscope::test {

/// Of so many cases one is taken.
template <class Count>
Count one_of() {
  static const bool thorough = std::getenv("FEEDSCOPE_THOROUGH") != nullptr;
  return thorough ? 1 : 8;
}

/// How many of `whole` cases, each as good as any other, a test takes: an eighth, which every change is
/// checked with; all where FEEDSCOPE_THOROUGH is set, as packaging/check does before a release.
template <class Count>
Count random_cases(Count whole) {
  return (whole + one_of<Count>() - 1) / one_of<Count>();
}

/// Whether the case with this number is among them, of cases that come in turns.
inline bool in_turn(std::size_t number) {
  return number % one_of<std::size_t>() == 0;
}

/// Those of `cases` that are in turn, the first among them.
template <class Case>
std::vector<Case> in_turns(const std::vector<Case>& cases) {
  std::vector<Case> taken;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (in_turn(i)) {
      taken.push_back(cases[i]);
    }
  }
  return taken;
}

/// Whether everything is taken, second languages and themes included.
inline bool thorough() {
  return one_of<std::size_t>() == 1;
}

}  // namespace feedscope::test
