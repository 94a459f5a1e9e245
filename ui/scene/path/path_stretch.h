#pragma once

#include <vtkSmartPointer.h>

#include <array>
#include <cstddef>
#include <functional>
#include <optional>

#include "ui/scene/path/path_part.h"

class vtkCellArray;
class vtkPlaneCollection;
class vtkPolyData;

namespace feedscope::ui {

/// Range of the executed path that is drawn in full; the rest is pale or hidden.
enum class PathStretch {
  whole,
  charts,     ///< the range of the charts
  to_cursor,  ///< up to the cursor
};

/// First and last time of a range [s].
using TimeStretch = std::array<double, 2>;

/// The user's choice of the visible executed path.
struct StretchChoice {
  PathStretch stretch = PathStretch::whole;
  bool rest_hidden = false;  ///< including everything outside of the box around the range; otherwise pale

  /// The times of the range; none: the whole path. `charts`: range of the charts, none: all; `cursor`: its
  /// time [s].
  std::optional<TimeStretch> times(const std::optional<TimeStretch>& charts,
                                   const std::optional<double>& cursor) const;
  bool operator==(const StretchChoice&) const = default;
};

/// Points of a part from `first` to `end` - 1.
struct PartWindow {
  std::size_t first = 0;
  std::size_t end = 0;
};

/// The points within `times`; without it all of them. Requires an executed path.
PartWindow window_within(const PathPart& part, const std::optional<TimeStretch>& times);

/// Spans that `wanted` accepts and that are not between points within `times`.
vtkSmartPointer<vtkCellArray> polylines_outside(const PathPart& part, const TimeStretch& times,
                                                const std::function<bool(SpanKind)>& wanted);

/// Pieces from the path's places at the ends of `times` to the next points within, for spans that `wanted`
/// accepts: the part of a long span that window_within() omits. Coloured as the previous point.
vtkSmartPointer<vtkPolyData> ends_of(const PathPart& part, const TimeStretch& times,
                                     const std::function<bool(SpanKind)>& wanted);

/// Planes that clip everything more than `margin` outside of a box.
vtkSmartPointer<vtkPlaneCollection> planes_around(const Vec3& low, const Vec3& high, double margin);

}  // namespace feedscope::ui
