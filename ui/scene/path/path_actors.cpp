#include "ui/scene/path/path_actors.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkOpenGLPolyDataMapper.h>
#include <vtkOpenGLVertexBufferObject.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkTypeInt32Array.h>

#include <algorithm>

namespace feedscope::ui {

vtkSmartPointer<vtkCellArray> polylines(const PathPart& part, std::size_t first, std::size_t end,
                                        const std::function<bool(SpanKind)>& wanted) {
  return polylines(part, first, end, [&](std::size_t k) { return wanted(part.kind(k)); });
}

vtkSmartPointer<vtkCellArray> polylines(const PathPart& part, std::size_t first, std::size_t end,
                                        const std::function<bool(std::size_t)>& wanted) {
  const vtkNew<vtkTypeInt32Array> offsets;
  const vtkNew<vtkTypeInt32Array> indices;
  offsets->InsertNextValue(0);
  bool open = false;
  const auto close = [&] {
    if (open) {
      offsets->InsertNextValue(static_cast<int>(indices->GetNumberOfValues()));
    }
    open = false;
  };
  for (std::size_t k = first; k + 1 < end; ++k) {
    if (!part.joined(k) || !wanted(k)) {
      close();
      continue;
    }
    if (!open) {
      indices->InsertNextValue(static_cast<int>(k));
      open = true;
    }
    indices->InsertNextValue(static_cast<int>(k + 1));
  }
  close();
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(offsets, indices);
  return cells;
}

vtkSmartPointer<vtkCellArray> points_of(std::size_t first, std::size_t end,
                                        const std::function<bool(std::size_t)>& wanted) {
  constexpr std::size_t max_points = 100'000;
  std::size_t count = 0;
  for (std::size_t k = first; k < end; ++k) {
    count += wanted(k) ? 1 : 0;
  }
  const std::size_t step = 1 + count / max_points;
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  std::size_t seen = 0;
  for (std::size_t k = first; k < end; ++k) {
    if (wanted(k) && seen++ % step == 0) {
      const auto id = static_cast<vtkIdType>(k);
      cells->InsertNextCell(1, &id);
    }
  }
  return cells;
}

vtkSmartPointer<vtkPolyData> rapid_dashes(const SampledPath& path, double dash) {
  constexpr double max_dashes = 100'000;
  double length = 0;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    if (path.kinds[i] == SpanKind::rapid) {
      length += static_cast<double>((path.positions[i + 1] - path.positions[i]).norm());
    }
  }
  const double step = std::max(dash, length / max_dashes / 2);

  auto lines = vtkSmartPointer<vtkPolyData>::New();
  const vtkNew<vtkPoints> points;
  const vtkNew<vtkCellArray> cells;
  const auto add = [&](const Eigen::Vector3f& p, const Eigen::Vector3f& q) {
    const vtkIdType ends[] = {points->InsertNextPoint(p.data()), points->InsertNextPoint(q.data())};
    cells->InsertNextCell(2, ends);
  };
  bool drawing = true;
  double left = step;  // of the current dash or gap [mm]
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    if (path.kinds[i] != SpanKind::rapid) {
      drawing = true;
      left = step;
      continue;
    }
    // In double precision: a rapid may be far longer than a small part.
    const Eigen::Vector3d from = path.positions[i].cast<double>();
    const Eigen::Vector3d span = path.positions[i + 1].cast<double>() - from;
    const double span_length = span.norm();
    double done = 0;
    while (done < span_length) {
      const double advance = std::min(left, span_length - done);
      if (drawing) {
        const auto at = [&](double s) -> Eigen::Vector3f {
          return (from + s / span_length * span).cast<float>();
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

vtkSmartPointer<vtkActor> line_actor(vtkPolyData& lines, bool coloured) {
  const vtkNew<vtkOpenGLPolyDataMapper> mapper;
  mapper->SetInputData(&lines);
  mapper->SetScalarVisibility(coloured ? 1 : 0);
  mapper->SetVBOShiftScaleMethod(vtkOpenGLVertexBufferObject::DISABLE_SHIFT_SCALE);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->RenderPointsAsSpheresOn();  // without light: discs
  return actor;
}

}  // namespace feedscope::ui
