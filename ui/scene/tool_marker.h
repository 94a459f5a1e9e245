#pragma once

#include <vtkNew.h>

#include <optional>

#include "ui/scene/projection.h"

class vtkActor;
class vtkRenderer;

namespace feedscope::ui {

/// A cone with its tip on the path, of one size on the screen and in front of everything.
class ToolMarker {
 public:
  explicit ToolMarker(vtkRenderer& renderer);
  ~ToolMarker();

  /// Before each frame. None hides the marker.
  void place(const std::optional<Vec3>& tip, const Projection& view, double scale);
  /// How far it reaches towards the eye from the scene [scene units].
  static double reach(const Projection& view, double scale);

 private:
  vtkNew<vtkActor> actor_;
};

}  // namespace feedscope::ui
