#include "core/analysis/actual_figures.h"

#include <cmath>

#include "core/drives/span_looks.h"

namespace feedscope {
namespace {

constexpr std::size_t spans_per_report = 4096;

}  // namespace

ActualFigures actual_figures(const ActualPath& path, Progress* progress) {
  const Trajectory& trajectory = path.trajectory();
  ActualFigures figures;
  ActualErrors errors(path);
  const bool rigid = path.response().is_rigid();
  double sum = 0;
  double cutting = 0;
  std::size_t spans = 0;
  for (ActualWalk walk(path.response()); !walk.done(); walk.next_span()) {
    const SetSpan& span = walk.span();
    const SpanLooks looks(span, rigid);
    const bool cuts =
        !trajectory.is_rapid(span.element) && trajectory.path().kind(span.element) != ElementKind::dwell;
    for (int i = 0; i < looks.count(); ++i) {
      const double time = looks.middle(i);
      const ActualMotion actual = walk.within_span(time);
      figures.largest_following_error =
          figures.largest_following_error.cwiseMax(actual.following_error.cwiseAbs());
      if (!cuts) {
        continue;
      }
      const PathDeviation::Foot foot = errors.foot(actual.position, span.element);
      if (trajectory.path().programmed()->segments[foot.segment].rapid) {
        continue;  // the axes are still behind, on the rapid before the cut
      }
      const double error = std::sqrt(foot.squared);
      sum += error * looks.duration(i);
      cutting += looks.duration(i);
      if (error > figures.worst.error) {
        figures.worst = {error,
                         errors.at(actual.position + actual.following_error, span.element),
                         time,
                         trajectory.line_of(span.element),
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
