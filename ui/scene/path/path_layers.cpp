#include "ui/scene/path/path_layers.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkMapper.h>
#include <vtkPlaneCollection.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/scene/current_context.h"
#include "ui/scene/path/path_actors.h"
#include "ui/scene/path/view_detail.h"

namespace feedscope::ui {
namespace {

// Widths and heights in pixels at scale 1. Lines in one place must not fight: each layer is slightly nearer
// to the eye, which does not move it on the screen. A disc bulges towards the eye by half its width, so
// the cut is above the edge of the blends, and the blends are above the cut.
constexpr double thin_width = 1.4;
constexpr double rapid_width = 1.2;
constexpr double overlay_width = 1.8;
constexpr double cut_width = 2.6;
constexpr double difference_width = 5;
constexpr double blend_width = 4.4;
constexpr double blend_edge_width = 7;
constexpr double curve_edge_width = 6;
constexpr double range_width = 12;

constexpr std::size_t few_wide_lines = 3000;  // drawn in software while the view moves
constexpr double max_covered = 0.5;           // of the path by edges of blends
constexpr double dashes_across = 90;          // along the largest extent

bool is_cut(SpanKind kind) {
  return kind != SpanKind::rapid && kind != SpanKind::gap;
}

bool is_blend(SpanKind kind) {
  return kind == SpanKind::blend;
}

bool is_curve(SpanKind kind) {
  return kind == SpanKind::curve;
}

std::size_t count_of_blends(const SampledPath& path) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    count += is_blend(path.kinds[i]) && (i == 0 || !is_blend(path.kinds[i - 1])) ? 1 : 0;
  }
  return count;
}

Rgb mixed(const Rgb& a, const Rgb& b, double share_of_b) {
  Rgb mix{};
  for (std::size_t i = 0; i < mix.size(); ++i) {
    mix[i] = std::lerp(a[i], b[i], share_of_b);
  }
  return mix;
}

/// Whether any part of the line from `p` to `q` is within a rectangle.
bool meets_line(const ScreenRectangle& rectangle, const Vec2& p, const Vec2& q) {
  const Vec2 across(q.y() - p.y(), p.x() - q.x());
  return rectangle.meets({p.cwiseMin(q), p.cwiseMax(q)}) &&
         std::abs(across.dot(rectangle.centre() - p)) <= across.cwiseAbs().dot(rectangle.size()) / 2;
}

}  // namespace

template <class Wanted>
void PathLayers::remove(Wanted wanted) {
  const CurrentContext context(renderer_);
  std::erase_if(layers_, [&](const Layer& layer) {
    const bool is_wanted = wanted(layer);
    for (const auto& actor : layer.actors) {
      if (is_wanted && actor) {
        renderer_of(layer).RemoveActor(actor);
      }
    }
    return is_wanted;
  });
}

void PathLayers::add(Role role, const DrawnPath* path, bool discs, const Rgb& colour) {
  layers_.push_back({role, path, discs, colour, {}});
  layers_.back().actors.resize(path->samples().levels.size());
}

void PathLayers::show(std::shared_ptr<const SampledPath> programmed,
                      std::shared_ptr<const SampledPath> executed, std::vector<OverlayRun> overlays,
                      const SceneFrame& frame) {
  const auto drawable = [](const std::shared_ptr<const SampledPath>& path) {
    return path && !path->levels.empty() ? path : nullptr;
  };
  const auto shown = [](const std::unique_ptr<DrawnPath>& path) {
    return path ? path->shared_samples() : nullptr;
  };
  show_rapids(programmed ? programmed : executed, frame);
  if (shown(programmed_) != drawable(programmed)) {
    show_programmed(drawable(programmed));
  }
  show_overlays(std::move(overlays));
  if (shown(executed_) != drawable(executed)) {
    show_executed(drawable(executed));
  }
  colour_layers();
}

