#include "ui/scene/camera/fit_outline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace feedscope::ui {
namespace {

double cross(const Vec2& a, const Vec2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// Tries sizes of the outline.
class OutlineFitter {
 public:
  OutlineFitter(const std::vector<Vec2>& hull, const ScreenRectangle& room,
                const std::vector<ScreenRectangle>& covered)
      : hull_(hull), box_(box_around(hull)), room_(room), covered_(covered) {}

  /// The largest size in the room without covered parts, at most `largest`.
  double largest_in_room(double largest) const {
    for (int axis = 0; axis < 2; ++axis) {
      const double size = box_.size()[axis];
      largest = size > 0 ? std::min(largest, room_.size()[axis] / size) : largest;
    }
    return largest;
  }

  /// The nearest place to the centre where the outline is free; none if there is no such place.
  std::optional<Vec2> free_place(double factor) const {
    const Vec2 first = room_.low - factor * box_.low;
    const Vec2 last = room_.high - factor * box_.high;
    std::optional<Vec2> best;
    double nearest = 0;
    for (int i = 0; i <= steps; ++i) {
      for (int k = 0; k <= steps; ++k) {
        const Vec2 share(static_cast<double>(i) / steps, static_cast<double>(k) / steps);
        const Vec2 place = first + share.cwiseProduct(last - first);
        const double away = (place - (first + last) / 2).squaredNorm();
        if ((!best || away < nearest) && is_free(factor, place)) {
          best = place;
          nearest = away;
        }
      }
    }
    return best;
  }

 private:
  static constexpr int steps = 16;  // places in each direction; even, so that one is the centre

  bool is_free(double factor, const Vec2& place) const {
    return std::ranges::none_of(covered_, [&](const ScreenRectangle& rectangle) {
      return meets({(rectangle.low - place) / factor, (rectangle.high - place) / factor});
    });
  }

  /// Two convex shapes are apart if an edge of one of them separates them.
  bool meets(const ScreenRectangle& rectangle) const {
    if (!rectangle.meets(box_)) {
      return false;
    }
    for (std::size_t i = 0; i < hull_.size(); ++i) {
      const Vec2& from = hull_[i];
      const Vec2 edge = hull_[(i + 1) % hull_.size()] - from;
      const Vec2 out(edge.y(), -edge.x());
      const Vec2 nearest(out.x() > 0 ? rectangle.low.x() : rectangle.high.x(),
                         out.y() > 0 ? rectangle.low.y() : rectangle.high.y());
      if (out.dot(nearest - from) > 0) {
        return false;
      }
    }
    return true;
  }

  const std::vector<Vec2>& hull_;
  ScreenRectangle box_;
  ScreenRectangle room_;
  const std::vector<ScreenRectangle>& covered_;
};

}  // namespace

ScreenRectangle box_around(const std::vector<Vec2>& points) {
  ScreenRectangle box{points.front(), points.front()};
  for (const Vec2& point : points) {
    box.low = box.low.cwiseMin(point);
    box.high = box.high.cwiseMax(point);
  }
  return box;
}

namespace {

/// Removes points inside the octagon of the farthest points in eight directions: they are not on the hull,
/// and few others need sorting.
void keep_outer(std::vector<Vec2>& points) {
  const std::array<Vec2, 8> directions{Vec2(1, 0),  Vec2(1, 1),   Vec2(0, 1),  Vec2(-1, 1),
                                       Vec2(-1, 0), Vec2(-1, -1), Vec2(0, -1), Vec2(1, -1)};
  std::array<Vec2, directions.size()> corners;
  corners.fill(points.front());
  for (const Vec2& point : points) {
    for (std::size_t k = 0; k < corners.size(); ++k) {
      corners[k] = directions[k].dot(point) > directions[k].dot(corners[k]) ? point : corners[k];
    }
  }
  std::erase_if(points, [&](const Vec2& point) {
    bool inside = false;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Vec2 side = corners[(k + 1) % corners.size()] - corners[k];
      if (!side.isZero(0)) {
        if (cross(side, point - corners[k]) <= 0) {
          return false;
        }
        inside = true;
      }
    }
    return inside;
  });
}

}  // namespace

std::vector<Vec2> convex_hull(std::vector<Vec2> points) {
  if (!points.empty()) {
    keep_outer(points);
  }
  const auto before = [](const Vec2& a, const Vec2& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  };
  std::sort(points.begin(), points.end(), before);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) {
    return points;
  }
  std::vector<Vec2> hull;
  const auto add_chain = [&](auto first, auto last) {  // Andrew's monotone chain
    const std::size_t start = hull.size();
    for (auto point = first; point != last; ++point) {
      while (hull.size() >= start + 2 &&
             cross(hull.back() - hull[hull.size() - 2], *point - hull.back()) <= 0) {
        hull.pop_back();
      }
      hull.push_back(*point);
    }
    hull.pop_back();  // it is the start of the other chain
  };
  add_chain(points.begin(), points.end());
  add_chain(points.rbegin(), points.rend());
  return hull;
}

FittedOutline fit_outline(const std::vector<Vec2>& hull, const ScreenRectangle& room,
                          const std::vector<ScreenRectangle>& covered, double largest) {
  if (hull.empty()) {
    return {};
  }
  const OutlineFitter fitter(hull, room, covered);
  double high = fitter.largest_in_room(largest);
  if (const auto place = fitter.free_place(high)) {
    return {high, *place};
  }
  double low = 0;
  FittedOutline best{high, room.centre() - high * box_around(hull).centre()};  // if all of it is covered
  while (high - low > 1e-3 * high) {
    const double factor = (low + high) / 2;
    if (const auto place = fitter.free_place(factor)) {
      best = {factor, *place};
      low = factor;
    } else {
      high = factor;
    }
  }
  return best;
}

}  // namespace feedscope::ui
