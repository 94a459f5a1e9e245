#pragma once

#include <cstdint>
#include <vector>

#include "core/toolpath/toolpath.h"

namespace feedscope {

/// `filtered`: a segment as smoothing filters draw it; its course is known to the motion alone.
enum class ElementKind : std::uint8_t { line, arc, blend, dwell, filtered };

/// One geometric piece of the path that the control executes.
struct PathElement {
  Vec3 start;                  ///< [mm]
  Vec3 end;                    ///< [mm]
  double s = 0;                ///< path length at the start, from the path's beginning [mm]
  double length = 0;           ///< [mm]; 0 for a dwell
  double arc_offset = 0;       ///< arcs: path length on the arc at the element's start [mm]
  std::uint32_t segment = 0;   ///< of the programmed path; for a blend the one that ends at its corner
  std::uint32_t geometry = 0;  ///< index into arcs or blends; filtered: into Trajectory::motions
  ElementKind kind = ElementKind::line;
};

/// The executed geometry: programmed segments, shortened where corner blends are inserted.
/// Keeps what it needs of the programmed path, so that it can be shown without it.
struct BlendedPath {
  std::vector<PathElement> elements;  ///< in order, without gaps
  std::vector<Arc> arcs;
  std::vector<CubicBlend> blends;

  double length() const { return elements.empty() ? 0 : elements.back().s + elements.back().length; }
  /// Position and derivatives by path length (arc length) at `s` from the element's start [mm]. For a
  /// filtered element the chord from start to end stands in; Trajectory::state_at_path follows the course
  /// itself.
  CurvePoint at(const PathElement& element, double s) const;
};

}  // namespace feedscope