void PathLayers::show_rapids(const std::shared_ptr<const SampledPath>& path, const SceneFrame& frame) {
  if (path == rapids_of_ && frame.unit == dashes_for_) {
    return;
  }
  rapids_of_ = path;
  dashes_for_ = frame.unit;
  remove([](const Layer& layer) { return layer.role == Role::rapid; });
  rapid_length_ = 0;
  rapid_spread_.setZero();
  entries_.rapid = false;
  if (path) {
    // The frame is around the cut path: rapids may extend far beyond it.
    const double extent = path->bounds.empty() ? 0 : (path->bounds.max - path->bounds.min).maxCoeff();
    const auto dashes = rapid_dashes(*path, std::max(frame.unit, extent) / dashes_across);
    measure_rapids(*path, frame);
    entries_.rapid = dashes->GetNumberOfCells() > 0;
    auto actor = line_actor(*dashes, false);
    below_.AddActor(actor);
    rapids_at_ = path->origin;
    layers_.push_back({Role::rapid, nullptr, false, {}, {std::move(actor)}});
  }
}

/// Considers rapids within the frame's box: the rest is hardly ever visible.
void PathLayers::measure_rapids(const SampledPath& path, const SceneFrame& frame) {
  const auto in_box = [&](std::size_t i) -> Vec3 {
    return frame.to_scene(path.position(i)).cwiseMax(frame.box.min).cwiseMin(frame.box.max);
  };
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    if (path.kinds[i] != SpanKind::rapid) {
      continue;
    }
    const Vec3 span = in_box(i + 1) - in_box(i);
    if (const double length = span.norm(); length > 0) {
      rapid_length_ += length;
      rapid_spread_ += span * span.transpose() / length;
    }
  }
}

/// The visible length is at most that of rapids which all have the average slope; every second dash is drawn.
bool PathLayers::shows_rapids(const Projection& view, double scale) const {
  constexpr double most_covered = 0.05;  // of the picture
  if (!look_.rapids || !entries_.rapid) {
    return false;
  }
  const double along = view.towards.dot(rapid_spread_ * view.towards);
  const double seen = std::sqrt(rapid_length_ * std::max(0.0, rapid_length_ - along));
  const double drawn = seen * view.scale * rapid_width * scale / 2;
  const Vec2 window = 2 * view.middle;
  // Close up only a part of them is visible.
  const double part = std::min(1.0, window.minCoeff() / view.scale);
  return look_.all_rapids || drawn * part * part <= most_covered * window.x() * window.y();
}

bool PathLayers::are_rapids_within(const SceneFrame& frame, const Projection& view) const {
  const ScreenRectangle window{Vec2::Zero(), 2 * view.middle};
  const auto place = [&](std::size_t i) { return view.to_display(frame.to_scene(rapids_of_->position(i))); };
  for (std::size_t i = 0; i + 1 < rapids_of_->size(); ++i) {
    if (rapids_of_->kinds[i] == SpanKind::rapid && meets_line(window, place(i), place(i + 1))) {
      return true;
    }
  }
  return false;
}

void PathLayers::show_programmed(std::shared_ptr<const SampledPath> programmed) {
  remove([](const Layer& layer) { return layer.role == Role::programmed; });
  programmed_.reset();
  entries_.programmed = programmed && length_of(*programmed, SpanKind::cut) > 0;
  if (programmed) {
    programmed_ = std::make_unique<DrawnPath>(std::move(programmed));
    add(Role::programmed, programmed_.get());
  }
}

