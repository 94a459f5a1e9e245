#pragma once

#include <vtkSmartPointer.h>

#include <functional>

#include "ui/scene/path/path_part.h"
#include "ui/scene/sampled_path.h"

class vtkActor;
class vtkCellArray;
class vtkPolyData;

namespace feedscope::ui {

/// Points of `part` from `first` to `end` - 1, joined by the spans that `wanted` accepts, as polylines.
vtkSmartPointer<vtkCellArray> polylines(const PathPart& part, std::size_t first, std::size_t end,
                                        const std::function<bool(SpanKind)>& wanted);

/// As above, where `wanted` is called with the first point of a span.
vtkSmartPointer<vtkCellArray> polylines(const PathPart& part, std::size_t first, std::size_t end,
                                        const std::function<bool(std::size_t)>& wanted);

/// The wanted points of a part from `first` to `end` - 1, or every n-th of them if there are more than 100
/// 000. Drawn as discs, they round the joins of wide lines and show parts smaller than a pixel.
vtkSmartPointer<vtkCellArray> points_of(std::size_t first, std::size_t end,
                                        const std::function<bool(std::size_t)>& wanted);

/// The rapids of `path` as dashes of `dash` mm with equal gaps, in a pattern that continues over consecutive
/// spans; dashes grow if there would be more than 100 000.
vtkSmartPointer<vtkPolyData> rapid_dashes(const SampledPath& path, double dash);

/// Unlit lines or points of one colour, or coloured by the scalars of `lines`.
vtkSmartPointer<vtkActor> line_actor(vtkPolyData& lines, bool coloured);

}  // namespace feedscope::ui
