#include "ui/scene/path_scene.h"

#include <algorithm>
#include <utility>

#include "core/base/units.h"
#include "ui/scene/current_context.h"
#include "ui/scene/path_scene_impl.h"
#include "ui/scene/render_window.h"

namespace feedscope::ui {
namespace {

constexpr double largest_exaggeration = 1000;

}  // namespace

PathScene::PathScene() : impl_(std::make_unique<Impl>()) {}
PathScene::~PathScene() = default;

void PathScene::attach(vtkRenderWindow& window) {
  impl_->stage.attach(window);
}

void PathScene::detach() {
  const CurrentContext context(impl_->stage.middle());
  impl_->stage.detach();
}

void PathScene::lay_out() {
  impl_->prepare();
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
  auto samples = trajectory ? std::make_shared<const SampledPath>(sample_executed(trajectory)) : nullptr;
  set_executed(std::move(trajectory), std::move(samples));
}

void PathScene::set_executed(std::shared_ptr<const Trajectory> trajectory,
                             std::shared_ptr<const SampledPath> samples) {
  impl_->trajectory = std::move(trajectory);
  impl_->deviation.reset();
  if (impl_->trajectory && !impl_->trajectory->pieces().empty()) {
    impl_->deviation.emplace(*impl_->trajectory->path().programmed());
  }
  impl_->executed_samples = std::move(samples);
  impl_->rebuild();
}

void PathScene::set_overlays(std::vector<OverlayRun> overlays) {
  const auto same = [](const OverlayRun& a, const OverlayRun& b) {
    return a.samples == b.samples && a.colour == b.colour && a.name == b.name && a.apart == b.apart;
  };
  if (!std::ranges::equal(overlays, impl_->overlays, same)) {
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

void PathScene::set_on_machine(bool shown) {
  if (std::exchange(impl_->machine_asked, shown) == shown || !knows_machine()) {
    return;
  }
  if (impl_->cursor_at) {
    impl_->cursor = drawn_at(*impl_->cursor_at);
  }
  impl_->pointers = {};
  impl_->rebuild();
  fit();
}
bool PathScene::on_machine() const {
  return impl_->machine_asked;
}
bool PathScene::knows_machine() const {
  return impl_->executed_samples != nullptr && impl_->executed_samples->on_machine != nullptr;
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

void PathScene::set_all_rapids_shown(bool shown) {
  impl_->look.all_rapids = shown;
  impl_->apply_look();
}
bool PathScene::all_rapids_shown() const {
  return impl_->look.all_rapids;
}

void PathScene::set_tool(const ToolShape& shape) {
  impl_->tool_drawn.set_shape(shape);
  impl_->changed();
}
const ToolShape& PathScene::tool() const {
  return impl_->tool_drawn.shape();
}

void PathScene::set_axes(bool shown) {
  impl_->axes = shown;
  impl_->changed();
}
bool PathScene::axes() const {
  return impl_->axes;
}

void PathScene::set_legend(bool shown) {
  impl_->legend = shown;
  impl_->changed();
}

void PathScene::set_strip(bool shown) {
  impl_->strip = shown;
  impl_->changed();
}

void PathScene::set_cube(bool shown) {
  impl_->cube_shown = shown;
  impl_->changed();
}

void PathScene::set_inset(std::optional<double> side) {
  if (std::exchange(impl_->inset, side) != side) {
    impl_->changed();
  }
}

std::optional<std::array<Pixel, 2>> PathScene::inset() const {
  return impl_->inset ? std::optional(impl_->pixels_of(impl_->inset_place())) : std::nullopt;
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
  const double turn = units::pi / 400 / impl_->scale;  // [rad] per pixel
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
  impl_->camera.fit_part(impl_->stage.width(), impl_->stage.height(), box, impl_->room(), impl_->covered());
  impl_->changed();
}

std::optional<std::array<double, 2>> PathScene::visible_times() const {
  return times_within({0, 0}, {double(impl_->stage.width()), double(impl_->stage.height())});
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
  const bool exact = impl_->trajectory && exaggeration() == 1 && !impl_->on_machine();
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
  return impl_->deviation ? ui::contour_error_at(*impl_->trajectory, *impl_->deviation, time) : 0;
}

Vec3 PathScene::drawn_at(double time) const {
  if (!impl_->trajectory) {
    return Vec3::Zero();
  }
  const Vec3 place = impl_->place_at(time);
  if (impl_->on_machine() || exaggeration() == 1) {
    return place;
  }
  return place + (exaggeration() - 1) * deviation_at(impl_->pickable(), time);
}

std::vector<std::array<Pixel, 2>> PathScene::covered() const {
  std::vector<std::array<Pixel, 2>> corners;
  for (const ScreenRectangle& rectangle : impl_->covered()) {
    corners.push_back(impl_->pixels_of(rectangle));
  }
  return corners;
}

Pixel PathScene::pixel_of(const Vec3& point) const {
  const Vec2 display = impl_->projection().to_display(impl_->frame.to_scene(point));
  return {display.x(), impl_->stage.height() - display.y()};
}

}  // namespace feedscope::ui
