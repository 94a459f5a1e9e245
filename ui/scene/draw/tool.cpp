#include "ui/scene/draw/tool.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/units.h"

namespace feedscope::ui {
namespace {

constexpr double marker_pixels = 34;
constexpr double marker_radius = 0.26;  // of its height
constexpr double cutter_length = 4;     // of its diameter
constexpr double min_diameter = 1e-3;
constexpr double largest_diameter = 1000;

/// Half section from the tip to the top: radius and height.
using Section = std::vector<Vec2>;

Section section_of(const ToolShape& shape, double length) {
  if (shape.kind == ToolKind::marker) {
    return {{0, 0}, {marker_radius * length, length}, {0, length}};
  }
  const double radius = shape.diameter / 2;
  const double corner = shape.kind == ToolKind::ball   ? radius
                        : shape.kind == ToolKind::bull ? std::clamp(shape.corner_radius, 0.0, radius)
                                                       : 0.0;
  Section section{{0, 0}};
  constexpr int steps = 16;
  for (int i = 0; i <= steps && corner > 0; ++i) {
    const double angle = units::pi / 2 * i / steps;
    section.emplace_back(radius - corner + corner * std::sin(angle), corner * (1 - std::cos(angle)));
  }
  if (corner == 0) {
    section.emplace_back(radius, 0);
  }
  section.emplace_back(radius, length);
  section.emplace_back(0, length);
  return section;
}

/// The surface of revolution about Z, with quads anticlockwise from outside.
vtkSmartPointer<vtkPolyData> turned(const Section& section) {
  constexpr int around = 48;
  const vtkNew<vtkPoints> points;
  const vtkNew<vtkCellArray> quads;
  const auto rings = static_cast<vtkIdType>(section.size());
  for (const Vec2& p : section) {
    for (int i = 0; i < around; ++i) {
      const double angle = 2 * units::pi * i / around;
      points->InsertNextPoint(p.x() * std::cos(angle), p.x() * std::sin(angle), p.y());
    }
  }
  for (vtkIdType ring = 0; ring + 1 < rings; ++ring) {
    for (vtkIdType i = 0; i < around; ++i) {
      const vtkIdType next = (i + 1) % around;
      const vtkIdType low = ring * around;
      const vtkIdType high = low + around;
      const vtkIdType corners[] = {low + i, low + next, high + next, high + i};
      quads->InsertNextCell(4, corners);
    }
  }
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(points);
  surface->SetPolys(quads);
  return surface;
}

}  // namespace

Tool::Tool(vtkRenderer& renderer) {
  actor_->SetMapper(mapper_);
  vtkProperty& look = *actor_->GetProperty();
  look.SetAmbient(0.35);
  look.SetDiffuse(0.75);
  look.SetOpacity(0.65);  // from above it must not hide the path
  look.BackfaceCullingOn();
  actor_->SetVisibility(0);
  renderer.AddActor(actor_);
  set_shape({});
}

Tool::~Tool() = default;

double Tool::length() const {
  return shape_.kind == ToolKind::marker ? 1 : cutter_length * shape_.diameter;
}

void Tool::set_shape(const ToolShape& shape) {
  shape_ = shape;
  shape_.diameter = std::clamp(shape.diameter, min_diameter, largest_diameter);
  shape_.corner_radius = std::clamp(shape.corner_radius, 0.0, shape_.diameter / 2);
  const vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(turned(section_of(shape_, length())));
  normals->SetFeatureAngle(40);
  normals->ConsistencyOff();
  normals->Update();
  mapper_->SetInputData(normals->GetOutput());
}

void Tool::set_colour(const Rgb& colour) {
  actor_->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
}

void Tool::place(const std::optional<Vec3>& tip, const Vec3& direction, const Projection& view,
                 const SceneFrame& frame, double scale) {
  const bool shown = tip && shape_.kind != ToolKind::none;
  actor_->SetVisibility(shown ? 1 : 0);
  if (shown) {
    actor_->SetPosition(tip->x(), tip->y(), tip->z());
    const Eigen::AngleAxisd turn(Eigen::Quaterniond::FromTwoVectors(Vec3::UnitZ(), direction));
    actor_->SetOrientation(0, 0, 0);
    actor_->RotateWXYZ(units::to_deg(turn.angle()), turn.axis().x(), turn.axis().y(), turn.axis().z());
    actor_->SetScale(shape_.kind == ToolKind::marker
                         ? marker_pixels * scale / view.scale / view.magnification(*tip)
                         : 1 / frame.unit);
  }
}

double Tool::reach(const Projection& view, const SceneFrame& frame, double scale) const {
  return shape_.kind == ToolKind::marker ? 2 * marker_pixels * scale / view.scale : 2 * length() / frame.unit;
}

}  // namespace feedscope::ui
