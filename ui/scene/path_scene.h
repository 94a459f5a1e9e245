#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/toolpath/toolpath.h"
#include "core/trajectory/trajectory.h"
#include "ui/scene/camera/scene_camera.h"
#include "ui/scene/draw/tool.h"
#include "ui/scene/path/path_layers.h"
#include "ui/scene/window_layers.h"

class vtkRenderWindow;

namespace feedscope::ui {

/// A dimension between two places, with its text.
struct SceneDimension {
  Vec3 from;               ///< [mm]
  std::optional<Vec3> to;  ///< none: only the first place is marked
  std::vector<std::string> lines;
};

/// One run in 3D: programmed path, executed path in meaningful colours, other runs, tool; with a legend of
/// lines and colours on top. Independent of widgets; draws into the attached window. All calls
/// from the drawing thread. Places are as drawn: with exaggerated deviations, on the drawn path.
class PathScene {
 public:
  PathScene();
  ~PathScene();

  /// Draws into `window` until detach() or the window's end; a scene has one window.
  void attach(vtkRenderWindow& window);
  void detach();
  /// Brings what the next frame draws up to date, without drawing it.
  void lay_out();
  /// Sets the function called after each change that needs a new frame.
  void on_change(std::function<void()> callback);

  /// Null removes the path. The camera is fitted again until the user turns or moves it.
  void set_programmed(std::shared_ptr<const Toolpath> toolpath);
  /// As above, with `samples` = sample_programmed(*toolpath) computed in another thread.
  void set_programmed(std::shared_ptr<const SampledPath> samples);
  void set_executed(std::shared_ptr<const Trajectory> trajectory);
  /// As above, with `samples` = sample_executed(*trajectory) computed in another thread.
  void set_executed(std::shared_ptr<const Trajectory> trajectory, std::shared_ptr<const SampledPath> samples);
  /// Other runs of the program; replaces the previous ones.
  void set_overlays(std::vector<OverlayRun> overlays);
  /// Whether to draw the actual path, if the executed path has one.
  void set_actual_shown(bool shown);
  bool actual_shown() const;
  /// Whether to draw the run at the machine's X, Y and Z, if known while rotary axes turn part or tool,
  /// instead of in the coordinates of the part.
  void set_on_machine(bool shown);
  bool on_machine() const;
  /// Whether these are known for the executed path.
  bool knows_machine() const;
  /// Whether the executed path has this source.
  bool has(QuantitySource source) const;
  /// Tip of the tool [mm]; none hides it.
  void set_cursor(const std::optional<Vec3>& tip);
  /// The tool at a state of the executed path.
  void set_cursor(const State& state);
  /// Draws the tool's way during this time before the cursor [s], including rapids; 0: none.
  void set_trail(double seconds);

  void set_colouring(Colouring colouring);
  Colouring colouring() const;
  /// Colour of the executed path for Colouring::run.
  void set_run_colour(const Rgb& colour);
  /// `reference`: name of the run that the samples of the executed path are compared with (sample_compared).
  /// `scale_with`: a path in another scene with the same colour scale, which covers both; null: none.
  void set_comparison(const std::string& reference, std::shared_ptr<const SampledPath> scale_with);
  /// Factor that enlarges deviations from the programmed path: 1 to 1000, clamped.
  void set_exaggeration(double factor);
  double exaggeration() const;
  /// Whether to draw rapids where they cover little of the picture.
  void set_rapids_shown(bool shown);
  bool rapids_shown() const;
  /// Whether to draw them also where they cover much of it.
  void set_all_rapids_shown(bool shown);
  bool all_rapids_shown() const;
  void set_tool(const ToolShape& shape);
  const ToolShape& tool() const;
  /// Whether to draw a box around the path with its size in mm and grids.
  void set_axes(bool shown);
  bool axes() const;
  /// Whether to explain lines and colours; not needed if a neighbouring scene does.
  void set_legend(bool shown);
  /// Whether legend and scales are in strips above and below the path instead of on top of it: for close-ups,
  /// which have no free area.
  void set_strip(bool shown);
  /// Whether to draw a cube whose faces are standard views, see cube_view().
  void set_cube(bool shown);
  /// A square with this side [pixels] is left free for something else, in the lower corner on the right or
  /// above the colours on the left, where a fitted path is larger.
  void set_inset(std::optional<double> side);
  /// Its upper left and its lower right corner.
  std::optional<std::array<Pixel, 2>> inset() const;
  void set_background(Background background);
  /// Without a background: uncovered pixels of the window have no opacity, and colours are multiplied by
  /// their opacity.
  void set_transparent(bool transparent);
  void set_texts(SceneTexts texts);
  /// Size of text and lines; 1 suits 96 dots per inch.
  void set_scale(double scale);

