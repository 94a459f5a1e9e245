#pragma once

#include <vtkNew.h>

#include <cstdint>
#include <optional>

#include "ui/scene/camera/projection.h"
#include "ui/scene/colour_map.h"

class vtkActor;
class vtkPolyDataMapper;
class vtkRenderer;

namespace feedscope::ui {

enum class ToolKind : std::uint8_t {
  none,    ///< no tool
  marker,  ///< a cone of constant size on the screen
  flat,    ///< end mill
  ball,
  bull,  ///< end mill with rounded corners
};

/// Shape drawn with its tip on the path, along the tool's direction. Sizes are used for milling cutters only.
struct ToolShape {
  ToolKind kind = ToolKind::marker;
  double diameter = 10;      ///< > 0 [mm]
  double corner_radius = 1;  ///< of a bull nose, at most half the diameter [mm]
  bool operator==(const ToolShape&) const = default;
};

/// The tool, lit, in a separate renderer above the path, which it never hides fully.
class Tool {
 public:
  explicit Tool(vtkRenderer& renderer);
  ~Tool();

  /// Clamps sizes to their bounds.
  void set_shape(const ToolShape& shape);
  const ToolShape& shape() const { return shape_; }
  void set_colour(const Rgb& colour);
  /// Before each frame. None hides the tool. `direction`: unit, from the tip to the spindle.
  void place(const std::optional<Vec3>& tip, const Vec3& direction, const Projection& view,
             const SceneFrame& frame, double scale);
  /// Largest extent from its tip [scene units].
  double reach(const Projection& view, const SceneFrame& frame, double scale) const;

 private:
  double length() const;

  ToolShape shape_;
  vtkNew<vtkPolyDataMapper> mapper_;
  vtkNew<vtkActor> actor_;
};

}  // namespace feedscope::ui
