#include "ui/scene/path_scene.h"

#include <vtkCamera.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "ui/scene/draw/axes_box.h"
#include "ui/scene/draw/axes_cube.h"
#include "ui/scene/draw/scene_pointers.h"
#include "ui/scene/path/pick.h"
#include "ui/scene/path/scene_paths.h"
#include "ui/scene/path/shown_extent.h"
#include "ui/scene/render_callback.h"
#include "ui/scene/render_window.h"
#include "ui/scene/window_layers.h"

namespace feedscope::ui {
namespace {

constexpr double largest_exaggeration = 1000;
constexpr double cube_half = 24;    // [pixels]
constexpr double cube_height = 98;  // of its centre, above the lower edge

}  // namespace

class PathScene::Impl : public ScenePaths {
 public:
  Impl()
      : under(stage.behind()),
        over(stage.front()),
        layers(stage.middle(), stage.behind()),
        tool_drawn(stage.front()),
        camera(*stage.middle().GetActiveCamera()) {
    call_before(stage.behind(), this,
                [](vtkObject*, unsigned long, void* self, void*) { static_cast<Impl*>(self)->prepare(); });
    call_before(stage.front(), this, [](vtkObject*, unsigned long, void* self, void*) {
      auto& scene = *static_cast<Impl*>(self);
      const double reach = scene.tool_drawn.reach(scene.projection(), scene.frame, scene.scale);
      scene.camera.set_clipping(reach + scene.beyond, reach + scene.beyond);
    });
    camera.look(StandardView::iso);
    apply_colours();
  }

  const SceneColours& colours() const { return *look.colours; }
  Projection projection() const { return camera.projection(stage.width(), stage.height()); }
  Captions captions() const {
    return {layers.entries(), layers.key(), look.run, look.exaggeration, look.colours, &texts, transparent};
  }
  ScreenLayout layout() const { return screen_layout(stage.width(), stage.height(), scale, captions()); }
  ScreenRectangle room() const {
    const ScreenLayout screen = layout();
    return {screen.low(), screen.high()};
  }
  PickablePath pickable() const {
    const DrawnPath* path = layers.executed();
    return path != nullptr ? PickablePath{&path->samples(), &path->positions(), &path->boxes(),
                                          stretch.rest_hidden ? shown_times() : std::nullopt}
                           : PickablePath{};
  }
  std::optional<TimeStretch> shown_times() const { return stretch.times(highlight, cursor_at); }
  void apply_stretch() {
    layers.trail().end_at(cursor_at, cursor);
    const auto times = shown_times();
    const bool only = times && stretch.rest_hidden && layers.executed() != nullptr;
    layers.set_stretch(
        times, only ? std::optional(bounds_between(pickable(), (*times)[0], (*times)[1])) : std::nullopt);
    layers.set_highlight(stretch.stretch == PathStretch::charts ? std::nullopt : highlight);
    changed();
  }
  AxesCube cube() const {
    const ScreenLayout screen = layout();
    const Vec2 centre(screen.width - screen.panel_width / 2, cube_height * scale);
    return {projection(), centre, screen.cube ? cube_half * scale : 0};
  }

  void changed() const {
    if (callback) {
      callback();
    }
  }

  void rebuild() {
    const bool fitted = camera.fitted();
    const CameraState state = camera.state(frame);
    const ShownExtent extent = shown_extent({programmed, executed_samples});
    frame = frame_around(extent.fitted);
    beyond = extent.beyond() / frame.unit;
    layers.show(programmed, executed_samples, shown_overlays(colours(), texts), frame);
    apply_stretch();
    camera.set_state(state, frame);
    if (fitted) {
      fit_now();
    }
    changed();
  }

  void fit_now() {
    camera.fit(stage.width(), stage.height(), frame.box, room(), [this](const Projection& view) {
      const AxesLayout axes = lay_out_axes(frame, view, scale);
      return ScreenRectangle{axes.low, axes.high};
    });
    fitted_in = fitted_window();
  }

  /// What a fit depends on but for the path.
  std::array<double, 5> fitted_window() const {
    const ScreenLayout screen = layout();
    return {screen.width, screen.height, scale, screen.panel_width, screen.legend_height};
  }

  void apply_look() {
    layers.set_look(look);
    changed();
  }

