#include "ui/scene/path/drawn_path.h"

#include <algorithm>
#include <utility>

namespace feedscope::ui {
namespace {

constexpr std::size_t few_points = 100'000;  // a level with fewer is drawn as a whole
constexpr double line_margin = 20;           // [pixels] by which half a line extends into the view
constexpr double window_margin = 0.5;        // of the window, on each side: small moves need no other part

}  // namespace

DrawnPath::DrawnPath(std::shared_ptr<const SampledPath> samples) : samples_(std::move(samples)) {
  if (samples_->boxes.empty()) {
    own_boxes_ = boxes_of(samples_->positions);
  }
  parts_.resize(samples_->levels.size());
}

void DrawnPath::exaggerate(double factor) {
  const bool was_moved = !moved_.empty();
  if (factor == 1 || samples_->found_deviations().shifts.empty()) {
    moved_ = {};
    if (!was_moved) {
      return;
    }
  } else {
    moved_ = samples_->positions;
    const auto more = static_cast<float>(factor - 1);
    const std::vector<StoredVector>& shifts = samples_->found_deviations().shifts;
    for (std::size_t i = 0; i < moved_.size(); ++i) {
      const StoredVector& deviation = shifts[i];
      moved_[i] += more * Eigen::Vector3f(float(deviation[0]), float(deviation[1]), float(deviation[2]));
    }
  }
  own_boxes_ = moved_.empty() && !samples_->boxes.empty() ? std::vector<SpanBox>() : boxes_of(positions());
  for (auto& part : parts_) {
    part.reset();
  }
}

void DrawnPath::set_colours(std::vector<Rgba> colours) {
  colours_ = std::move(colours);
  for (const auto& part : parts_) {
    if (part) {
      part->set_colours(colours_);
    }
  }
}

/// The boxes that `view` may show, with `margin` [pixels] around it.
std::vector<bool> DrawnPath::boxes_in(const SceneFrame& frame, const Projection& view, double margin) const {
  const std::vector<SpanBox>& boxes = this->boxes();
  std::vector<bool> wanted(boxes.size());
  const Vec2 reach = (view.middle + Vec2::Constant(margin)) / view.scale;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Vec3 low = frame.to_scene(samples_->origin + boxes[i].low.cast<double>());
    const Vec3 high = frame.to_scene(samples_->origin + boxes[i].high.cast<double>());
    const Vec3 from_focal = (low + high) / 2 - view.focal;
    const Vec3 half = (high - low) / 2;
    // Everything in the box is at least as large as its farthest point from the eye.
    const double smallest = view.magnification(
        view.focal + view.towards * (from_focal.dot(view.towards) - half.dot(view.towards.cwiseAbs())));
    const Vec2 nearest(std::abs(from_focal.dot(view.right)) - half.dot(view.right.cwiseAbs()),
                       std::abs(from_focal.dot(view.up)) - half.dot(view.up.cwiseAbs()));
    wanted[i] = nearest.x() * smallest <= reach.x() && nearest.y() * smallest <= reach.y();
  }
  return wanted;
}

bool DrawnPath::show(std::size_t level, const SceneFrame& frame, const Projection& view) {
  const bool whole = samples_->levels[level].size() <= few_points;
  std::unique_ptr<PathPart>& part = parts_[level];
  if (part && (whole || part->fits(boxes_in(frame, view, line_margin)))) {
    return false;
  }
  if (!whole) {  // one part with many points is enough
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      if (samples_->levels[i].size() > few_points) {
        parts_[i].reset();
      }
    }
  }
  const double margin = 2 * window_margin * view.middle.maxCoeff();
  part = std::make_unique<PathPart>(*samples_, samples_->levels[level], positions(),
                                    whole ? std::vector<bool>() : boxes_in(frame, view, margin));
  part->set_colours(colours_);
  return true;
}

}  // namespace feedscope::ui