void PathLayers::show_overlays(std::vector<OverlayRun> overlays) {
  std::vector<std::unique_ptr<DrawnPath>> before = std::exchange(overlays_, {});
  entries_.overlays.clear();
  for (OverlayRun& overlay : overlays) {
    if (!overlay.samples || overlay.samples->levels.empty()) {
      continue;
    }
    entries_.overlays.push_back({overlay.name, overlay.colour, overlay.apart});
    const auto found = std::ranges::find_if(
        before, [&](const auto& path) { return path && path->shared_samples() == overlay.samples; });
    if (found != before.end()) {
      std::ranges::find(layers_, found->get(), &Layer::path)->colour = overlay.colour;
      overlays_.push_back(std::move(*found));
    } else {
      overlays_.push_back(std::make_unique<DrawnPath>(std::move(overlay.samples)));
      overlays_.back()->exaggerate(look_.exaggeration);
      add(Role::overlay, overlays_.back().get(), false, overlay.colour);
    }
  }
  remove([&](const Layer& layer) {
    return layer.role == Role::overlay &&
           std::ranges::any_of(before, [&](const auto& path) { return path.get() == layer.path; });
  });
}

void PathLayers::show_executed(std::shared_ptr<const SampledPath> executed) {
  remove([this](const Layer& layer) { return executed_ && layer.path == executed_.get(); });
  executed_.reset();
  cut_length_ = executed ? length_of(*executed, SpanKind::cut) : 0;
  blend_length_ = executed ? length_of(*executed, SpanKind::blend) : 0;
  curve_length_ = executed ? length_of(*executed, SpanKind::curve) : 0;
  cut_length_ += curve_length_;
  blend_count_ = executed ? count_of_blends(*executed) : 0;
  entries_.executed = cut_length_ + blend_length_ > 0;
  entries_.tool_axis = executed && !executed->tool_axes.empty();
  if (executed) {
    executed_ = std::make_unique<DrawnPath>(std::move(executed));
    executed_->exaggerate(look_.exaggeration);
    add(Role::range, executed_.get());
    add(Role::rest, executed_.get());
    add(Role::stretch_end, executed_.get());
    if (curve_length_ > 0) {
      add(Role::curve_edge, executed_.get());
    }
    add(Role::cut, executed_.get());
    for (const bool discs : {false, true}) {
      add(Role::difference, executed_.get(), discs);
    }
    if (blend_length_ > 0) {
      for (const bool discs : {false, true}) {
        add(Role::blend_edge, executed_.get(), discs);
        add(Role::blend, executed_.get(), discs);
      }
    }
  }
  colour_executed();
}

void PathLayers::set_look(const PathLook& look) {
  const PathLook before = std::exchange(look_, look);
  if (look.exaggeration != before.exaggeration) {
    if (executed_) {
      executed_->exaggerate(look.exaggeration);
    }
    for (const auto& path : overlays_) {
      path->exaggerate(look.exaggeration);
    }
  }
  const bool other_colours = look.colouring != before.colouring || look.colours != before.colours ||
                             look.reference != before.reference || look.scale_with != before.scale_with ||
                             (look.colouring == Colouring::run && look.run != before.run);
  if (other_colours) {
    colour_executed();
  }
  colour_layers();
}

void PathLayers::colour_executed() {
  key_ = {look_.colouring, {}, {}, {}};
  if (executed_) {
    const SampledPath& path = executed_->samples();
    key_ = look_.scale_with ? colour_key(path, *look_.scale_with, look_.colouring)
                            : colour_key(path, look_.colouring);
    key_.reference = needs_reference(look_.colouring) ? look_.reference : std::string();
    // While the comparison is being computed, the colours must not mean "gained".
    const bool missing = needs_reference(look_.colouring) && !key_.has_scale();
    executed_->set_colours(
        point_colours(path, key_, look_.colours->kind, missing ? look_.colours->programmed : look_.run));
  }
  redraw({Role::difference});
}

/// Differs by a quarter of the colour scale.
bool PathLayers::differs(std::size_t point) const {
  constexpr double visible = 0.25;
  const double at = key_.scale.position(executed_->samples().value(key_.colouring, point));
  return (key_.scale.diverging ? std::abs(2 * at - 1) : at) > visible;
}

void PathLayers::colour_layers() {
  for (const Layer& layer : layers_) {
    const Rgb colour = colour_of(layer);
    for (const auto& actor : layer.actors) {
      if (actor) {
        actor->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
      }
    }
  }
}

