#include "core/analysis/contour/worst_places.h"

#include <algorithm>
#include <cmath>

namespace feedscope {
namespace {

bool is_worse(const ContourNode& a, const ContourNode& b) {
  return a.error > b.error;
}

}  // namespace

double side_of(const Trajectory& trajectory, const ContourNode& node) {
  const Toolpath& path = programmed_path(trajectory);
  const Segment& segment = path.segments[node.foot.segment];
  const Vec3 along = segment.kind == SegmentKind::arc ? path.arc_of(segment).at(node.foot.s).d1
                                                      : path.tangent_at_start(node.foot.segment);
  const double in_plane = std::hypot(along.x(), along.y());
  constexpr double upright = 1e-9;
  const Vec3& offset = node.foot.offset;
  return in_plane > upright ? (along.x() * offset.y() - along.y() * offset.x()) / in_plane : 0.0;
}

void WorstPlaces::visit(const ContourSpan& span) {
  const bool goes_on = open_ && span.from.place.element <= last_element_ + 1;
  const bool has_halved = low_ < best_.error / 2 && span.to.error > 2 * low_;
  if (open_ && (!goes_on || (has_halved && span.to.error > ContourSearch::precision))) {
    close();
  }
  if (!open_) {
    open_ = true;
    best_ = span.from;
    low_ = span.from.error;
  }
  if (span.to.error > best_.error) {
    best_ = span.to;
    low_ = span.to.error;
  }
  low_ = std::min(low_, span.to.error);
  last_element_ = span.to.place.element;
  if (span.bound > best_.error + ContourSearch::precision) {
    hopeful_.push_back(span);
    prune();
  }
}

/// Drops spans that cannot contain a farther place; if many remain, searches them at once.
void WorstPlaces::prune() {
  constexpr std::size_t many = 512;
  if (hopeful_.size() < many) {
    return;
  }
  std::erase_if(hopeful_, [this](const ContourSpan& span) {
    return span.bound <= best_.error + ContourSearch::precision;
  });
  if (hopeful_.size() > many / 2) {
    highest_ = std::max(highest_, search_.largest_in(hopeful_, best_));
  }
}

bool WorstPlaces::takes(double error) const {
  return worst_.size() < most_ ? error > ContourSearch::precision
                               : error > worst_.front().error + ContourSearch::precision;
}

void WorstPlaces::add(const ContourNode& place, double bound) {
  highest_ = std::max(highest_, bound);
  if (worst_.size() == most_) {
    std::ranges::pop_heap(worst_, is_worse);
    worst_.pop_back();
  }
  worst_.push_back(place);
  std::ranges::push_heap(worst_, is_worse);
  if (worst_.size() == most_) {
    search_.look_above(worst_.front().error);
  }
}

void WorstPlaces::close() {
  double bound = best_.error;
  for (const ContourSpan& span : hopeful_) {
    bound = std::max(bound, span.bound);
  }
  if (takes(bound)) {
    highest_ = std::max(highest_, search_.largest_in(hopeful_, best_));
    if (takes(best_.error)) {
      add(best_, best_.error);
    }
  }
  hopeful_.clear();
  open_ = false;
}

void WorstPlaces::finish(ContourErrors& errors, const Trajectory& trajectory) {
  if (open_) {
    close();
  }
  std::ranges::sort(worst_, is_worse);
  constexpr double rounding = 1e-12;  // [mm]
  for (const ContourNode& node : worst_) {
    ContourPlace place;
    place.error = node.error;
    const double side = side_of(trajectory, node);
    place.side = std::abs(side) > rounding ? side : 0;
    place.path_length = search_.course().path_length(node.place);
    place.time = search_.course().time(node.place);
    place.line = trajectory.line_of(node.place.element);
    place.segment = static_cast<std::uint32_t>(node.foot.segment);
    place.position = node.point.position;
    place.programmed = node.point.position - node.foot.offset;
    errors.worst.push_back(place);
  }
  errors.largest = worst_.empty() ? 0 : worst_.front().error;
  errors.uncertainty = std::max(highest_ - errors.largest, 0.0);
}

}  // namespace feedscope
