#include "core/analysis/actual_figures.h"

#include <algorithm>
#include <cmath>

#include "core/trajectory/state_walk.h"

namespace feedscope {
namespace {

constexpr double longest_step = 0.002;  // [s]
constexpr int looks_per_span = 2;       // at least; the errors are smooth within a span
constexpr std::size_t spans_per_report = 4096;

/// Where the set position rests the axes only come to rest, and what they are behind gets less.
bool stands(const SetSpan& span) {
  return std::ranges::all_of(span.axes, [](const SetCourse& course) {
    return std::all_of(course.derivative.begin() + 1, course.derivative.end(),
                       [](double d) { return d == 0; });
  });
}

}  // namespace

ActualFigures actual_figures(const ActualPath& path, Progress* progress) {
  const Trajectory& trajectory = path.trajectory();
  ActualFigures figures;
  ActualErrors errors(path);
  StateWalk set(trajectory);
  double sum = 0;
  double cutting = 0;
  std::size_t spans = 0;
  for (ActualWalk walk(path.response()); !walk.done(); walk.next_span()) {
    const SetSpan& span = walk.span();
    constexpr double most_looks = 1e6;
    const double wanted = stands(span) ? 0 : std::min(most_looks, std::ceil(span.duration / longest_step));
    const int looks = std::max(looks_per_span, static_cast<int>(wanted));
    for (int i = 0; i < looks; ++i) {
      const double time = span.time + span.duration * (i + 0.5) / looks;
      const ActualMotion actual = walk.at(time);
      figures.largest_following_error =
          figures.largest_following_error.cwiseMax(actual.following_error.cwiseAbs());
      const State state = set.at(time);
      if (trajectory.is_rapid(state.element) || trajectory.path().kind(state.element) == ElementKind::dwell) {
        continue;
      }
      const PathDeviation::Foot foot = errors.foot(actual.position, state.element);
      if (trajectory.path().programmed()->segments[foot.segment].rapid) {
        continue;  // the axes are still behind, on the rapid before the cut
      }
      const double error = std::sqrt(foot.squared);
      sum += error * span.duration / looks;
      cutting += span.duration / looks;
      if (error > figures.worst.error) {
        figures.worst = {error,
                         errors.at(state.position, state.element),
                         time,
                         state.line,
                         actual.position,
                         actual.position - foot.offset};
      }
    }
    if (progress != nullptr && ++spans % spans_per_report == 0) {
      progress->report(span.time / trajectory.duration());
    }
  }
  figures.mean_contour_error = cutting > 0 ? sum / cutting : 0;
  return figures;
}

}  // namespace feedscope
