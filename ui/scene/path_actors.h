#pragma once

#include <vtkSmartPointer.h>

#include <functional>
#include <memory>

#include "ui/scene/colour_map.h"
#include "ui/scene/sampled_path.h"

class vtkActor;
class vtkLookupTable;
class vtkPolyData;

namespace feedscope::ui {

/// Spans of `path` that `wanted` accepts, as polylines on the path's own points, feed as scalars if it has
/// any. Nothing is copied but the indices: `path` must outlive the result.
vtkSmartPointer<vtkPolyData> polylines(const SampledPath& path, const std::function<bool(SpanKind)>& wanted);

/// The points of `path` in blends, or every n-th of them where there are more than 100 000: drawn as discs,
/// they round the joins of wide lines and show blends that are smaller than a pixel.
vtkSmartPointer<vtkPolyData> blend_points(const SampledPath& path);

/// The rapids of `path` as dashes of `dash` mm with gaps as long, the pattern running on over consecutive
/// spans; dashes grow where there would be more than 100 000.
vtkSmartPointer<vtkPolyData> rapid_dashes(const SampledPath& path, double dash);

/// Colours of feed from 0 to `top_feed` [mm/s].
vtkSmartPointer<vtkLookupTable> feed_colours(double top_feed);

/// Unlit lines or points of one colour.
vtkSmartPointer<vtkActor> line_actor(vtkPolyData& lines, const Rgb& colour);
/// Unlit lines or points coloured by their scalars.
vtkSmartPointer<vtkActor> line_actor(vtkPolyData& lines, vtkLookupTable& colours);

}  // namespace feedscope::ui
