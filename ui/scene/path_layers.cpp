#include "ui/scene/path_layers.h"

#include <vtkActor.h>
#include <vtkLookupTable.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "ui/scene/path_actors.h"
#include "ui/scene/ticks.h"

namespace feedscope::ui {
namespace {

// Widths and heights in pixels at scale 1. Lines in one place must not fight: each layer is a little nearer
// to the eye, which a parallel projection does not show. A disc bulges towards the eye by half its width, so
// the cut lies above the edge of the blends, and the blends above the cut.
constexpr double thin_width = 1.4;
constexpr double cut_width = 2.6;
constexpr double blend_width = 4.4;
constexpr double blend_edge_width = 7;
constexpr double programmed_height = 1.5;
constexpr double blend_edge_height = 3;
constexpr double cut_height = 8;
constexpr double blend_height = 10;

constexpr double dashes_across = 90;          // along the largest extent
constexpr std::size_t many_points = 200'000;  // below, one level of detail will do
constexpr double points_across = 4000;        // along the largest extent, at the coarsest level
constexpr double least_zoom_step = 4;         // between levels

/// Colours reach to the next half step, so that they end at a value one can name.
double top_of_colours(double peak_feed) {
  const double peak = units::to_mm_min(peak_feed);
  const double half = round_ticks(0, peak, 10).step / 2;
  return half > 0 ? units::from_mm_min(std::ceil(peak / half - 1e-6) * half) : 0;
}

}  // namespace

void PathLayers::clear() {
  for (const Layer& layer : layers_) {
    renderer_.RemoveActor(layer.actor);
  }
  layers_.clear();
  places_.clear();
  details_.clear();
  entries_ = {};
  top_feed_ = rapid_length_ = cut_length_ = blend_length_ = 0;
}

void PathLayers::add(vtkPolyData& lines, vtkSmartPointer<vtkActor> actor, Role role, bool discs,
                     std::size_t level, const SceneFrame& frame, const Vec3& origin) {
  if (lines.GetNumberOfCells() == 0) {
    return;
  }
  actor->SetScale(1 / frame.unit);
  renderer_.AddActor(actor);
  layers_.push_back({std::move(actor), role, discs, level});
  places_.push_back(frame.to_scene(origin));
}

void PathLayers::show(std::shared_ptr<const SampledPath> programmed,
                      std::shared_ptr<const SampledPath> executed, const SceneFrame& frame) {
  clear();
  programmed_ = std::move(programmed);
  if (programmed_ || executed) {
    add_rapids(programmed_ ? *programmed_ : *executed, frame);
  }
  if (programmed_) {
    const auto lines = polylines(*programmed_, [](SpanKind kind) { return kind == SpanKind::cut; });
    entries_.programmed = lines->GetNumberOfCells() > 0;
    add(*lines, line_actor(*lines, palette::programmed), Role::programmed, false, 0, frame,
        programmed_->origin);
  }
  if (executed) {
    add_executed(std::move(executed), frame);
  }
}

void PathLayers::add_rapids(const SampledPath& path, const SceneFrame& frame) {
  const auto dashes = rapid_dashes(path, frame.unit / dashes_across);
  rapid_length_ = length_of(path, SpanKind::rapid);
  entries_.rapid = dashes->GetNumberOfCells() > 0;
  add(*dashes, line_actor(*dashes, palette::rapid), Role::rapid, false, 0, frame, path.origin);
}

void PathLayers::add_executed(std::shared_ptr<const SampledPath> executed, const SceneFrame& frame) {
  cut_length_ = length_of(*executed, SpanKind::cut);
  blend_length_ = length_of(*executed, SpanKind::blend);
  entries_.blend = blend_length_ > 0;
  top_feed_ = top_of_colours(executed->peak_feed);
  details_.push_back({executed, 0});
  double spacing = frame.unit / points_across / least_zoom_step;
  while (details_.back().path->size() > many_points && spacing <= frame.unit / points_across) {
    auto coarser = std::make_shared<const SampledPath>(thinned(*executed, spacing));
    if (2 * coarser->size() < details_.back().path->size()) {
      details_.push_back({std::move(coarser), spacing});
    }
    spacing *= least_zoom_step;
  }
  const auto colours = feed_colours(top_feed_);
  for (std::size_t level = 0; level < details_.size(); ++level) {
    const SampledPath& path = *details_[level].path;
    const auto lines = polylines(path, [](SpanKind kind) { return kind != SpanKind::rapid; });
    const auto blends = polylines(path, [](SpanKind kind) { return kind == SpanKind::blend; });
    add(*lines, line_actor(*lines, *colours), Role::cut, false, level, frame, path.origin);
    add(*blends, line_actor(*blends, *colours), Role::blend, false, level, frame, path.origin);
    add(*blends, line_actor(*blends, palette::blend_edge), Role::blend_edge, false, level, frame,
        path.origin);
    const auto joins = blend_points(path);
    add(*joins, line_actor(*joins, *colours), Role::blend, true, level, frame, path.origin);
    add(*joins, line_actor(*joins, palette::blend_edge), Role::blend_edge, true, level, frame, path.origin);
    entries_.executed = entries_.executed || lines->GetNumberOfCells() > 0;
  }
}

/// Share of the box's outline on the screen that lines would cover; `drawn`: length times width [mm pixels].
double PathLayers::crowding(const SceneFrame& frame, const Projection& view, double drawn) const {
  const Vec3 size = frame.box.max - frame.box.min;
  const Vec3 faces(size.y() * size.z(), size.z() * size.x(), size.x() * size.y());
  const Vec2 across(size.dot(view.right.cwiseAbs()), size.dot(view.up.cwiseAbs()));
  constexpr double least_share = 0.15;  // of the square over its extent, for a box seen from its edge
  const double area = view.scale * view.scale *
                      std::max(faces.dot(view.towards.cwiseAbs()), least_share * across.squaredNorm());
  return drawn * view.scale / frame.unit / std::max(area, 1.0);
}

void PathLayers::place(const SceneFrame& frame, const Projection& view, double scale) {
  constexpr double comfortable = 0.35;
  const double lines =
      crowding(frame, view, scale * (cut_length_ * cut_width + blend_length_ * blend_edge_width));
  const double thinner = std::min(1.0, comfortable / std::max(lines, 1e-9));
  const bool edges = thinner > 0.9;
  entries_.blend = blend_length_ > 0 && edges;
  const double rapids = crowding(frame, view, scale * rapid_length_ * thin_width / 2);
  const double rapid_opacity = std::clamp(comfortable / std::max(rapids, 1e-9), 0.08, 1.0);

  constexpr double invisible = 0.7;  // [pixels]
  std::size_t level = 0;
  while (level + 1 < details_.size() && details_[level + 1].spacing / frame.unit * view.scale < invisible) {
    ++level;
  }

  for (std::size_t i = 0; i < layers_.size(); ++i) {
    const Layer& layer = layers_[i];
    const bool of_blend = layer.role == Role::blend || layer.role == Role::blend_edge;
    const bool executed = of_blend || layer.role == Role::cut;
    const bool emphasis = layer.role == Role::blend_edge || layer.discs;
    layer.actor->SetVisibility((!executed || layer.level == level) && (!emphasis || edges) ? 1 : 0);

    double width = thin_width;
    double height = 0;
    switch (layer.role) {
      case Role::rapid:
        layer.actor->GetProperty()->SetOpacity(rapid_opacity);
        break;
      case Role::programmed:
        width = thin_width * thinner;
        height = programmed_height;
        break;
      case Role::cut:
        width = cut_width * thinner;
        height = cut_height;
        break;
      case Role::blend:
        width = blend_width * thinner;
        height = blend_height;
        break;
      case Role::blend_edge:
        width = blend_edge_width * thinner;
        height = blend_edge_height;
        break;
    }
    const auto pixels = static_cast<float>(std::max(1.0, width * scale));
    layer.actor->GetProperty()->SetLineWidth(pixels);
    layer.actor->GetProperty()->SetPointSize(pixels);
    const double lift = height * std::max(scale / view.scale, 2e-6);
    const Vec3 at = places_[i] + lift * view.towards;
    layer.actor->SetPosition(at.x(), at.y(), at.z());
  }
}

}  // namespace feedscope::ui
