#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "core/toolpath/toolpath.h"
#include "core/trajectory/trajectory.h"

class vtkRenderWindow;

namespace feedscope::ui {

struct SampledPath;

/// Where the camera looks from. Parallel projection, so that lengths can be read off.
enum class StandardView : std::uint8_t {
  iso,    ///< from right, front and above
  top,    ///< along -Z: X to the right, Y up
  front,  ///< along +Y: X to the right, Z up
  right,  ///< along -X: Y to the right, Z up
};

/// Pixel of the window, device pixels from its upper left corner.
using Pixel = std::array<double, 2>;

/// One run in 3D: programmed path, executed path coloured by feed, frame with units, colour bar, legend,
/// tool. Knows no widget; draws into the window it is attached to. All calls from the thread that draws.
class PathScene {
 public:
  PathScene();
  ~PathScene();

  /// Draws into `window` until detach() or the window's end; a scene has one window.
  void attach(vtkRenderWindow& window);
  void detach();
  /// Called after each change that needs a new frame.
  void on_change(std::function<void()> callback);

  /// Null takes the path away. The camera is fitted again until the user has turned or moved it.
  void set_programmed(std::shared_ptr<const Toolpath> toolpath);
  /// As above, with `samples` = sample_programmed(*toolpath) made off this thread.
  void set_programmed(std::shared_ptr<const SampledPath> samples);
  void set_executed(std::shared_ptr<const Trajectory> trajectory);
  /// As above, with `samples` = sample_executed(*trajectory) made off this thread.
  void set_executed(std::shared_ptr<const Trajectory> trajectory, std::shared_ptr<const SampledPath> samples);
  /// Tip of the tool marker [mm]; none hides it.
  void set_cursor(const std::optional<Vec3>& tip);

  void set_standard_view(StandardView view);
  /// Everything in the window, without turning.
  void fit();
  /// Size of text and lines; 1 suits 96 dots an inch.
  void set_scale(double scale);

  /// Time [s] at which the executed path comes nearest to a pixel, if within `radius` [pixels of scale 1].
  /// Linear in the points drawn. The camera is that of the last frame or standard view.
  std::optional<double> pick_time(const Pixel& pixel, double radius = 8) const;
  /// Where a point [mm] is drawn.
  Pixel pixel_of(const Vec3& point) const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace feedscope::ui
