#include "ui/scene/path/path_stretch.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPlaneCollection.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>

#include "ui/scene/path/path_actors.h"

namespace feedscope::ui {

namespace {

double time_of(const PathPart& part, std::size_t k) {
  return part.path().times[part[k]];
}

/// Drawn place of a time between point `k` and the next one.
Eigen::Vector3d place_at(const PathPart& part, std::size_t k, double time) {
  const double span = time_of(part, k + 1) - time_of(part, k);
  const double share = span > 0 ? std::clamp((time - time_of(part, k)) / span, 0.0, 1.0) : 1.0;
  return part.position(k) + share * (part.position(k + 1) - part.position(k));
}

}  // namespace

std::optional<TimeStretch> StretchChoice::times(const std::optional<TimeStretch>& charts,
                                                const std::optional<double>& cursor) const {
  if (stretch == PathStretch::to_cursor && cursor) {
    return TimeStretch{0, *cursor};
  }
  return stretch == PathStretch::charts ? charts : std::nullopt;
}

PartWindow window_within(const PathPart& part, const std::optional<TimeStretch>& times) {
  if (!times) {
    return {0, part.size()};
  }
  const auto& points = part.points_of_path();
  const auto at = [&](std::uint32_t point) { return part.path().times[point]; };
  const auto first = std::ranges::lower_bound(points, (*times)[0], {}, at) - points.begin();
  const auto end = std::ranges::upper_bound(points, (*times)[1], {}, at) - points.begin();
  return {static_cast<std::size_t>(first), static_cast<std::size_t>(std::max(first, end))};
}

vtkSmartPointer<vtkCellArray> polylines_outside(const PathPart& part, const TimeStretch& times,
                                                const std::function<bool(SpanKind)>& wanted) {
  const PartWindow inside = window_within(part, times);
  if (inside.end == inside.first) {
    return polylines(part, 0, part.size(), wanted);
  }
  auto cells = polylines(part, 0, inside.first + 1, wanted);
  cells->Append(polylines(part, inside.end - 1, part.size(), wanted));
  return cells;
}

vtkSmartPointer<vtkPolyData> ends_of(const PathPart& part, const TimeStretch& times,
                                     const std::function<bool(SpanKind)>& wanted) {
  const vtkNew<vtkPoints> points;
  const vtkNew<vtkCellArray> cells;
  const vtkNew<vtkUnsignedCharArray> colours;
  colours->SetNumberOfComponents(4);
  const PartWindow inside = window_within(part, times);
  /// Adds a piece of the span from point `k`.
  const auto add = [&](std::size_t k, double from, double to) {
    if (k + 1 >= part.size() || !part.joined(k) || !wanted(part.kind(k)) || from >= to) {
      return;
    }
    const vtkIdType ends[] = {points->InsertNextPoint(place_at(part, k, from).data()),
                              points->InsertNextPoint(place_at(part, k, to).data())};
    cells->InsertNextCell(2, ends);
    for (std::size_t i = 0; i < 2 && part.coloured(); ++i) {
      colours->InsertNextTypedTuple(part.colour(k).data());
    }
  };
  if (inside.first == inside.end) {
    if (inside.first > 0) {
      add(inside.first - 1, times[0], times[1]);
    }
  } else {
    if (inside.first > 0) {
      add(inside.first - 1, times[0], time_of(part, inside.first));
    }
    add(inside.end - 1, time_of(part, inside.end - 1), times[1]);
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetLines(cells);
  if (part.coloured()) {
    data->GetPointData()->SetScalars(colours);
  }
  return data;
}

vtkSmartPointer<vtkPlaneCollection> planes_around(const Vec3& low, const Vec3& high, double margin) {
  auto planes = vtkSmartPointer<vtkPlaneCollection>::New();
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      const Vec3 inwards = -side * Vec3::Unit(axis);
      const Vec3 at = (side < 0 ? low : high) - margin * inwards;
      const vtkNew<vtkPlane> plane;
      plane->SetNormal(inwards.data());
      plane->SetOrigin(at.data());
      planes->AddItem(plane);
    }
  }
  return planes;
}

}  // namespace feedscope::ui
