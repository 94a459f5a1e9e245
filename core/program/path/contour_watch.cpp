#include "core/program/path/contour_watch.h"

#include <algorithm>
#include <numbers>

#include "core/base/geometry.h"

namespace feedscope {

namespace {

/// Ends of a round of the contour are this close [mm].
constexpr double same_place = 1e-3;
/// The same of levels [mm].
constexpr double same_level = 1e-3;

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
  std::vector<Cut> cuts;
  paths_.look_near(next.box, radius, [&](Piece& path) {
    if (path.named || !on_one_level(path.levels, levels)) {
      return;
    }
    const double depth = radius - distance(path.element, contour);
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

bool ContourWatch::meets_itself(const Piece& next) {
  bool meets = last_ && (next.element.end - last_->element.start).norm() <= same_place;
  contours_.look_near(next.box, same_place, [&](const Piece& piece) {
    meets = meets || distance(piece.element, next.element) <= same_place;
  });
  return meets;
}

}  // namespace feedscope
