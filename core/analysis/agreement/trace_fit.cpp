#include "core/analysis/agreement/trace_fit.h"

#include <algorithm>
#include <cmath>

namespace feedscope {
namespace {

constexpr double step_tolerances = 2;
constexpr double step_noises = 20;
constexpr double least_noises = 5;
constexpr double steps_a_path = 50;  // at least
constexpr double unrecorded = 10;    // periods without a sample
constexpr double least_along = 0.5;  // path length per distance of one step: corners are rounded
constexpr double most_along = 4;     // a step that nearly turns back is short

/// Length of the recorded axes at places that never decrease.
class SeenLength {
 public:
  explicit SeenLength(const ProgrammedCourse& course) : course_(course) {}
  double at(double s) {
    while (part_ + 2 < course_.size() && course_.s(part_ + 1) < s) {
      ++part_;
    }
    const double length = course_.s(part_ + 1) - course_.s(part_);
    const double share = length > 0 ? std::clamp((s - course_.s(part_)) / length, 0.0, 1.0) : 1;
    return course_.seen_length(part_) + share * (course_.seen_length(part_ + 1) - course_.seen_length(part_));
  }

 private:
  const ProgrammedCourse& course_;
  std::size_t part_ = 0;
};

/// Measures between two samples, in steps [mm].
TraceFit measured(const ProgrammedCourse& course, const MotionRecord& record, const MatchedRecord& matched,
                  double step, double period, std::size_t first, std::size_t end) {
  TraceFit fit;
  SeenLength seen(course);
  std::size_t post = first;
  Vec3 place = course.visible(record.place[first]);
  double fitting = 0;
  double along = 0;
  for (std::size_t i = first + 1; i < end; ++i) {
    const Vec3 here = course.visible(record.place[i]);
    if (record.time[i] - record.time[i - 1] > unrecorded * period) {
      post = i;
      place = here;
      continue;
    }
    const double way = (here - place).norm();
    if (way < step) {
      continue;
    }
    fit.way += way;
    if (!std::isnan(matched.s[post]) && !std::isnan(matched.s[i])) {
      const double from = seen.at(matched.s[post]);
      const double length = seen.at(matched.s[i]) - from;
      if (length >= least_along * way && length <= most_along * way + step) {
        fitting += way;
        along += matched.s[i] - matched.s[post];
      }
    }
    post = i;
    place = here;
  }
  fit.trace_share = fit.way > 0 ? fitting / fit.way : 0;
  fit.path_share = course.length() > 0 ? std::min(1.0, along / course.length()) : 0;
  return fit;
}

}  // namespace

TraceFit fit_of(const ProgrammedCourse& course, const MotionRecord& record, const MatchedRecord& matched,
                const MatchOptions& options, double period) {
  constexpr double most_of_it = 0.5;
  const std::size_t count = record.place.size();
  if (course.size() < 2 || count < 2) {
    return {};
  }
  const double path = course.seen_length(course.size() - 1);
  const double step =
      std::max(least_noises * options.noise,
               std::min(std::max(step_tolerances * options.tolerance, step_noises * options.noise),
                        path / steps_a_path));
  if (!matched.empty()) {
    const bool from_start =
        (course.visible(record.place[matched.first]) - course.point(0)).norm() <= options.tolerance;
    const TraceFit fit = measured(course, record, matched, step, period, from_start ? matched.first : 0,
                                  std::min(count, matched.arrival + 1));
    if (fit.path_share >= most_of_it) {
      return fit;
    }
  }
  return measured(course, record, matched, step, period, 0, count);
}

}  // namespace feedscope