LegendEntries PathLayers::entries() const {
  LegendEntries shown = entries_;
  shown.rapid = rapids_in_sight_;
  shown.programmed =
      shown.programmed && std::ranges::any_of(layers_, [](const Layer& layer) {
        return layer.role == Role::programmed && std::ranges::any_of(layer.actors, [](const auto& actor) {
                 return actor && actor->GetVisibility() != 0;
               });
      });
  if (needs_reference(look_.colouring)) {
    shown.overlays.clear();
  }
  return shown;
}

void PathLayers::set_highlight(std::optional<TimeStretch> range) {
  if (std::exchange(range_, range) != range) {
    redraw({Role::range});
  }
}

void PathLayers::set_stretch(const std::optional<TimeStretch>& stretch, const std::optional<Bounds>& only) {
  only_ = only;
  if (!only_) {
    clipping_ = nullptr;
  }
  if (std::exchange(stretch_, stretch) != stretch) {
    redraw({Role::rest, Role::stretch_end, Role::cut, Role::curve_edge, Role::blend_edge, Role::blend});
  }
}

/// Replaces the lines of the executed path; the points of its parts are unchanged.
void PathLayers::redraw(const std::vector<Role>& roles) {
  const CurrentContext context(renderer_);
  for (Layer& layer : layers_) {
    for (std::size_t i = 0; i < layer.actors.size() && std::ranges::count(roles, layer.role) > 0; ++i) {
      if (layer.actors[i]) {
        static_cast<vtkPolyDataMapper*>(layer.actors[i]->GetMapper())
            ->SetInputData(lines_of(layer, *layer.path->part(i)));
      }
    }
  }
}

/// Clips to the box around the part if the rest is hidden.
void PathLayers::place_clipping(const SceneFrame& frame, const Projection& view) {
  if (only_) {
    constexpr double margin = 8;  // [px]: lines are wide and raised towards the eye
    clipping_ = planes_around(frame.to_scene(only_->min), frame.to_scene(only_->max), margin / view.scale);
  }
  for (const Layer& layer : layers_) {
    if (layer.role == Role::rapid || layer.role == Role::programmed || layer.role == Role::overlay) {
      for (const auto& actor : layer.actors) {
        if (actor) {
          actor->GetMapper()->SetClippingPlanes(clipping_);
        }
      }
    }
  }
}

Rgb PathLayers::colour_of(const Layer& layer) const {
  const SceneColours& colours = *look_.colours;
  switch (layer.role) {
    case Role::rapid:
      return colours.rapid;
    case Role::programmed:
      return colours.programmed;
    case Role::range:
      return mixed(colours.highlight, colours.background, 0.55);
    case Role::overlay:
      return layer.colour;
    case Role::blend_edge:
      return colours.blend_edge;
    case Role::curve_edge:
      return colours.curve_edge;
    case Role::rest:
      return mixed(colours.programmed, colours.background, 0.7);
    case Role::cut:
    case Role::difference:
    case Role::blend:
    case Role::stretch_end:
      break;
  }
  return colours.text;
}

/// The highlighted range, with one more point on either side; its rapids only where it has nothing else.
vtkSmartPointer<vtkCellArray> PathLayers::highlighted(const PathPart& part) const {
  if (!range_) {
    return polylines(part, 0, 0, is_cut);
  }
  const PartWindow within = window_within(part, range_);
  bool has_cuts = false;
  for (std::size_t k = within.first; k + 1 < within.end; ++k) {
    has_cuts = has_cuts || is_cut(part.kind(k));
  }
  return polylines(part, within.first > 0 ? within.first - 1 : 0, std::min(part.size(), within.end + 1),
                   [has_cuts](SpanKind kind) { return has_cuts ? is_cut(kind) : kind != SpanKind::gap; });
}

