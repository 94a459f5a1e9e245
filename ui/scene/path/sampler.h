#pragma once

#include <span>

#include "core/toolpath/curve.h"
#include "ui/scene/sampled_path.h"

namespace feedscope::ui {

/// Appends points and updates the bounds. A point closer than `spacing` to the previous one is omitted,
/// unless a longer span starts at it, which needs its own values.
class Sampler {
 public:
  Sampler(SampledPath& path, double spacing) : path_(path), spacing_(spacing) {}

  /// `span`: length up to the next point [mm]. Returns false if the point was omitted.
  bool add(const Vec3& position, SpanKind kind, double span);

 private:
  SampledPath& path_;
  double spacing_;
};

/// The part of sample_executed() from the run's own motion: without actual path, rotary axes and levels.
/// `share`: of `progress`.
SampledPath sample_motion(const Trajectory& trajectory, std::size_t max_points,
                          std::span<const double> also_at, Progress& progress, double share,
                          const RunSources& sources);

/// SampledPath::deviations without sizes for colours. `shifts`: SampledDeviations::shifts.
std::shared_ptr<const AskedDeviations> known_shifts(std::vector<StoredVector> shifts);

/// The centre of the ends of feed motions, or of all ends if nothing is cut [mm]: SampledPath::origin.
Vec3 local_origin(const Toolpath& toolpath);

/// Number of spans of `length`: `wanted`, as long as they are at least `spacing` [mm].
std::size_t spans(double wanted, double length, double spacing);
/// One every 3 degrees.
double spans_of_arc(const Arc& arc, double length);
/// Distance of points for at most `max_points` of them; 0 if all `wanted` can be kept [mm].
double spacing_for(std::size_t wanted, std::size_t max_points, double length);

}  // namespace feedscope::ui
