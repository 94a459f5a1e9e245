#include "core/program/path/contour_watch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/base/geometry.h"

namespace feedscope {

namespace {

/// Distance within which the ends of a round of the contour coincide [mm].
constexpr double same_place = 1e-3;
/// The same for levels [mm].
constexpr double same_level = 1e-3;

/// Position of a point of the element along it [mm].
double place_along(const PlaneElement& element, const Vec2& point) {
  if (!element.is_arc()) {
    return (point - element.start).dot(element.tangent_at_start());
  }
  const Vec2 from = element.start - element.center;
  const Vec2 to = point - element.center;
  const double angle = element.turn * std::atan2(cross(from, to), from.dot(to));
  return element.radius * (angle < 0 ? angle + 2 * std::numbers::pi : angle);
}

bool on_one_level(const ContourWatch::Levels& a, const ContourWatch::Levels& b) {
  return a.low <= b.high + same_level && b.low <= a.high + same_level;
}

}  // namespace

void ContourWatch::Window::add(const Piece& piece) {
  if (groups_.empty() || groups_.back().pieces.size() == group_size) {
    if (groups_.size() * group_size >= reach) {
      groups_.pop_front();
    }
    groups_.emplace_back().pieces.reserve(group_size);
  }
  groups_.back().pieces.push_back(piece);
  groups_.back().box.add(piece.box);
}

template <typename Look>
void ContourWatch::Window::look_near(const PlaneBox& box, double distance, const Look& look) {
  for (Group& group : groups_) {
    if (!group.box.is_near(box, distance)) {
      continue;
    }
    for (Piece& piece : group.pieces) {
      if (piece.box.is_near(box, distance)) {
        look(piece);
      }
    }
  }
}

void ContourWatch::clear() {
  paths_.clear();
  contours_.clear();
  last_.reset();
}

void ContourWatch::add_path(const PlaneElement& path, const Levels& levels,
                            const DiagnosticLog::Place& place) {
  if (!beside_full_circle_) {
    paths_.add({path, box_of(path), levels, place});
  }
}

std::vector<ContourWatch::Cut> ContourWatch::add_contour(const PlaneElement& contour, const Levels& levels,
                                                         double radius, double allowed) {
  const Piece next{contour, box_of(contour), levels, {}};
  const PlaneElement of_round = up_to_meeting(next);
  std::vector<Cut> cuts;
  paths_.look_near(box_of(of_round), radius, [&](Piece& path) {
    if (path.named || !on_one_level(path.levels, levels)) {
      return;
    }
    const double depth = radius - distance(path.element, of_round);
    if (depth > allowed) {
      path.named = true;
      cuts.push_back({path.place, depth});
    }
  });
  beside_full_circle_ = contour.sweep >= 2 * std::numbers::pi - same_point;
  if (beside_full_circle_ || meets_itself(next)) {
    clear();
  } else {
    if (last_) {
      contours_.add(*last_);
    }
    last_ = next;
  }
  return cuts;
}

PlaneElement ContourWatch::up_to_meeting(const Piece& next) {
  double nearest = std::numeric_limits<double>::infinity();
  Vec2 end = next.element.end;
  const auto consider = [&](const Vec2& point, const PlaneElement& earlier) {
    if (distance(point, next.element) > same_place || distance(point, earlier) > same_place) {
      return;
    }
    if (const double along = place_along(next.element, point); along > same_place && along < nearest) {
      nearest = along;
      end = point;
    }
  };
  contours_.look_near(next.box, same_place, [&](const Piece& earlier) {
    if (!on_one_level(earlier.levels, next.levels)) {
      return;
    }
    const Meetings found = meetings(next.element, earlier.element);
    for (int i = 0; i < found.count; ++i) {
      consider(found.points[static_cast<std::size_t>(i)], earlier.element);
    }
    consider(earlier.element.start, earlier.element);
    consider(earlier.element.end, earlier.element);
  });
  if ((end - next.element.end).norm() <= same_place) {
    return next.element;
  }
  return next.element.is_arc()
             ? PlaneElement::arc(next.element.start, end, next.element.center, next.element.turn, 0)
             : PlaneElement::line(next.element.start, end);
}

bool ContourWatch::meets_itself(const Piece& next) {
  bool meets = last_ && (next.element.end - last_->element.start).norm() <= same_place;
  contours_.look_near(next.box, same_place, [&](const Piece& piece) {
    meets = meets || distance(piece.element, next.element) <= same_place;
  });
  return meets;
}

}  // namespace feedscope
