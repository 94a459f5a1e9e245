#pragma once

#include <vtkSmartPointer.h>

#include <optional>

#include "ui/scene/camera/projection.h"
#include "ui/scene/colour_map.h"
#include "ui/scene/path/drawn_path.h"

class vtkActor;
class vtkRenderer;

namespace feedscope::ui {

/// The tool's recent way: a line over the executed path, including rapids, that fades towards its start.
class PathTrail {
 public:
  explicit PathTrail(vtkRenderer& renderer);
  ~PathTrail();

  /// Its duration [s]; 0: no trail.
  void set_length(double seconds) { length_ = seconds; }
  /// Its end: `time` [s] and the drawn tip of the tool [mm]; none: no trail.
  void end_at(const std::optional<double>& time, const std::optional<Vec3>& tip);
  /// Before each frame. `path`: the executed one, null for none.
  void place(const DrawnPath* path, const Rgb& colour, const SceneFrame& frame, const Projection& view,
             double scale);

 private:
  double length_ = 0;
  std::optional<double> time_;
  Vec3 tip_ = Vec3::Zero();
  vtkSmartPointer<vtkActor> actor_;
};

}  // namespace feedscope::ui
