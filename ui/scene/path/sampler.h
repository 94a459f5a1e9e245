#pragma once

#include <span>

#include "core/toolpath/curve.h"
#include "ui/scene/sampled_path.h"

namespace feedscope::ui {

/// Appends points and keeps the bounds. A point closer than `spacing` to the one before is omitted, unless a
/// longer span begins at it: that one must have its own values.
class Sampler {
 public:
  Sampler(SampledPath& path, double spacing) : path_(path), spacing_(spacing) {}

  /// `span`: length up to the next point [mm]. False if the point was omitted.
  bool add(const Vec3& position, SpanKind kind, double span);

 private:
  SampledPath& path_;
  double spacing_;
};

/// What sample_executed() has of the run's own motion: without what the axes run, rotary axes and levels.
/// `share`: of `progress`.
SampledPath sample_motion(const Trajectory& trajectory, std::size_t max_points,
                          std::span<const double> also_at, Progress& progress, double share,
                          const RunSources& sources);

/// SampledPath::deviations of which no colour shows the size. `shifts`: SampledDeviations::shifts.
std::shared_ptr<const AskedDeviations> known_shifts(std::vector<StoredVector> shifts);

/// The middle of the ends of feed motions, of all ends where nothing is cut [mm]: SampledPath::origin.
Vec3 local_origin(const Toolpath& toolpath);

/// Into how many spans to cut `length`: as many as `wanted`, as long as they are `spacing` or more [mm].
std::size_t spans(double wanted, double length, double spacing);
/// One every 3 degrees.
double spans_of_arc(const Arc& arc, double length);
/// How far apart points must be for at most `max_points` of them; 0 if all `wanted` may be kept [mm].
double spacing_for(std::size_t wanted, std::size_t max_points, double length);

}  // namespace feedscope::ui
