#include "core/compressor/smooth_course.h"

#include <algorithm>
#include <cmath>

namespace feedscope {
namespace {

/// Margin for second-order terms of a sampled deviation, and for the step from the cubic spline to
/// polynomials by path length.
constexpr double slack = 0.97;

/// Sagitta of the arc of an interval, in tolerances: a cubic follows it far more closely.
constexpr double first_sagitta = 8;

/// Largest turn of the curve in one interval, as the difference of unit vectors: quadratures by path length
/// require small turns.
constexpr double largest_turn = 0.3;

constexpr int max_rounds = 14;

CourseKnot knot_at(const CurvePoint& point) {
  const CurvePoint by_length = by_path_length(point);
  return {0, by_length.position, by_length.d1, by_length.d2};
}

/// Point of the polyline that prevents a smooth curve in interval `k`.
std::size_t corner_of(const Polyline& polyline, const CubicSplineFit& fit, std::size_t k) {
  const std::size_t line = fit.first_line(k);
  const bool at_start = fit.begin(k) - polyline.places[line] < polyline.places[line + 1] - fit.end(k);
  return std::clamp<std::size_t>(at_start ? line : line + 1, 1, polyline.points.size() - 2);
}

void set_knots(const Polyline& polyline, const CubicSplineFit& fit, SmoothCourse& course) {
  const std::size_t count = fit.interval_count();
  course.knots.clear();
  course.lines.clear();
  course.knots.reserve(count + 1);
  course.lines.reserve(count);
  for (std::size_t k = 0; k < count; ++k) {
    course.knots.push_back(knot_at(fit.at(k, 0)));
    course.lines.push_back(fit.first_line(k));
  }
  course.knots.push_back(knot_at(fit.at(count - 1, 1)));
  course.knots.front().position = polyline.points.front();
  course.knots.back().position = polyline.points.back();
  for (std::size_t k = 0; k < count; ++k) {
    course.knots[k + 1].s = course.knots[k].s + course_length(course.knots[k], course.knots[k + 1]);
  }
}

/// Whether the parameter of a span is nearly proportional to its length, as its quadrature assumes.
bool is_even(const CourseSpan& span) {
  constexpr int places = 5;
  constexpr double uneven = 0.002;
  for (int i = 0; i < places; ++i) {
    if (!(std::abs(span.stretch((i + 0.5) / places) - 1) <= uneven)) {
      return false;
    }
  }
  return true;
}

}  // namespace

void CourseSmoother::set_first_borders(const Polyline& polyline, const SmoothingRule& rule) {
  borders_.assign(1, 0.0);
  const std::size_t lines = polyline.points.size() - 1;
  Vec3 start = polyline.direction(0);
  double spread = 0;
  for (std::size_t line = 1; line < lines; ++line) {
    const Vec3 direction = polyline.direction(line);
    spread = std::max(spread, (direction - start).norm());
    if (spread > largest_turn ||
        (polyline.places[line + 1] - borders_.back()) * spread > 8 * first_sagitta * rule.tolerance) {
      borders_.push_back(polyline.places[line]);
      start = direction;
      spread = 0;
    }
  }
  if (borders_.size() > 1 &&
      polyline.length() - borders_.back() < 0.5 * (borders_.back() - *(borders_.end() - 2))) {
    borders_.pop_back();
  }
  borders_.push_back(polyline.length());
  while (borders_.size() <= CubicSplineFit::min_intervals) {
    marked_.assign(borders_.size() - 1, 1);
    split();
  }
  level_lengths();
}

void CourseSmoother::split() {
  next_.clear();
  for (std::size_t k = 0; k + 1 < borders_.size(); ++k) {
    next_.push_back(borders_[k]);
    if (marked_[k] != 0) {
      next_.push_back((borders_[k] + borders_[k + 1]) / 2);
    }
  }
  next_.push_back(borders_.back());
  std::swap(borders_, next_);
}

void CourseSmoother::level_lengths() {
  constexpr double largest_ratio = 3;
  for (bool any = true; any;) {
    any = false;
    marked_.assign(borders_.size() - 1, 0);
    for (std::size_t k = 0; k + 1 < borders_.size(); ++k) {
      const double own = borders_[k + 1] - borders_[k];
      const double before = k > 0 ? borders_[k] - borders_[k - 1] : own;
      const double after = k + 2 < borders_.size() ? borders_[k + 2] - borders_[k + 1] : own;
      if (own > largest_ratio * std::min(before, after)) {
        marked_[k] = 1;
        any = true;
      }
    }
    if (any) {
      split();
    }
  }
}

SmoothCourse CourseSmoother::smooth(const Polyline& polyline, const SmoothingRule& rule,
                                    const Progress* progress) {
  SmoothCourse course;
  set_first_borders(polyline, rule);
  CubicSplineFit fit(polyline, rule.smoothing);
  const auto may_split = [&](int round, std::size_t k) {
    return round < max_rounds && fit.end(k) - fit.begin(k) > 2 * rule.tolerance;
  };
  for (int round = 0;; ++round) {
    fit.fit(borders_);
    course.deviation = 0;
    course.corners.clear();
    marked_.assign(fit.interval_count(), 0);
    bool any = false;
    const auto improve = [&](std::size_t k) {
      if (may_split(round, k)) {
        marked_[k] = 1;
        any = true;
      } else {
        course.corners.push_back(corner_of(polyline, fit, k));
      }
    };
    for (std::size_t k = 0; k < fit.interval_count(); ++k) {
      stop_if_cancelled(progress);
      const double deviation = fit.deviation(k);
      course.deviation = std::max(course.deviation, deviation);
      if (deviation > slack * rule.tolerance) {
        improve(k);
      } else if (fit.turn(k) > largest_turn && may_split(round, k)) {
        improve(k);
      }
    }
    if (!any && course.corners.empty()) {
      set_knots(polyline, fit, course);
      for (std::size_t k = 0; k < fit.interval_count(); ++k) {
        if (!is_even(CourseSpan(course.knots[k], course.knots[k + 1]))) {
          improve(k);
        }
      }
    }
    if (!any) {
      break;
    }
    split();
    level_lengths();
  }
  if (!course.corners.empty()) {
    course.knots.clear();
    course.corners.erase(std::unique(course.corners.begin(), course.corners.end()), course.corners.end());
  }
  return course;
}

}  // namespace feedscope
