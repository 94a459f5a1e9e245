#pragma once

#include <vtkSmartPointer.h>

#include <optional>

#include "ui/scene/camera/projection.h"
#include "ui/scene/colour_map.h"
#include "ui/scene/path/drawn_path.h"

class vtkActor;
class vtkRenderer;

namespace feedscope::ui {

/// Where the tool has been a moment before: a line over the executed path, rapids included, that fades
/// towards its beginning.
class PathTrail {
 public:
  explicit PathTrail(vtkRenderer& renderer);
  ~PathTrail();

  /// How far back it reaches [s]; 0: there is none.
  void set_length(double seconds) { length_ = seconds; }
  /// It ends at `time` [s], where the tip of the tool is drawn [mm]; none: there is none.
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
