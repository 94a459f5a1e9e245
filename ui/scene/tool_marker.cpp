#include "ui/scene/tool_marker.h"

#include <vtkActor.h>
#include <vtkConeSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include "ui/scene/colour_map.h"

namespace feedscope::ui {
namespace {

constexpr double height_pixels = 34;
constexpr double before_everything = 2;  // scene units; a parallel projection does not show it

}  // namespace

ToolMarker::ToolMarker(vtkRenderer& renderer) {
  const vtkNew<vtkConeSource> cone;  // tip at the origin, opening upwards
  cone->SetDirection(0, 0, -1);
  cone->SetHeight(1);
  cone->SetRadius(0.26);
  cone->SetCenter(0, 0, 0.5);
  cone->SetResolution(48);
  const vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(cone->GetOutputPort());
  actor_->SetMapper(mapper);
  vtkProperty& look = *actor_->GetProperty();
  look.SetColor(palette::tool[0], palette::tool[1], palette::tool[2]);
  look.SetAmbient(0.35);
  look.SetDiffuse(0.75);
  look.SetOpacity(0.65);  // seen from above it must not hide the path
  look.BackfaceCullingOn();
  actor_->SetVisibility(0);
  renderer.AddActor(actor_);
}

ToolMarker::~ToolMarker() = default;

void ToolMarker::place(const std::optional<Vec3>& tip, const Projection& view, double scale) {
  actor_->SetVisibility(tip ? 1 : 0);
  if (tip) {
    const Vec3 at = *tip + before_everything * view.towards;
    actor_->SetPosition(at.x(), at.y(), at.z());
    actor_->SetScale(height_pixels * scale / view.scale);
  }
}

double ToolMarker::reach(const Projection& view, double scale) {
  return before_everything + height_pixels * scale / view.scale;
}

}  // namespace feedscope::ui