  void apply_colours() {
    const Rgb background = transparent ? Rgb{} : colours().background;
    stage.behind().SetBackground(background[0], background[1], background[2]);
    stage.behind().SetBackgroundAlpha(transparent ? 0 : 1);
    tool_drawn.set_colour(colours().tool);
    apply_look();
  }

  /// Before each frame: follows the window's size and draws what depends on the camera.
  void prepare() {
    layers.place(frame, projection(), scale, moving);  // says what the legend needs
    if (camera.fitted() && fitted_in != fitted_window()) {
      fit_now();
    }
    const Projection view = projection();
    const std::optional<Vec3> tip = cursor ? std::optional(frame.to_scene(*cursor)) : std::nullopt;
    layers.place(frame, view, scale, moving);
    tool_drawn.place(tip, tool_direction(cursor_at), view, frame, scale);
    constexpr double lifted = 40;  // pixels at most, of the path's layers
    camera.set_clipping(lifted * scale / view.scale + beyond, beyond);

    under.begin();
    draw(lay_out_axes(frame, view, scale), scale, grid, colours(), texts, under);
    under.end();
    over.begin();
    const auto place_of = [&](const Vec3& point) { return view.to_display(frame.to_scene(point)); };
    draw_path_marks(over, programmed.get(), executed_samples.get(), place_of,
                    {scale, colours(), texts, view.scale / frame.unit});
    draw_scene_pointers(over, pointers, place_of, stage.height(), room(), scale, colours());
    draw_captions(over, layout(), captions(), view, view.scale / frame.unit);
    cube().draw(over, scale, colours(), texts);
    over.end();
  }

  WindowLayers stage;
  Canvas under;
  Canvas over;
  PathLayers layers;
  Tool tool_drawn;
  SceneCamera camera;
  std::function<void()> callback;

