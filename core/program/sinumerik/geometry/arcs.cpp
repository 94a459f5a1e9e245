#include "core/program/sinumerik/geometry/arcs.h"

#include <algorithm>
#include <cmath>

#include "core/base/units.h"

namespace feedscope::sinumerik {

namespace {

constexpr double straight_share = 1e-9;

}  // namespace

void Arcs::move(const Vec3& target) {
  switch (modal_.motion->action) {
    case Action::arc_through:
      arc_through(target);
      break;
    case Action::arc_tangent:
      tangent_arc(target);
      break;
    default:
      arc(target);
  }
}

void Arcs::straight(const Vec3& target) {
  last_.set_line();
  path().line(target);
}

void Arcs::by_center(const ArcRequest& request) {
  last_.set_arc_by_center(request);
  path().arc_by_center(request);
}

void Arcs::by_radius(const ArcRequest& request) {
  last_.set_arc_by_radius(request);
  path().arc_by_radius(request);
}

void Arcs::arc(const Vec3& target) {
  const Vec3 normal = normal_of(modal_.plane);
  ArcRequest request;
  request.target = target;
  request.axis = modal_.motion->action == Action::arc_ccw ? normal : Vec3(-normal);
  request.extra_turns = extra_turns();
  if (words_.has(Address::ar)) {
    angle_arc(target, request);
  } else {
    plain_arc(target, request);
  }
}

double Arcs::extra_turns() const {
  if (!words_.has(Address::turn)) {
    return 0;
  }
  constexpr double max_turns = 999;
  const BlockWords::Value& turns = words_[Address::turn];
  if (turns.value >= 0 && turns.value <= max_turns && turns.value == std::floor(turns.value)) {
    return turns.value;
  }
  report(Severity::error, "arc-turns", 0, turns.column, [&] {
    return Text{message(NC_("core", "TURN={} is not a number of turns from 0 to {}"), turns.value, max_turns),
                NC_("core", "no extra turn is used")};
  });
  return 0;
}

/// Arc by a radius, a centre, or the pole.
void Arcs::plain_arc(const Vec3& target, ArcRequest& request) {
  const bool has_center = words_.has_any("IJK");
  if (words_.has(Address::cr)) {
    if (has_center) {
      report(Severity::error, "arc-center", 1, words_.first_column("IJK"), [] {
        return Text{NC_("core", "the arc has both a centre (I, J, K) and a radius (CR)"),
                    NC_("core", "CR is used; remove one of them")};
      });
    }
    request.radius = to_mm(words_[Address::cr].value);
    request.column = words_[Address::cr].column;
    by_radius(request);
    return;
  }
  if (!has_center && !words_.is_polar()) {
    report(Severity::error, "arc-center", 0, words_.first_column("XYZ"), [] {
      return Text{NC_("core", "the arc has neither a centre (I, J, K) nor a radius (CR)"), straight_instead};
    });
    straight(target);
    return;
  }
  request.center = has_center ? targets_.center() : targets_.pole();
  request.column = words_.first_column("IJK");
  by_center(request);
}

/// Arc by its opening angle, with a centre or with an end.
void Arcs::angle_arc(const Vec3& target, ArcRequest& request) {
  const BlockWords::Value& word = words_[Address::ar];
  request.column = word.column;
  const double angle = units::from_deg(word.value);
  if (!(word.value > 0 && word.value < 360)) {
    report(Severity::error, "arc-angle", 0, word.column, [&] {
      return Text{message(NC_("core", "opening angle AR={} is not between 0 and 360 degrees"), word.value),
                  straight_instead};
    });
    straight(target);
    return;
  }
  const Vec3 start = path().position();
  if (words_.has_any("IJK")) {
    request.center = targets_.center();
    const Vec3 from = start - request.center;
    const Vec3 in_plane = from - request.axis.dot(from) * request.axis;
    const Vec3 turned = std::cos(angle) * in_plane + std::sin(angle) * request.axis.cross(in_plane);
    const double rise = request.axis.dot(target - start);
    request.target = start - in_plane + turned + rise * request.axis;
    by_center(request);
    return;
  }
  const Vec3 to_end = target - start;
  const double chord = (to_end - request.axis.dot(to_end) * request.axis).norm();
  const double radius = chord / (2 * std::sin(angle / 2));
  request.radius = word.value > 180 ? -radius : radius;
  by_radius(request);
}

/// CIP: through the point I1, J1, K1, in any plane.
void Arcs::arc_through(const Vec3& target) {
  const Vec3 start = path().position();
  Vec3 middle = start;
  std::uint32_t column = words_.first_column("XYZ");
  constexpr std::array<Address, 3> words{Address::i1, Address::j1, Address::k1};
  for (std::size_t axis = 0; axis < words.size(); ++axis) {
    if (!words_.has(words[axis])) {
      continue;
    }
    const BlockWords::Value& word = words_[words[axis]];
    const double value = to_mm(word.value);
    double& coordinate = middle[static_cast<int>(axis)];
    coordinate = modal_.is_incremental(word) ? coordinate + value : value;
    column = word.column;
  }
  const Vec3 a = middle - start;
  const Vec3 b = target - start;
  const Vec3 normal = a.cross(b);
  if (normal.norm() <= straight_share * std::max(a.squaredNorm(), b.squaredNorm())) {
    report(Severity::error, "arc-middle", 0, column, [] {
      return Text{NC_("core", "start, intermediate point (I1, J1, K1) and end of CIP are on one line"),
                  straight_instead};
    });
    straight(target);
    return;
  }
  ArcRequest request;
  request.target = target;
  request.axis = normal.normalized();
  // Centre of the circle through three points, seen from the first.
  request.center = start + (b.squaredNorm() * normal.cross(a) - a.squaredNorm() * normal.cross(b)) /
                               (2 * normal.squaredNorm());
  request.column = column;
  by_center(request);
}

/// CT: continues along the end direction of the previous motion, in the plane.
void Arcs::tangent_arc(const Vec3& target) {
  const Vec3 normal = normal_of(modal_.plane);
  const auto level = [&normal](const Vec3& v) -> Vec3 { return v - normal.dot(v) * normal; };
  const Vec3 start = path().position();
  const Vec3 tangent = level(last_.direction(path()));
  const Vec3 chord = level(target - start);
  if (tangent.norm() <= same_point) {
    report(Severity::error, "arc-tangent", 0, words_.first_column("XYZ"), [] {
      return Text{NC_("core", "CT without a preceding motion in its plane"), straight_instead};
    });
    straight(target);
    return;
  }
  const Vec3 left = normal.cross(tangent.normalized());
  const double side = left.dot(chord);
  if (std::abs(side) <= straight_share * chord.norm()) {
    straight(target);
    return;
  }
  ArcRequest request;
  request.target = target;
  request.axis = side > 0 ? normal : Vec3(-normal);
  request.center = start + chord.squaredNorm() / (2 * side) * left;
  request.column = words_.first_column("XYZ");
  by_center(request);
}

}  // namespace feedscope::sinumerik
