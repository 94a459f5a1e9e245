#include <algorithm>
#include <cmath>
#include <limits>

#include "core/analysis/agreement/agreement.h"
#include "ui/scene/path/followed_foot.h"
#include "ui/scene/path/sampler.h"
#include "ui/scene/sampled_path.h"

namespace feedscope::ui {
namespace {

constexpr std::size_t samples_a_report = 65536;
constexpr double always = std::numeric_limits<double>::infinity();  // adds the point at any distance

/// The programmed place at `s` [mm] from the start of a segment.
Vec3 programmed_place(const Toolpath& toolpath, std::size_t segment, double s) {
  const Segment& here = toolpath.segments[segment];
  if (here.kind == SegmentKind::arc) {
    return toolpath.arc_of(here).at(std::clamp(s, 0.0, here.length)).position;
  }
  const Vec3& start = segment > 0 ? toolpath.segments[segment - 1].end : toolpath.start;
  const double share = here.length > 0 ? std::clamp(s / here.length, 0.0, 1.0) : 1.0;
  return start + share * (here.end - start);
}

}  // namespace

SampledPath sample_recorded(const TraceOnProgram& trace, const ProgrammedCourse& course,
                            const Toolpath& toolpath, std::size_t max_points, Progress* progress) {
  const MatchedRecord& matched = trace.matched;
  SampledPath path;
  std::vector<StoredVector> shifts;
  if (matched.empty()) {
    return path;
  }
  path.origin = local_origin(toolpath);
  Sampler sampler(path, spacing_for(matched.end - matched.first, max_points, course.length()));
  FollowedFoot foot(toolpath);
  Vec3 last = Vec3::Zero();
  bool begins = true;  // also after a part that does not match
  for (std::size_t i = matched.first; i < matched.end; ++i) {
    if (progress != nullptr && (i - matched.first) % samples_a_report == 0) {
      progress->report(static_cast<double>(i - matched.first) /
                       static_cast<double>(matched.end - matched.first));
    }
    const double s = matched.s[i];
    if (std::isnan(s)) {
      if (!path.kinds.empty()) {
        path.kinds.back() = SpanKind::gap;
      }
      begins = true;
      continue;
    }
    const std::uint32_t segment = course.segment_at(s);
    Vec3 place = programmed_place(toolpath, segment, s - course.start_of(segment));
    for (int axis = 0; axis < 3; ++axis) {  // the programmed position for axes missing in the trace
      place[axis] = course.seen()[static_cast<std::size_t>(axis)] ? trace.record.place[i][axis] : place[axis];
    }
    if (begins) {
      foot.begin(segment);
    }
    const auto distance = static_cast<double>(matched.distance[i]);
    // The match may lag after a corner: the next segment is considered as well.
    const std::size_t ahead = std::min<std::size_t>(segment + 1, toolpath.segments.size() - 1);
    const PathDeviation::Result deviation = foot.at(place, ahead, distance);
    const double moved = begins ? always : (place - last).norm();
    last = place;
    begins = false;
    const SpanKind kind = toolpath.segments[segment].rapid ? SpanKind::rapid : SpanKind::cut;
    if (sampler.add(place, kind, moved)) {
      path.times.push_back(trace.record.time[i]);
      const Eigen::Vector3f shift = deviation.along_bisector.cast<float>();
      shifts.push_back({Stored(shift.x()), Stored(shift.y()), Stored(shift.z())});
    }
  }
  path.kinds.back() = SpanKind::gap;
  path.deviations = known_shifts(std::move(shifts));
  path.levels = levels_of(path);
  path.boxes = boxes_of(path.positions);
  return path;
}

}  // namespace feedscope::ui
