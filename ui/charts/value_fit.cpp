#include "ui/charts/value_fit.h"

#include <algorithm>

namespace feedscope::ui {

namespace {

// More than the square root of 3: along a line in space, the ratio of the path's value to each axis's.
constexpr double in_sight = 1.75;
constexpr double headroom = 0.06;
// The extreme of a polynomial is exact up to rounding: at rest a feed may be -1e-12 m/min.
constexpr double rounding = 1e-6;

}  // namespace

Interval fit_values(std::span<const CurveReach> curves, std::span<const double> limits) {
  Interval fit;
  const bool all_may_be_cut =
      std::ranges::none_of(curves, [](const CurveReach& c) { return !c.may_be_cut && !c.values.empty(); });
  for (const CurveReach& curve : curves) {
    if ((all_may_be_cut || !curve.may_be_cut) && !curve.values.empty()) {
      fit.lower = std::min(fit.lower, double{curve.values.min});
      fit.upper = std::max(fit.upper, double{curve.values.max});
    }
  }
  const double sight = in_sight * std::max(fit.upper, -fit.lower);
  for (const CurveReach& curve : curves) {
    if (curve.may_be_cut && !curve.values.empty()) {
      fit.lower = std::min(fit.lower, std::max(-sight, double{curve.values.min}));
      fit.upper = std::max(fit.upper, std::min(sight, double{curve.values.max}));
    }
  }
  if (-fit.lower < rounding * fit.upper) {
    fit.lower = 0;
  }
  for (const double limit : limits) {
    if (limit <= sight) {
      fit.upper = fit.upper > 0 ? std::max(fit.upper, limit) : fit.upper;
      fit.lower = fit.lower < 0 ? std::min(fit.lower, -limit) : fit.lower;
    }
  }
  if (!(fit.upper > fit.lower)) {
    fit.upper = 1;
  }
  const double room = headroom * fit.width();
  return {fit.lower < 0 ? fit.lower - room : 0, fit.upper > 0 ? fit.upper + room : 0};
}

double largest_that_lasts(std::span<const double> columns) {
  constexpr std::size_t few = 4;
  double largest = 0;
  for (std::size_t i = 0; i + few <= columns.size(); ++i) {
    largest = std::max(largest, std::ranges::min(columns.subspan(i, few)));
  }
  return largest;
}

bool is_far_beyond(double fastest, double slower) {
  return slower > 0 && fastest >= 3 * slower;
}

std::optional<Interval> without_rapids(const Interval& values, double fastest, const CuttingFeed& cutting) {
  constexpr double min_room = 1.25;
  if (!(cutting.achieved > 0) || fastest <= min_room * cutting.achieved) {
    return std::nullopt;
  }
  const double programmed = std::min((1 + headroom) * cutting.programmed, in_sight * cutting.achieved);
  const double most = std::max(min_room * cutting.achieved, programmed);
  return Interval{std::max(values.lower, -most), std::min(values.upper, most)};
}

}  // namespace feedscope::ui
