#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "core/toolpath/toolpath.h"
#include "core/trajectory/trajectory.h"

namespace feedscope::ui {

/// What the path does between one point and the next.
enum class SpanKind : std::uint8_t { cut, rapid, blend };

/// A path as points close enough that straight spans between them look like the path. Positions are single
/// precision offsets from `origin`: one part in 10^7 of the path's size.
struct SampledPath {
  Vec3 origin = Vec3::Zero();              ///< [mm]
  std::vector<Eigen::Vector3f> positions;  ///< offsets from origin [mm]
  std::vector<SpanKind> kinds;             ///< of the span that begins at the point
  std::vector<float> feeds;                ///< achieved [mm/s]; empty for a programmed path
  std::vector<double> times;               ///< [s]; empty for a programmed path
  double peak_feed = 0;                    ///< largest of `feeds` on spans that are not rapid [mm/s]
  Bounds bounds;                           ///< [mm]

  std::size_t size() const { return positions.size(); }
  Vec3 position(std::size_t i) const { return origin + positions[i].cast<double>(); }
};

/// A path that needs more points than this leaves out those closer than path length / max_points to each
/// other; at most twice as many remain.
inline constexpr std::size_t default_max_points = 4'000'000;

/// The programmed path: ends of lines, arcs every 3 degrees (coarser where the budget ends).
SampledPath sample_programmed(const Toolpath& toolpath, std::size_t max_points = default_max_points);

/// The executed path: arcs every 3 degrees, blends in 24 spans, and wherever the feed changes by some 1/24 of
/// its peak. Linear in the pieces. Safe to call off the GUI thread.
SampledPath sample_executed(const Trajectory& trajectory, std::size_t max_points = default_max_points);

/// `path` without the points closer than `spacing` [mm] to the one kept before them; for views in which that
/// is less than a pixel.
SampledPath thinned(const SampledPath& path, double spacing);

/// Length of the spans of one kind [mm].
double length_of(const SampledPath& path, SpanKind kind);

}  // namespace feedscope::ui
