#include "ui/scene/path/pick.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace feedscope::ui {
namespace {

/// The nearest point of a span to a place on the screen.
struct Passage {
  double distance = std::numeric_limits<double>::infinity();  ///< on the screen [pixels]
  double depth = -std::numeric_limits<double>::infinity();    ///< towards the eye [pixels]
  double u = 0;                                               ///< fraction of the span
};

Passage passage(const Vec2& place, const Vec3& from, const Vec3& to) {
  const Vec2 span = (to - from).head<2>();
  const double length = span.squaredNorm();
  const double u = length > 0 ? std::clamp((place - from.head<2>()).dot(span) / length, 0.0, 1.0) : 0.0;
  const Vec3 nearest = from + u * (to - from);
  return {(nearest.head<2>() - place).norm(), nearest.z(), u};
}

/// A path projected onto the screen.
class SeenPath {
 public:
  SeenPath(const PickablePath& path, const ScreenMap& project) : path_(path), project_(project) {}

  std::size_t spans() const { return std::max<std::size_t>(1, path_.samples->size() - 1); }
  Vec3 point(std::size_t i) const {
    return project_(path_.samples->origin + (*path_.positions)[i].cast<double>());
  }
  Vec3 end(std::size_t span) const { return point(std::min(span + 1, path_.samples->size() - 1)); }
  bool is_gap(std::size_t span) const { return path_.samples->kinds[span] == SpanKind::gap; }
  bool is_hidden(std::size_t span) const {
    const auto& times = path_.samples->times;
    return path_.only &&
           (times[std::min(span + 1, times.size() - 1)] < (*path_.only)[0] || times[span] > (*path_.only)[1]);
  }
  Passage passage_of(std::size_t span, const Vec2& place) const {
    return is_gap(span) || is_hidden(span) ? Passage() : passage(place, point(span), end(span));
  }
  ScreenMap::Rectangle rectangle(std::size_t box) const {
    const SpanBox& b = (*path_.boxes)[box];
    return project_.rectangle(path_.samples->origin + b.low.cast<double>(),
                              path_.samples->origin + b.high.cast<double>());
  }
  /// Calls `use(span)` for the spans of a box.
  template <class Use>
  void for_spans(std::size_t box, Use use) const {
    const std::size_t end = std::min(spans(), (box + 1) * spans_of_box);
    for (std::size_t span = box * spans_of_box; span < end; ++span) {
      use(span);
    }
  }

 private:
  const PickablePath& path_;
  const ScreenMap& project_;
};

/// The nearest span; of several in one place the one in front.
std::optional<std::size_t> nearest_span(const SeenPath& seen, std::size_t boxes, const Vec2& place,
                                        double radius) {
  double least = radius;
  bool found = false;
  std::vector<std::size_t> near;
  for (std::size_t box = 0; box < boxes; ++box) {
    if (seen.rectangle(box).distance(place) > least + 1) {
      continue;
    }
    near.push_back(box);
    seen.for_spans(box, [&](std::size_t span) {
      const double distance = seen.passage_of(span, place).distance;
      found = found || distance <= radius;
      least = std::min(least, distance);
    });
  }
  if (!found) {
    return std::nullopt;
  }
  std::size_t best = 0;
  Passage chosen;
  for (const std::size_t box : near) {
    seen.for_spans(box, [&](std::size_t span) {
      const Passage p = seen.passage_of(span, place);
      const bool in_front = p.depth > chosen.depth + 1;
      const bool level = std::abs(p.depth - chosen.depth) <= 1;
      if (p.distance <= least + 1 && (in_front || (level && p.distance < chosen.distance))) {
        chosen = p;
        best = span;
      }
    });
  }
  // The minimum of the distance within that pass.
  const auto distance_of = [&](std::size_t span) { return seen.passage_of(span, place).distance; };
  while (best + 1 < seen.spans() && distance_of(best + 1) < distance_of(best)) {
    ++best;
  }
  while (best > 0 && distance_of(best - 1) < distance_of(best)) {
    --best;
  }
  return best;
}

double nearest_on(const Trajectory& trajectory, const ScreenMap& project, const Vec2& place, double low,
                  double high) {
  const auto distance_at = [&](double time) {
    return (project(trajectory.state(time).position).head<2>() - place).squaredNorm();
  };
  constexpr int rounds = 60;  // each removes a third: 1e-10 of the span remains
  for (int i = 0; i < rounds; ++i) {
    const double a = low + (high - low) / 3;
    const double b = high - (high - low) / 3;
    if (distance_at(a) <= distance_at(b)) {
      high = b;
    } else {
      low = a;
    }
  }
  return (low + high) / 2;
}

/// The two samples around a time.
struct PathInstant {
  std::size_t before = 0;
  std::size_t after = 0;
  double u = 0;  ///< fraction between them
};

PathInstant instant(const std::vector<double>& times, double time) {
  const auto next = static_cast<std::size_t>(std::ranges::upper_bound(times, time) - times.begin());
  PathInstant at;
  at.after = std::min(next, times.size() - 1);
  at.before = at.after > 0 ? at.after - 1 : 0;
  const double span = times[at.after] - times[at.before];
  at.u = span > 0 ? std::clamp((time - times[at.before]) / span, 0.0, 1.0) : 1.0;
  return at;
}

}  // namespace

