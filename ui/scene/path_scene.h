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

/// A distance shown between two places, with what is written beside it.
struct SceneDimension {
  Vec3 from;               ///< [mm]
  std::optional<Vec3> to;  ///< none: only the first place is marked
  std::vector<std::string> lines;
};

/// One run in 3D: programmed path, executed path in colours that mean something, other runs, tool; over it
/// what the lines and colours mean. Knows no widget; draws into the window it is attached to. All calls
/// from the thread that draws. Places are drawn ones: with exaggerated deviations, where the path is drawn.
class PathScene {
 public:
  PathScene();
  ~PathScene();

  /// Draws into `window` until detach() or the window's end; a scene has one window.
  void attach(vtkRenderWindow& window);
  void detach();
  /// Brings what VTK would draw in the next frame up to date, without drawing it.
  void lay_out();
  /// Called after each change that needs a new frame.
  void on_change(std::function<void()> callback);

  /// Null takes the path away. The camera is fitted again until the user has turned or moved it.
  void set_programmed(std::shared_ptr<const Toolpath> toolpath);
  /// As above, with `samples` = sample_programmed(*toolpath) made off this thread.
  void set_programmed(std::shared_ptr<const SampledPath> samples);
  void set_executed(std::shared_ptr<const Trajectory> trajectory);
  /// As above, with `samples` = sample_executed(*trajectory) made off this thread.
  void set_executed(std::shared_ptr<const Trajectory> trajectory, std::shared_ptr<const SampledPath> samples);
  /// Other runs of the program; replaces those shown before.
  void set_overlays(std::vector<OverlayRun> overlays);
  /// Whether the path that the axes run is drawn, where the executed path has one.
  void set_actual_shown(bool shown);
  bool actual_shown() const;
  /// Whether the run is drawn where X, Y and Z of the machine stand while rotary axes turn part or tool,
  /// where that is known, instead of in the coordinates of the part.
  void set_on_machine(bool shown);
  bool on_machine() const;
  /// Whether that is known of the executed path.
  bool knows_machine() const;
  /// Whether the executed path has one.
  bool has(QuantitySource source) const;
  /// Tip of the tool [mm]; none hides it.
  void set_cursor(const std::optional<Vec3>& tip);
  /// The tool at an instant of the executed path.
  void set_cursor(const State& state);
  /// Draws where the tool has been up to so long before [s], rapids included; 0: does not.
  void set_trail(double seconds);

  void set_colouring(Colouring colouring);
  Colouring colouring() const;
  /// Colour of the executed path for Colouring::run.
  void set_run_colour(const Rgb& colour);
  /// What is wrong with the program, named in the legend; empty: nothing. UTF-8, Latin letters.
  void set_warning(const std::string& text);
  /// `reference`: name of the run that the samples of the executed path are compared with (sample_compared).
  /// `scale_with`: a path in another scene whose colours are to mean the same, so that the scale holds both;
  /// null: none.
  void set_comparison(const std::string& reference, std::shared_ptr<const SampledPath> scale_with);
  /// How much larger than they are deviations from the programmed path are drawn: 1 to 1000, clamped.
  void set_exaggeration(double factor);
  double exaggeration() const;
  /// Whether rapids are drawn where they cover little of the picture.
  void set_rapids_shown(bool shown);
  bool rapids_shown() const;
  /// Whether they are drawn where they cover much of it, too.
  void set_all_rapids_shown(bool shown);
  bool all_rapids_shown() const;
  void set_tool(const ToolShape& shape);
  const ToolShape& tool() const;
  /// A box around the path with its size in mm and grids.
  void set_axes(bool shown);
  bool axes() const;
  /// Whether lines and colours are explained; not where a scene beside this one explains them.
  void set_legend(bool shown);
  /// A cube whose faces are standard views, see cube_view().
  void set_cube(bool shown);
  /// A part of the window that something else covers, by two corners: a fit leaves it free.
  void set_covered(const std::optional<std::array<Pixel, 2>>& corners);
  void set_background(Background background);
  /// Nothing is drawn behind: what is not covered has no opacity in the pixels of the window, and colours are
  /// multiplied by their opacity.
  void set_transparent(bool transparent);
  void set_texts(SceneTexts texts);
  /// Size of text and lines; 1 suits 96 dots an inch.
  void set_scale(double scale);

  void set_standard_view(StandardView view);
  /// Everything in the window, without turning.
  void fit();
  void set_perspective(bool perspective);
  bool perspective() const;
  CameraState camera() const;
  void set_camera(const CameraState& state);
  /// As a drag of the mouse by `shift` pixels, to the right and downwards: the scene follows. `pivot`: a
  /// place that stays [mm]; none: what is in the middle of the view.
  void orbit(const Pixel& shift, const std::optional<Vec3>& pivot = std::nullopt);
  void pan(const Pixel& shift);
  /// Enlarges by `factor` about a place of the window.
  void zoom(double factor, const Pixel& about);
  /// What is in a rectangle of the window fills it, by two corners.
  void zoom_to_box(const Pixel& corner, const Pixel& opposite);
  /// While true, paths of many points are drawn coarsely.
  void set_moving(bool moving);

  /// Marks the executed path between two times [s]; none marks nothing.
  void set_highlight(std::optional<std::array<double, 2>> range);
  /// Which stretch of the executed path is drawn in full: all, that which is marked, or up to the cursor.
  /// What is hidden cannot be picked.
  void set_stretch(const StretchChoice& stretch);
  const StretchChoice& stretch() const;
  /// The executed path between two times [s] fills the window.
  void fit_times(double from, double to);
  /// First and last time [s] at which the executed path is in view, or in a rectangle of the window.
  std::optional<std::array<double, 2>> visible_times() const;
  std::optional<std::array<double, 2>> times_within(const Pixel& corner, const Pixel& opposite) const;

  void set_dimension(std::optional<SceneDimension> dimension);
  /// A ring about a place of the path [mm].
  void set_hover(const std::optional<Vec3>& place);
  /// A rectangle drawn with the mouse, by two corners.
  void set_rubber_band(const std::optional<std::array<Pixel, 2>>& corners);

  /// Time [s] at which the executed path comes nearest to a pixel, if within `radius` [pixels of scale 1].
  /// The camera is that of the last frame or change.
  std::optional<double> pick_time(const Pixel& pixel, double radius = 8) const;
  /// The view of the cube's face under a pixel.
  std::optional<StandardView> cube_view(const Pixel& pixel) const;
  /// What is shown as executed; null for nothing.
  const std::shared_ptr<const Trajectory>& trajectory() const;
  /// The executed motion at a time [s]; none without one.
  std::optional<State> state_at(double time) const;
  /// Distance from the programmed path at a time [mm].
  double contour_error_at(double time) const;
  /// Of the executed motion [s]; 0 without one.
  double duration() const { return trajectory() ? trajectory()->duration() : 0; }
  /// Where an instant of the executed path is drawn [mm].
  Vec3 drawn_at(double time) const;
  /// Where a point [mm] is drawn.
  Pixel pixel_of(const Vec3& point) const;
  /// Of the rectangles of the window that texts and colours cover: upper left and lower right corner each.
  std::vector<std::array<Pixel, 2>> covered() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace feedscope::ui
