#pragma once

namespace feedscope::test {

/// First three derivatives of a function at a place, by differences of fourth order over `h`.
struct Differences {
  double d1 = 0;
  double d2 = 0;
  double d3 = 0;
};

template <class F>
Differences differences(const F& f, double at, double h) {
  const auto odd = [&](int n) { return f(at + n * h) - f(at - n * h); };
  const auto even = [&](int n) { return f(at + n * h) + f(at - n * h) - 2 * f(at); };
  return {(8 * odd(1) - odd(2)) / (12 * h), (16 * even(1) - even(2)) / (12 * h * h),
          (8 * odd(2) - 13 * odd(1) - odd(3)) / (8 * h * h * h)};
}

}  // namespace feedscope::test