ScreenMap::ScreenMap(const Projection& projection, const SceneFrame& frame) : middle_(projection.middle) {
  linear_ << projection.right.transpose(), projection.up.transpose(), projection.towards.transpose();
  linear_ *= projection.scale / frame.unit;
  // The focal point is drawn at the centre, at depth 0.
  offset_ = -linear_ * (frame.centre + frame.unit * projection.focal);
  offset_.head<2>() += middle_;
  eye_ = projection.eye_distance * projection.scale;
}

Vec3 ScreenMap::operator()(const Vec3& point) const {
  Vec3 display = linear_ * point + offset_;
  if (eye_ > 0) {
    constexpr double nearest = 0.02;  // as Projection::magnification
    const double magnification = 1 / std::max(nearest, 1 - display.z() / eye_);
    display.head<2>() = middle_ + magnification * (display.head<2>() - middle_);
  }
  return display;
}

ScreenMap::Rectangle ScreenMap::rectangle(const Vec3& low, const Vec3& high) const {
  if (eye_ == 0) {
    const Vec2 centre = (linear_ * ((low + high) / 2) + offset_).head<2>();
    const Vec2 half = (linear_.cwiseAbs() * ((high - low) / 2)).head<2>();
    return {centre - half, centre + half};
  }
  Rectangle around{Vec2::Constant(std::numeric_limits<double>::infinity()),
                   Vec2::Constant(-std::numeric_limits<double>::infinity())};
  for (unsigned corner = 0; corner < 8; ++corner) {
    const Vec3 at((corner & 1U) != 0 ? high.x() : low.x(), (corner & 2U) != 0 ? high.y() : low.y(),
                  (corner & 4U) != 0 ? high.z() : low.z());
    const Vec2 display = (*this)(at).head<2>();
    around.low = around.low.cwiseMin(display);
    around.high = around.high.cwiseMax(display);
  }
  return around;
}

std::optional<double> nearest_time(const PickablePath& path, const Trajectory* trajectory,
                                   const ScreenMap& project, const Vec2& place, double radius) {
  if (path.samples == nullptr || path.samples->size() == 0) {
    return std::nullopt;
  }
  const SeenPath seen(path, project);
  const auto span = nearest_span(seen, path.boxes->size(), place, radius);
  if (!span) {
    return std::nullopt;
  }
  const double from = path.samples->times[*span];
  const double to = path.samples->times[std::min(*span + 1, path.samples->size() - 1)];
  if (trajectory != nullptr) {
    return nearest_on(*trajectory, project, place, from, to);
  }
  return std::lerp(from, to, seen.passage_of(*span, place).u);
}