  void set_standard_view(StandardView view);
  /// Fits everything into the window, without turning.
  void fit();
  void set_perspective(bool perspective);
  bool perspective() const;
  CameraState camera() const;
  void set_camera(const CameraState& state);
  /// Turns like a drag of the mouse by `shift` pixels, to the right and downwards: the scene follows.
  /// `pivot`: a fixed place [mm]; none: the centre of the view.
  void orbit(const Pixel& shift, const std::optional<Vec3>& pivot = std::nullopt);
  void pan(const Pixel& shift);
  /// Enlarges by `factor` about a place in the window.
  void zoom(double factor, const Pixel& about);
  /// Zooms to a rectangle of the window, given by two corners.
  void zoom_to_box(const Pixel& corner, const Pixel& opposite);
  /// While true, paths of many points are drawn coarsely.
  void set_moving(bool moving);

  /// Highlights the executed path between two times [s]; none: no highlight.
  void set_highlight(std::optional<std::array<double, 2>> range);
  /// Range of the executed path that is drawn: all, the highlighted part, or up to the cursor. The rest
  /// cannot be picked.
  void set_stretch(const StretchChoice& stretch);
  const StretchChoice& stretch() const;
  /// Zooms to the executed path between two times [s].
  void fit_times(double from, double to);
  /// First and last time [s] at which the executed path is visible in the window, or in a rectangle of it;
  /// none if it never is.
  std::optional<std::array<double, 2>> visible_times() const;
  std::optional<std::array<double, 2>> times_within(const Pixel& corner, const Pixel& opposite) const;

  void set_dimension(std::optional<SceneDimension> dimension);
  /// Draws a ring around a place of the path [mm]; none removes it.
  void set_hover(const std::optional<Vec3>& place);
  /// Draws the rectangle of a mouse drag, by two corners.
  void set_rubber_band(const std::optional<std::array<Pixel, 2>>& corners);

  /// Time [s] at which the executed path is nearest to a pixel, if within `radius` [pixels of scale 1]. The
  /// camera is that of the last frame or change.
  std::optional<double> pick_time(const Pixel& pixel, double radius = 8) const;
  /// The view for the cube's face under a pixel.
  std::optional<StandardView> cube_view(const Pixel& pixel) const;
  /// The shown executed motion; null for none.
  const std::shared_ptr<const Trajectory>& trajectory() const;
  /// The executed motion at a time [s]; none without one.
  std::optional<State> state_at(double time) const;
  /// Distance from the programmed path at a time [mm].
  double contour_error_at(double time) const;
  /// Duration of the executed motion [s]; 0 without one.
  double duration() const { return trajectory() ? trajectory()->duration() : 0; }
  /// Drawn place of a time in the executed path [mm].
  Vec3 drawn_at(double time) const;
  /// Pixel of a point [mm].
  Pixel pixel_of(const Vec3& point) const;
  /// Rectangles of the window covered by texts and colours: upper left and lower right corner of each.
  std::vector<std::array<Pixel, 2>> covered() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace feedscope::ui