  std::optional<Vec3> cursor;       ///< as drawn
  std::optional<double> cursor_at;  ///< its time, where it is on the path
  std::optional<TimeStretch> highlight;
  StretchChoice stretch;
  ScenePointers pointers;
  PathLook look;
  SceneTexts texts;
  SceneFrame frame = frame_around({});
  double beyond = 0;  ///< how far outside the frame's box rapids may be [scene units]
  bool grid = true;
  bool transparent = false;
  bool moving = false;
  double scale = 1;
  std::array<double, 5> fitted_in{};
};

PathScene::PathScene() : impl_(std::make_unique<Impl>()) {}
PathScene::~PathScene() = default;

void PathScene::attach(vtkRenderWindow& window) {
  impl_->stage.attach(window);
}

void PathScene::detach() {
  impl_->stage.detach();
}

void PathScene::on_change(std::function<void()> callback) {
  impl_->callback = std::move(callback);
}

void PathScene::set_programmed(std::shared_ptr<const Toolpath> toolpath) {
  set_programmed(toolpath ? std::make_shared<const SampledPath>(sample_programmed(*toolpath)) : nullptr);
}

void PathScene::set_programmed(std::shared_ptr<const SampledPath> samples) {
  if (std::exchange(impl_->programmed, samples) != samples) {
    impl_->rebuild();
  }
}

void PathScene::set_executed(std::shared_ptr<const Trajectory> trajectory) {
  auto samples = trajectory ? std::make_shared<const SampledPath>(sample_executed(*trajectory)) : nullptr;
  set_executed(std::move(trajectory), std::move(samples));
}

void PathScene::set_executed(std::shared_ptr<const Trajectory> trajectory,
                             std::shared_ptr<const SampledPath> samples) {
  impl_->trajectory = std::move(trajectory);
  impl_->executed_samples = std::move(samples);
  impl_->rebuild();
}

void PathScene::set_overlays(std::vector<OverlayRun> overlays) {
  if (!overlays.empty() || !impl_->overlays.empty()) {
    impl_->overlays = std::move(overlays);
    impl_->rebuild();
  }
}

void PathScene::set_actual_shown(bool shown) {
  if (std::exchange(impl_->actual_shown, shown) != shown) {
    impl_->rebuild();
  }
}
bool PathScene::actual_shown() const {
  return impl_->actual_shown;
}

bool PathScene::has(QuantitySource source) const {
  return impl_->executed_samples != nullptr && impl_->executed_samples->has(source);
}

void PathScene::set_cursor(const std::optional<Vec3>& tip) {
  impl_->cursor = tip;
  impl_->cursor_at.reset();
  impl_->apply_stretch();
}

void PathScene::set_cursor(const State& state) {
  impl_->cursor = drawn_at(state.time);
  impl_->cursor_at = state.time;
  impl_->apply_stretch();
}

void PathScene::set_trail(double seconds) {
  impl_->layers.trail().set_length(seconds);
  impl_->changed();
}

void PathScene::set_colouring(Colouring colouring) {
  if (colouring != impl_->look.colouring) {
    impl_->look.colouring = colouring;
    impl_->apply_look();
  }
}
Colouring PathScene::colouring() const {
  return impl_->look.colouring;
}

void PathScene::set_run_colour(const Rgb& colour) {
  if (colour != impl_->look.run) {
    impl_->look.run = colour;
    impl_->apply_look();
  }
}

void PathScene::set_warning(const std::string& text) {
  impl_->texts.warning = text;
  impl_->changed();
}

void PathScene::set_comparison(const std::string& reference, std::shared_ptr<const SampledPath> scale_with) {
  if (reference != impl_->look.reference || scale_with != impl_->look.scale_with) {
    impl_->look.reference = reference;
    impl_->look.scale_with = std::move(scale_with);
    impl_->apply_look();
  }
}

void PathScene::set_exaggeration(double factor) {
  impl_->look.exaggeration = std::clamp(factor, 1.0, largest_exaggeration);
  impl_->apply_look();
  if (impl_->cursor_at) {
    impl_->cursor = drawn_at(*impl_->cursor_at);
  }
}
double PathScene::exaggeration() const {
  return impl_->look.exaggeration;
}

void PathScene::set_rapids_shown(bool shown) {
  impl_->look.rapids = shown;
  impl_->apply_look();
}
bool PathScene::rapids_shown() const {
  return impl_->look.rapids;
}

void PathScene::set_tool(const ToolShape& shape) {
  impl_->tool_drawn.set_shape(shape);
  impl_->changed();
}
const ToolShape& PathScene::tool() const {
  return impl_->tool_drawn.shape();
}

void PathScene::set_grid(bool shown) {
  impl_->grid = shown;
  impl_->changed();
}
bool PathScene::grid() const {
  return impl_->grid;
}

void PathScene::set_background(Background background) {
  impl_->look.colours = &scene_colours(background);
  impl_->apply_colours();
}

void PathScene::set_transparent(bool transparent) {
  impl_->transparent = transparent;
  impl_->apply_colours();
}

void PathScene::set_texts(SceneTexts texts) {
  impl_->texts = std::move(texts);
  impl_->apply_look();
}

void PathScene::set_scale(double scale) {
  impl_->scale = scale;
  impl_->changed();
}

void PathScene::set_standard_view(StandardView view) {
  impl_->camera.look(view);
  fit();
}

void PathScene::fit() {
  impl_->fit_now();
  impl_->changed();
}

void PathScene::set_perspective(bool perspective) {
  const bool fitted = impl_->camera.fitted();
  impl_->camera.set_perspective(perspective);
  if (fitted) {
    impl_->fit_now();
  }
  impl_->changed();
}
bool PathScene::perspective() const {
  return impl_->camera.perspective();
}

CameraState PathScene::camera() const {
  return impl_->camera.state(impl_->frame);
}

void PathScene::set_camera(const CameraState& state) {
  impl_->camera.set_state(state, impl_->frame);
  if (state.fitted) {
    impl_->fit_now();
  }
  impl_->changed();
}

void PathScene::orbit(const Pixel& shift, const std::optional<Vec3>& pivot) {
  const double turn = units::pi / 400 / impl_->scale;  // [rad] a pixel
  const Vec3 about = pivot ? impl_->frame.to_scene(*pivot) : impl_->projection().focal;
  impl_->camera.orbit(-turn * shift[0], turn * shift[1], about);
  impl_->changed();
}

void PathScene::pan(const Pixel& shift) {
  impl_->camera.pan({shift[0], -shift[1]}, impl_->stage.width(), impl_->stage.height());
  impl_->changed();
}

void PathScene::zoom(double factor, const Pixel& about) {
  impl_->camera.zoom(factor, impl_->stage.display(about), impl_->stage.width(), impl_->stage.height());
  impl_->changed();
}

void PathScene::zoom_to_box(const Pixel& corner, const Pixel& opposite) {
  const Vec2 low = impl_->stage.display(corner).cwiseMin(impl_->stage.display(opposite));
  const Vec2 high = impl_->stage.display(corner).cwiseMax(impl_->stage.display(opposite));
  impl_->camera.zoom_to_box({low, high}, impl_->room(), impl_->stage.width(), impl_->stage.height());
  impl_->changed();
}

void PathScene::set_moving(bool moving) {
  if (std::exchange(impl_->moving, moving) != moving) {
    set_rough_edges(impl_->stage.window(), moving);
    impl_->changed();
  }
}

void PathScene::set_highlight(std::optional<std::array<double, 2>> range) {
  impl_->highlight = range;
  impl_->apply_stretch();
}

void PathScene::set_stretch(const StretchChoice& stretch) {
  if (std::exchange(impl_->stretch, stretch) != stretch) {
    impl_->apply_stretch();
  }
}
const StretchChoice& PathScene::stretch() const {
  return impl_->stretch;
}

void PathScene::fit_times(double from, double to) {
  const Bounds part = bounds_between(impl_->pickable(), from, to);
  if (part.empty()) {
    return;
  }
  Bounds box;
  box.add(impl_->frame.to_scene(part.min));
  box.add(impl_->frame.to_scene(part.max));
  impl_->camera.fit_part(impl_->stage.width(), impl_->stage.height(), box, impl_->room());
  impl_->changed();
}

std::optional<std::array<double, 2>> PathScene::visible_times() const {
  const auto [corner, opposite] = path_room();
  return times_within(corner, opposite);
}

std::optional<std::array<double, 2>> PathScene::times_within(const Pixel& corner,
                                                             const Pixel& opposite) const {
  const Vec2 a = impl_->stage.display(corner);
  const Vec2 b = impl_->stage.display(opposite);
  return ui::times_within(impl_->pickable(), {impl_->projection(), impl_->frame}, a.cwiseMin(b),
                          a.cwiseMax(b));
}

void PathScene::set_dimension(std::optional<SceneDimension> dimension) {
  impl_->pointers.dimension = std::move(dimension);
  impl_->changed();
}

void PathScene::set_hover(const std::optional<Vec3>& place) {
  if (place != impl_->pointers.hover) {
    impl_->pointers.hover = place;
    impl_->changed();
  }
}

void PathScene::set_rubber_band(const std::optional<std::array<Pixel, 2>>& corners) {
  impl_->pointers.rubber_band = corners;
  impl_->changed();
}

std::optional<double> PathScene::pick_time(const Pixel& pixel, double radius) const {
  const bool exact = impl_->trajectory && exaggeration() == 1;
  return nearest_time(impl_->pickable(), exact ? impl_->trajectory.get() : nullptr,
                      {impl_->projection(), impl_->frame}, impl_->stage.display(pixel),
                      radius * impl_->scale);
}

std::optional<StandardView> PathScene::cube_view(const Pixel& pixel) const {
  return impl_->cube().view_at(impl_->stage.display(pixel));
}

const std::shared_ptr<const Trajectory>& PathScene::trajectory() const {
  return impl_->trajectory;
}

std::optional<State> PathScene::state_at(double time) const {
  return impl_->trajectory ? std::optional(impl_->trajectory->state(time)) : std::nullopt;
}

double PathScene::contour_error_at(double time) const {
  return value_at(impl_->pickable(), Colouring::contour_error, time);
}

Vec3 PathScene::drawn_at(double time) const {
  if (!impl_->trajectory) {
    return Vec3::Zero();
  }
  const Vec3 place = impl_->trajectory->state(time).position;
  return place + (exaggeration() - 1) * deviation_at(impl_->pickable(), time);
}

std::array<Pixel, 2> PathScene::path_room() const {
  const ScreenLayout layout = impl_->layout();
  return {Pixel{0, layout.legend_height}, Pixel{layout.width - layout.panel_width, layout.height}};
}

Pixel PathScene::pixel_of(const Vec3& point) const {
  const Vec2 display = impl_->projection().to_display(impl_->frame.to_scene(point));
  return {display.x(), impl_->stage.height() - display.y()};
}

}  // namespace feedscope::ui
