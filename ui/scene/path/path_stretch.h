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

/// Which stretch of the executed path is drawn in full; the rest is pale or hidden.
enum class PathStretch {
  whole,
  charts,     ///< what the charts show
  to_cursor,  ///< what has been run up to the cursor
};

/// First and last time of a stretch [s].
using TimeStretch = std::array<double, 2>;

/// What a user wants to see of the executed path.
struct StretchChoice {
  PathStretch stretch = PathStretch::whole;
  bool rest_hidden = false;  ///< and what else lies outside of the box around the stretch; otherwise pale

  /// The times of the stretch; none: all of the path. `charts`: what the charts show, none: all; `cursor`:
  /// its time [s].
  std::optional<TimeStretch> times(const std::optional<TimeStretch>& charts,
                                   const std::optional<double>& cursor) const;
  bool operator==(const StretchChoice&) const = default;
};

/// Points of a part from `first` to `end` - 1.
struct PartWindow {
  std::size_t first = 0;
  std::size_t end = 0;
};

/// The points within `times`; all of them without. Needs an executed path.
PartWindow window_within(const PathPart& part, const std::optional<TimeStretch>& times);

/// Spans that `wanted` accepts and that are not between points within `times`.
vtkSmartPointer<vtkCellArray> polylines_outside(const PathPart& part, const TimeStretch& times,
                                                const std::function<bool(SpanKind)>& wanted);

/// From where the path is at the ends of `times` to the next points within, of spans that `wanted` accepts:
/// what window_within() leaves out of a long span. Coloured as the point before.
vtkSmartPointer<vtkPolyData> ends_of(const PathPart& part, const TimeStretch& times,
                                     const std::function<bool(SpanKind)>& wanted);

/// What cuts off all that is more than `margin` outside of a box.
vtkSmartPointer<vtkPlaneCollection> planes_around(const Vec3& low, const Vec3& high, double margin);

}  // namespace feedscope::ui