std::optional<std::array<double, 2>> times_within(const PickablePath& path, const ScreenMap& project,
                                                  const Vec2& low, const Vec2& high) {
  if (path.samples == nullptr || path.samples->size() == 0) {
    return std::nullopt;
  }
  const SeenPath seen(path, project);
  const std::vector<double>& times = path.samples->times;
  const std::size_t last = path.samples->size() - 1;
  std::optional<std::array<double, 2>> range;
  const auto add = [&](double from, double to) {
    range = range ? std::array{std::min((*range)[0], from), std::max((*range)[1], to)} : std::array{from, to};
  };
  for (std::size_t box = 0; box < path.boxes->size(); ++box) {
    const auto around = seen.rectangle(box);
    if (!around.touches(low, high)) {
      continue;
    }
    if (around.within(low, high)) {
      add(times[box * spans_of_box], times[std::min(last, (box + 1) * spans_of_box)]);
      continue;
    }
    seen.for_spans(box, [&](std::size_t span) {
      if (seen.is_gap(span)) {
        return;
      }
      // The fraction of the span inside, from one end to the other (Liang and Barsky).
      const Vec2 from = seen.point(span).head<2>();
      const Vec2 along = seen.end(span).head<2>() - from;
      double enter = 0;
      double leave = 1;
      for (int axis = 0; axis < 2; ++axis) {
        const double a = low[axis] - from[axis];
        const double b = high[axis] - from[axis];
        if (std::abs(along[axis]) < 1e-12) {
          leave = a > 0 || b < 0 ? -1 : leave;
          continue;
        }
        enter = std::max(enter, std::min(a / along[axis], b / along[axis]));
        leave = std::min(leave, std::max(a / along[axis], b / along[axis]));
      }
      if (enter <= leave) {
        const double start = times[span];
        const double end = times[std::min(span + 1, last)];
        add(std::lerp(start, end, enter), std::lerp(start, end, leave));
      }
    });
  }
  return range;
}

double value_at(const PickablePath& path, Colouring quantity, double time) {
  if (path.samples == nullptr || !path.samples->executed()) {
    return 0;
  }
  const PathInstant at = instant(path.samples->times, time);
  return std::lerp(path.samples->value(quantity, at.before), path.samples->value(quantity, at.after), at.u);
}

std::optional<double> lost_at(const PickablePath& path, double time) {
  if (path.samples == nullptr || !path.samples->compared()) {
    return std::nullopt;
  }
  const PathInstant at = instant(path.samples->times, time);
  const std::vector<float>& lost = path.samples->lost;
  return std::lerp(double{lost[at.before]}, double{lost[at.after]}, at.u);
}

Vec3 deviation_at(const PickablePath& path, double time) {
  if (path.samples == nullptr || path.samples->found_deviations().shifts.empty()) {
    return Vec3::Zero();
  }
  const PathInstant at = instant(path.samples->times, time);
  const Vec3 from = path.samples->deviation(at.before);
  return from + at.u * (path.samples->deviation(at.after) - from);
}

Bounds bounds_between(const PickablePath& path, double from, double to) {
  Bounds bounds;
  if (path.samples == nullptr || path.samples->size() == 0) {
    return bounds;
  }
  const std::vector<double>& times = path.samples->times;
  const auto position = [&](std::size_t i) {
    return Vec3(path.samples->origin + (*path.positions)[i].cast<double>());
  };
  for (const double time : {from, to}) {
    const PathInstant at = instant(times, time);
    bounds.add(position(at.before) + at.u * (position(at.after) - position(at.before)));
  }
  const auto first = static_cast<std::size_t>(std::ranges::lower_bound(times, from) - times.begin());
  const auto end = static_cast<std::size_t>(std::ranges::upper_bound(times, to) - times.begin());
  for (std::size_t i = first; i < end; ++i) {
    bounds.add(position(i));
  }
  return bounds;
}

}  // namespace feedscope::ui
