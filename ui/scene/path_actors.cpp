#include "ui/scene/path_actors.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkLookupTable.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkTypeInt32Array.h>

#include <algorithm>

#include "core/base/units.h"

namespace feedscope::ui {
namespace {

static_assert(sizeof(Eigen::Vector3f) == 3 * sizeof(float), "VTK reads the positions as packed triples");

/// A view of `count` values that VTK reads and does not free.
vtkSmartPointer<vtkFloatArray> borrowed(const float* values, std::size_t count, int components) {
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetNumberOfComponents(components);
  constexpr int do_not_free = 1;
  array->SetArray(const_cast<float*>(values), static_cast<vtkIdType>(count), do_not_free);
  return array;
}

/// The points of `path`, with their feed as scalars.
vtkSmartPointer<vtkPolyData> points_of(const SampledPath& path) {
  auto data = vtkSmartPointer<vtkPolyData>::New();
  const vtkNew<vtkPoints> points;
  if (path.size() > 0) {
    points->SetData(borrowed(path.positions.front().data(), 3 * path.size(), 3));
  }
  data->SetPoints(points);
  if (!path.feeds.empty()) {
    data->GetPointData()->SetScalars(borrowed(path.feeds.data(), path.feeds.size(), 1));
  }
  return data;
}

}  // namespace

vtkSmartPointer<vtkPolyData> polylines(const SampledPath& path, const std::function<bool(SpanKind)>& wanted) {
  auto lines = points_of(path);
  const vtkNew<vtkTypeInt32Array> offsets;
  const vtkNew<vtkTypeInt32Array> indices;
  offsets->InsertNextValue(0);
  bool open = false;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    if (!wanted(path.kinds[i])) {
      if (open) {
        offsets->InsertNextValue(static_cast<int>(indices->GetNumberOfValues()));
        open = false;
      }
      continue;
    }
    if (!open) {
      indices->InsertNextValue(static_cast<int>(i));
      open = true;
    }
    indices->InsertNextValue(static_cast<int>(i + 1));
  }
  if (open) {
    offsets->InsertNextValue(static_cast<int>(indices->GetNumberOfValues()));
  }
  const vtkNew<vtkCellArray> cells;
  cells->SetData(offsets, indices);
  lines->SetLines(cells);
  return lines;
}

vtkSmartPointer<vtkPolyData> blend_points(const SampledPath& path) {
  constexpr std::size_t most_points = 100'000;
  const auto count =
      static_cast<std::size_t>(std::count(path.kinds.begin(), path.kinds.end(), SpanKind::blend));
  const std::size_t step = 1 + count / most_points;
  auto points = points_of(path);
  const vtkNew<vtkCellArray> cells;
  std::size_t seen = 0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const bool ends_blend = i > 0 && path.kinds[i - 1] == SpanKind::blend;
    if ((path.kinds[i] == SpanKind::blend || ends_blend) && seen++ % step == 0) {
      const auto id = static_cast<vtkIdType>(i);
      cells->InsertNextCell(1, &id);
    }
  }
  points->SetVerts(cells);
  return points;
}

vtkSmartPointer<vtkPolyData> rapid_dashes(const SampledPath& path, double dash) {
  constexpr double most_dashes = 100'000;
  double length = 0;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    if (path.kinds[i] == SpanKind::rapid) {
      length += static_cast<double>((path.positions[i + 1] - path.positions[i]).norm());
    }
  }
  const double step = std::max(dash, length / most_dashes / 2);

  auto lines = vtkSmartPointer<vtkPolyData>::New();
  const vtkNew<vtkPoints> points;
  const vtkNew<vtkCellArray> cells;
  const auto add = [&](const Eigen::Vector3f& p, const Eigen::Vector3f& q) {
    const vtkIdType ends[] = {points->InsertNextPoint(p.data()), points->InsertNextPoint(q.data())};
    cells->InsertNextCell(2, ends);
  };
  bool drawing = true;
  double left = step;  // of the present dash or gap [mm]
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    if (path.kinds[i] != SpanKind::rapid) {
      drawing = true;
      left = step;
      continue;
    }
    const Eigen::Vector3f span = path.positions[i + 1] - path.positions[i];
    const double span_length = static_cast<double>(span.norm());
    double done = 0;
    while (done < span_length) {
      const double advance = std::min(left, span_length - done);
      if (drawing) {
        const auto at = [&](double s) -> Eigen::Vector3f {
          return path.positions[i] + span * static_cast<float>(s / span_length);
        };
        add(at(done), at(done + advance));
      }
      done += advance;
      left -= advance;
      if (left <= 1e-6 * step) {
        left = step;
        drawing = !drawing;
      }
    }
  }
  lines->SetPoints(points);
  lines->SetLines(cells);
  return lines;
}

vtkSmartPointer<vtkLookupTable> feed_colours(double top_feed) {
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(colour_map_size);
  table->SetTableRange(0, top_feed > 0 ? top_feed : 1);
  for (std::size_t i = 0; i < colour_map_size; ++i) {
    const Rgb c = map_colour(static_cast<double>(i) / (colour_map_size - 1));
    table->SetTableValue(static_cast<vtkIdType>(i), c[0], c[1], c[2]);
  }
  return table;
}

vtkSmartPointer<vtkActor> line_actor(vtkPolyData& lines, const Rgb& colour) {
  const vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(&lines);
  mapper->ScalarVisibilityOff();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->RenderPointsAsSpheresOn();  // without light: discs
  return actor;
}

vtkSmartPointer<vtkActor> line_actor(vtkPolyData& lines, vtkLookupTable& colours) {
  auto actor = line_actor(lines, palette::text);
  auto* mapper = vtkPolyDataMapper::SafeDownCast(actor->GetMapper());
  mapper->ScalarVisibilityOn();
  mapper->SetLookupTable(&colours);
  mapper->UseLookupTableScalarRangeOn();
  mapper
      ->InterpolateScalarsBeforeMappingOn();  // between two points: the feed is interpolated, not the colour
  return actor;
}

}  // namespace feedscope::ui
