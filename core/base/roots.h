#pragma once

#include <algorithm>
#include <cmath>

namespace feedscope {

/// Interval that contains a root or an extreme.
struct Bracket {
  double low = 0;
  double high = 0;

  double middle() const { return (low + high) / 2; }
};

/// Finds the end of a condition that holds from `low` up to some place and nowhere beyond: calls `holds(x)`
/// `halvings` times, each halving the bracket. The condition holds at the bracket's lower end if it was true
/// anywhere.
template <class Condition>
Bracket halve(Bracket bracket, int halvings, Condition holds) {
  for (int i = 0; i < halvings; ++i) {
    const double middle = bracket.middle();
    (holds(middle) ? bracket.low : bracket.high) = middle;
  }
  return bracket;
}

/// A function and its slope at one place.
struct ValueAndSlope {
  double value = 0;
  double slope = 0;
};

/// Criteria for accepting a root; 0 disables one.
struct RootTolerance {
  double value = 0;     ///< |f|
  double step = 0;      ///< Newton's next step
  double relative = 0;  ///< Newton's next step as a share of x
  double width = 0;     ///< of the bracket
  int steps = 100;      ///< at most; then the last place is returned
};

/// Root of a function that increases through zero within the bracket. Newton's steps from `x`, replaced by
/// the middle of the remaining bracket if a step would leave it: safe where the slope vanishes, quadratic
/// elsewhere.
template <class Function>
double rising_root(Bracket bracket, double x, const RootTolerance& tolerance, Function f) {
  for (int i = 0; i < tolerance.steps && bracket.high - bracket.low > tolerance.width; ++i) {
    const ValueAndSlope at = f(x);
    if (std::abs(at.value) <= tolerance.value) {
      return x;
    }
    (at.value < 0 ? bracket.low : bracket.high) = x;
    const double next = x - at.value / at.slope;
    if (std::abs(next - x) <= tolerance.step + tolerance.relative * std::abs(x)) {
      return x;
    }
    x = next > bracket.low && next < bracket.high ? next : bracket.middle();
  }
  return x;
}

/// Place of a minimum, and the smallest value found inside the bracket.
struct Least {
  Bracket place;
  double value = 0;
};

/// Minimum of a function that decreases and then increases: a golden-section search down to a bracket of
/// `width`, with at most `steps` steps. One call of `f` per step, and two before.
template <class Function>
Least least_place(Bracket bracket, double width, int steps, Function f) {
  constexpr double golden = 0.6180339887498949;
  double a = bracket.high - golden * (bracket.high - bracket.low);
  double b = bracket.low + golden * (bracket.high - bracket.low);
  double at_a = f(a);
  double at_b = f(b);
  for (int i = 0; i < steps && bracket.high - bracket.low > width; ++i) {
    if (at_a <= at_b) {
      bracket.high = b;
      b = a;
      at_b = at_a;
      a = bracket.high - golden * (bracket.high - bracket.low);
      at_a = f(a);
    } else {
      bracket.low = a;
      a = b;
      at_a = at_b;
      b = bracket.low + golden * (bracket.high - bracket.low);
      at_b = f(b);
    }
  }
  return {bracket, std::min(at_a, at_b)};
}

}  // namespace feedscope