vtkSmartPointer<vtkCellArray> PathLayers::cells_of(const Layer& layer, const PathPart& part) const {
  if (layer.role == Role::range) {
    return highlighted(part);
  }
  if (layer.role == Role::rest) {
    return stretch_ ? polylines_outside(part, *stretch_, is_cut) : polylines(part, 0, 0, is_cut);
  }
  const PartWindow shown =
      layer.path == executed_.get() ? window_within(part, stretch_) : PartWindow{0, part.size()};
  if (layer.role == Role::difference) {
    const auto wanted = [&](std::size_t k) { return is_cut(part.kind(k)) && differs(part[k]); };
    if (!needs_reference(key_.colouring) || !key_.has_scale()) {
      return polylines(part, 0, 0, is_cut);
    }
    return layer.discs ? points_of(shown.first, shown.end, wanted)
                       : polylines(part, shown.first, shown.end, wanted);
  }
  if (layer.discs) {
    return points_of(shown.first, shown.end, [&](std::size_t k) {
      return is_blend(part.kind(k)) || (k > 0 && is_blend(part.kind(k - 1)));
    });
  }
  const bool blends = layer.role == Role::blend || layer.role == Role::blend_edge;
  return polylines(part, shown.first, shown.end,
                   blends                           ? is_blend
                   : layer.role == Role::curve_edge ? is_curve
                                                    : is_cut);
}

vtkSmartPointer<vtkPolyData> PathLayers::lines_of(const Layer& layer, const PathPart& part) const {
  if (layer.role == Role::stretch_end) {
    return ends_of(part, stretch_.value_or(TimeStretch{0, 0}), is_cut);
  }
  const auto cells = cells_of(layer, part);
  return part.poly_data(*cells, layer.discs);
}

vtkSmartPointer<vtkActor> PathLayers::make_actor(const Layer& layer, const PathPart& part) const {
  const bool coloured = layer.role == Role::cut || layer.role == Role::difference ||
                        layer.role == Role::blend || layer.role == Role::stretch_end;
  auto actor = line_actor(*lines_of(layer, part), coloured);
  const Rgb colour = colour_of(layer);
  actor->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
  renderer_of(layer).AddActor(actor);
  return actor;
}

/// Share of the path on the screen covered by the ends of the blends' edges: however short a blend is, its
/// edge is at least as long as wide. `millimetre`: pixels per mm.
double PathLayers::covered_by_edges(double millimetre, double scale) const {
  const double ends = static_cast<double>(blend_count_) * blend_edge_width * scale;
  return ends / std::max((cut_length_ + blend_length_) * millimetre, 1e-9);
}

PathLayers::Style PathLayers::style_of(Role role, double thinner) const {
  switch (role) {
    case Role::rapid:
      return {rapid_width, 0};
    case Role::programmed:
      return {thin_width * thinner, 1.5};
    case Role::range:
      return {range_width, 2.2};
    case Role::curve_edge:
      return {curve_edge_width * thinner, 2.6};
    case Role::blend_edge:
      return {blend_edge_width * thinner, 3};
    case Role::rest:
      return {cut_width * thinner, 4};
    case Role::cut:
    case Role::stretch_end:
      return {cut_width * thinner, 8};
    case Role::difference:
      return {difference_width * std::max(thinner, 0.6), 9};
    case Role::blend:
      return {(entries_.blend ? blend_width : cut_width) * thinner, 10};
    case Role::overlay:
      return {overlay_width * thinner, 6};  // under the run itself: they show differences of the paths
  }
  return {thin_width, 0};
}

/// Updates the parts of all drawn paths; removes actors of parts that no longer exist.
void PathLayers::update_parts(const SceneFrame& frame, const Projection& view, bool moving) {
  const CurrentContext context(renderer_);
  const auto update = [&](DrawnPath& path) {
    const std::size_t level = level_of(path.samples(), frame, view, moving);
    if (!path.show(level, frame, view)) {
      return;
    }
    for (Layer& layer : layers_) {
      for (std::size_t i = 0; layer.path == &path && i < layer.actors.size(); ++i) {
        if (layer.actors[i] && (i == level || path.part(i) == nullptr)) {
          renderer_of(layer).RemoveActor(layer.actors[i]);
          layer.actors[i] = nullptr;
        }
      }
    }
  };
  if (programmed_) {
    update(*programmed_);
  }
  for (const auto& path : overlays_) {
    if (overlays_shown()) {
      update(*path);
    }
  }
  if (executed_) {
    update(*executed_);
  }
}

