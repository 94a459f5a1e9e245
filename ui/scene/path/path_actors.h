#pragma once

#include <vtkSmartPointer.h>

#include <functional>

#include "ui/scene/path/path_part.h"
#include "ui/scene/sampled_path.h"

class vtkActor;
class vtkCellArray;
class vtkPolyData;

namespace feedscope::ui {

/// Those of the points of `part` from `first` to `end` - 1 that are joined by spans that `wanted` accepts, as
/// polylines.
vtkSmartPointer<vtkCellArray> polylines(const PathPart& part, std::size_t first, std::size_t end,
                                        const std::function<bool(SpanKind)>& wanted);

/// The same by the point at which a span begins.
vtkSmartPointer<vtkCellArray> polylines(const PathPart& part, std::size_t first, std::size_t end,
                                        const std::function<bool(std::size_t)>& wanted);

/// Those of the points of a part from `first` to `end` - 1 that are wanted, or every n-th of them where there
/// are more than 100 000: drawn as discs, they round the joins of wide lines and show what is smaller than a
/// pixel.
vtkSmartPointer<vtkCellArray> points_of(std::size_t first, std::size_t end,
                                        const std::function<bool(std::size_t)>& wanted);

/// The rapids of `path` as dashes of `dash` mm with gaps as long, the pattern running on over consecutive
/// spans; dashes grow where there would be more than 100 000.
vtkSmartPointer<vtkPolyData> rapid_dashes(const SampledPath& path, double dash);

/// Unlit lines or points of one colour, or coloured by the scalars of `lines`.
vtkSmartPointer<vtkActor> line_actor(vtkPolyData& lines, bool coloured);

}  // namespace feedscope::ui
