#include "core/program/heidenhain/cycles/boring_cycles.h"

#include <cmath>

#include "core/program/heidenhain/geometry/tool_axis_moves.h"

namespace feedscope::heidenhain {

void bore(const DrillingParameters& words, const Hole& hole, ToolAxisMoves& moves) {
  constexpr double off_the_wall = 0.2;
  moves.cut(hole.bottom, words.feed);
  moves.dwell(words.bottom_dwell);
  const bool retreats = words.retreat >= 1 && words.retreat <= 4;
  const int retreat = retreats ? static_cast<int>(words.retreat) : 0;
  if (retreats) {
    moves.shift(retreat, off_the_wall);
  }
  moves.cut(hole.top, or_else(words.retract_feed, words.feed));
  moves.rapid(hole.out);
  if (retreats) {
    moves.shift(retreat, -off_the_wall);
  }
}

void bore_backwards(const DrillingParameters& words, const Hole& hole, ToolAxisMoves& moves) {
  const int direction = static_cast<int>(words.retreat);
  const double underside = words.surface - words.thickness;
  const double below = underside - words.clearance - words.edge_height;
  moves.shift(direction, words.off_center);
  moves.cut(below, words.start_feed);
  moves.shift(direction, -words.off_center);
  moves.cut(underside + words.counterbore - words.edge_height, words.counterbore_feed);
  moves.dwell(words.counterbore_dwell);
  moves.cut(below, words.start_feed);
  moves.shift(direction, words.off_center);
  moves.cut(hole.top, words.start_feed);
  moves.rapid(hole.out);
  moves.shift(direction, -words.off_center);
}

namespace {

/// From the centre on a half circle to the wall, down a helix, once round and back to the centre.
void mill_circles(const DrillingParameters& words, const Hole& hole, double radius,
                  const DrillingPlace& place) {
  PathWriter& path = place.path;
  const int axis = normal_axis(place.plane);
  const Vec3 side = Vec3::Unit(first_axis(place.plane));
  Vec3 center = path.position();
  path.set_feed_mode(FeedMode::per_minute);
  path.set_feed(std::isinf(words.feed) ? 0 : words.feed);
  ArcRequest arc;
  arc.axis = words.climb < 0 ? Vec3(-normal_of(place.plane)) : normal_of(place.plane);
  const auto half_circle = [&](double direction) {
    arc.target = path.position() + direction * radius * side;
    arc.center = path.position() + direction * radius / 2 * side;
    arc.extra_turns = 0;
    path.arc_by_center(arc);
  };
  half_circle(1);
  const double turns = std::max(1.0, std::ceil((hole.top - hole.bottom) / words.helix_infeed - 1e-9));
  arc.target = path.position();
  arc.target[axis] = hole.bottom;
  arc.center = center;
  arc.extra_turns = turns - 1;
  path.arc_by_center(arc);
  arc.extra_turns = 0;
  path.arc_by_center(arc);
  half_circle(-1);
}

}  // namespace

void mill_bore(const DrillingParameters& words, const Hole& hole, const DrillingPlace& place) {
  const double radius = words.diameter / 2 - *place.tool_radius;
  if (radius > same_point) {
    mill_circles(words, hole, radius, place);
  }
  ToolAxisMoves moves(place);
  moves.cut(hole.bottom, words.feed);  // nothing if the circles ended there
  moves.rapid(hole.top);
  moves.rapid(hole.out);
  run(moves.plan(), place.path, place.path.position());
}

}  // namespace feedscope::heidenhain