void PathLayers::place(const SceneFrame& frame, const Projection& view, double scale, ViewMotion motion) {
  const bool moving = motion != ViewMotion::none;
  constexpr double sparse = 0.15;  // of the picture covered, so that edges mark something
  constexpr double comfortable = 0.35;
  const auto covered = [&](double curve_width, double blend_width) {
    return crowding(frame, view,
                    scale * ((cut_length_ - curve_length_) * cut_width + curve_length_ * curve_width +
                             blend_length_ * blend_width));
  };
  // Enlarged deviations show blends anyway.
  const bool edges = covered(curve_edge_width, blend_edge_width) < sparse && look_.exaggeration == 1 &&
                     covered_by_edges(view.scale / frame.unit, scale) < max_covered;
  const double thinner = std::min(1.0, comfortable / std::max(covered(cut_width, cut_width), 1e-9));
  entries_.blend = blend_length_ > 0 && edges;
  entries_.curve = curve_length_ > 0 && edges;
  const bool rapids = shows_rapids(view, scale);
  rapids_in_sight_ = rapids && are_rapids_within(frame, view);
  // Between passes that nearly touch it would only grey the colours.
  constexpr double dense = 0.5;
  const bool programmed = thinner > dense;

  update_parts(frame, view, moving);
  for (Layer& layer : layers_) {
    const bool emphasis = layer.role == Role::blend_edge || layer.role == Role::curve_edge ||
                          (layer.role == Role::blend && layer.discs);
    const bool shown =
        (!emphasis || (edges && !moving)) && (layer.role != Role::range || range_) &&
        (layer.role != Role::overlay || overlays_shown()) && (layer.role != Role::rapid || rapids) &&
        (layer.role != Role::programmed || programmed) &&
        (layer.role != Role::difference ||
         (!moving && needs_reference(look_.colouring) && key_.has_scale())) &&
        (layer.role != Role::rest || (stretch_ && !only_)) && (layer.role != Role::stretch_end || stretch_);
    const std::size_t level =
        layer.path != nullptr ? level_of(layer.path->samples(), frame, view, moving) : 0;
    for (std::size_t i = 0; i < layer.actors.size(); ++i) {
      if (shown && i == level && !layer.actors[i]) {
        layer.actors[i] = make_actor(layer, *layer.path->part(i));
      }
      if (layer.actors[i]) {
        layer.actors[i]->SetVisibility(shown && i == level ? 1 : 0);
      }
    }
    if (!shown) {
      continue;
    }
    vtkActor& actor = *layer.actors[level];
    const Style style = style_of(layer.role, thinner);
    const bool many = layer.path != nullptr && layer.path->samples().levels[level].size() > few_wide_lines;
    const bool thin = motion == ViewMotion::in_software && many && layer.role != Role::range;
    const auto pixels = static_cast<float>(thin ? 1.0 : std::max(1.0, style.width * scale));
    actor.GetProperty()->SetLineWidth(pixels);
    actor.GetProperty()->SetPointSize(pixels);
    const Projection::Lift lift = view.lift(style.height * std::max(scale / view.scale, 2e-6));
    const Vec3 origin = frame.to_scene(layer.path != nullptr ? layer.path->samples().origin : rapids_at_);
    const Vec3 at = lift.shift + lift.shrink * origin;
    actor.SetScale(lift.shrink / frame.unit);
    actor.SetPosition(at.x(), at.y(), at.z());
  }
  trail_.place(executed_.get(), look_.colours->highlight, frame, view, scale);
  place_clipping(frame, view);
}

}  // namespace feedscope::ui
