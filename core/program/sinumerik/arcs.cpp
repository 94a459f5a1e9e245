// The part of SinumerikReader that turns arc words into arcs.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "core/program/sinumerik/sinumerik_reader.h"

namespace feedscope {

using namespace sinumerik;

namespace {

constexpr std::string_view straight_instead = "a straight line to the end is taken instead";
constexpr std::array<char, 3> center_letters{'I', 'J', 'K'};

}  // namespace

Vec3 SinumerikReader::center_of_block() const {
  Vec3 center = path().position();
  for (int axis = 0; axis < 3; ++axis) {
    const char letter = center_letters[static_cast<std::size_t>(axis)];
    if (words_.has(letter)) {
      const double value = to_mm(words_[letter].value);
      center[axis] = words_[letter].reading == Reading::absolute ? value : center[axis] + value;
    }
  }
  return center;
}

void SinumerikReader::arc(const Vec3& target) {
  const Vec3 normal = normal_of(modal_.plane);
  ArcRequest request;
  request.target = target;
  request.axis = modal_.motion->action == Action::arc_ccw ? normal : Vec3(-normal);
  if (words_.has(Address::turn)) {
    constexpr double most_turns = 999;
    const BlockWords::Value& turns = words_[Address::turn];
    if (turns.value >= 0 && turns.value <= most_turns && turns.value == std::floor(turns.value)) {
      request.extra_turns = turns.value;
    } else {
      report(Severity::error, "arc-turns", 0, turns.column, [&] {
        return Text{fmt::format("TURN={} is not a number of turns from 0 to {}", turns.value, most_turns),
                    "no turn more is taken"};
      });
    }
  }
  last_by_radius_ = false;
  if (words_.has(Address::ar)) {
    angle_arc(target, request);
  } else {
    plain_arc(target, request);
  }
}

/// By a radius, a centre, or the pole.
void SinumerikReader::plain_arc(const Vec3& target, ArcRequest& request) {
  const bool polar = words_.has(Address::ap) || words_.has(Address::rp);
  if (words_.has(Address::cr)) {
    if (words_.has_any("IJK")) {
      report(Severity::error, "arc-center", 1, words_.first_column("IJK"), [] {
        return Text{"the arc has both a centre (I, J, K) and a radius (CR)", "CR counts; remove one of them"};
      });
    }
    request.radius = to_mm(words_[Address::cr].value);
    request.column = words_[Address::cr].column;
    last_by_radius_ = true;
    last_arc_ = request;
    path().arc_by_radius(request);
    return;
  }
  if (!words_.has_any("IJK") && !polar) {
    report(Severity::error, "arc-center", 0, words_.first_column("XYZ"), [] {
      return Text{"the arc has neither a centre (I, J, K) nor a radius (CR)", std::string(straight_instead)};
    });
    straight(target, false);
    return;
  }
  request.center = polar && !words_.has_any("IJK") ? modal_.pole : center_of_block();
  request.column = words_.first_column("IJK");
  last_arc_ = request;
  path().arc_by_center(request);
}

/// By its opening angle, with a centre or with an end.
void SinumerikReader::angle_arc(const Vec3& target, ArcRequest& request) {
  const BlockWords::Value& word = words_[Address::ar];
  request.column = word.column;
  const double angle = units::from_deg(word.value);
  if (!(word.value > 0 && word.value < 360)) {
    report(Severity::error, "arc-angle", 0, word.column, [&] {
      return Text{fmt::format("opening angle AR={} is not between 0 and 360", word.value),
                  std::string(straight_instead)};
    });
    straight(target, false);
    return;
  }
  const Vec3 start = path().position();
  if (words_.has_any("IJK")) {
    request.center = center_of_block();
    const Vec3 from = start - request.center;
    const Vec3 in_plane = from - request.axis.dot(from) * request.axis;
    const Vec3 turned = std::cos(angle) * in_plane + std::sin(angle) * request.axis.cross(in_plane);
    const double rise = request.axis.dot(target - start);
    request.target = start - in_plane + turned + rise * request.axis;
    last_arc_ = request;
    path().arc_by_center(request);
    return;
  }
  const Vec3 to_end = target - start;
  const double chord = (to_end - request.axis.dot(to_end) * request.axis).norm();
  const double radius = chord / (2 * std::sin(angle / 2));
  request.radius = word.value > 180 ? -radius : radius;
  last_by_radius_ = true;
  last_arc_ = request;
  path().arc_by_radius(request);
}

/// CIP: through the point I1, J1, K1, in any plane.
void SinumerikReader::arc_through(const Vec3& target) {
  const Vec3 start = path().position();
  Vec3 middle = start;
  std::uint32_t column = words_.first_column("XYZ");
  constexpr std::array<Address, 3> words{Address::i1, Address::j1, Address::k1};
  for (std::size_t axis = 0; axis < words.size(); ++axis) {
    if (!words_.has(words[axis])) {
      continue;
    }
    const BlockWords::Value& word = words_[words[axis]];
    const bool incremental =
        word.reading == Reading::incremental || (word.reading == Reading::modal && modal_.incremental);
    const double value = to_mm(word.value);
    double& coordinate = middle[static_cast<int>(axis)];
    coordinate = incremental ? coordinate + value : value;
    column = word.column;
  }
  const Vec3 a = middle - start;
  const Vec3 b = target - start;
  const Vec3 normal = a.cross(b);
  constexpr double straight_share = 1e-9;
  if (normal.norm() <= straight_share * std::max(a.squaredNorm(), b.squaredNorm())) {
    report(Severity::error, "arc-middle", 0, column, [] {
      return Text{"start, intermediate point (I1, J1, K1) and end of CIP lie on one line",
                  std::string(straight_instead)};
    });
    straight(target, false);
    return;
  }
  ArcRequest request;
  request.target = target;
  request.axis = normal.normalized();
  // Centre of the circle through three points, seen from the first.
  request.center = start + (b.squaredNorm() * normal.cross(a) - a.squaredNorm() * normal.cross(b)) /
                               (2 * normal.squaredNorm());
  request.column = column;
  last_by_radius_ = false;
  last_arc_ = request;
  path().arc_by_center(request);
}

/// CT: leaves the motion before along its end's direction, in the plane.
void SinumerikReader::tangent_arc(const Vec3& target) {
  const Vec3 normal = normal_of(modal_.plane);
  const auto level = [&normal](const Vec3& v) -> Vec3 { return v - normal.dot(v) * normal; };
  const Vec3 start = path().position();
  const Vec3 tangent = level(last_direction());
  const Vec3 chord = level(target - start);
  if (tangent.norm() <= same_point) {
    report(Severity::error, "arc-tangent", 0, words_.first_column("XYZ"), [] {
      return Text{"CT without a motion in its plane before it", std::string(straight_instead)};
    });
    straight(target, false);
    return;
  }
  const Vec3 left = normal.cross(tangent.normalized());
  const double side = left.dot(chord);
  constexpr double straight_share = 1e-9;
  if (std::abs(side) <= straight_share * chord.norm()) {
    straight(target, false);
    return;
  }
  ArcRequest request;
  request.target = target;
  request.axis = side > 0 ? normal : Vec3(-normal);
  request.center = start + chord.squaredNorm() / (2 * side) * left;
  request.column = words_.first_column("XYZ");
  last_by_radius_ = false;
  last_arc_ = request;
  path().arc_by_center(request);
}

/// Of the end of the last motion, a unit vector in programmed coordinates; zero if there is none.
Vec3 SinumerikReader::last_direction() const {
  const Vec3 end = path().position();
  if (!last_arc_) {
    const Vec3 along = end - start_;
    return path().has_moved() && along.norm() > same_point ? Vec3(along.normalized()) : Vec3(Vec3::Zero());
  }
  const ArcRequest& arc = *last_arc_;
  const ArcSolution solution =
      last_by_radius_ ? solve_radius_arc(start_, arc.target, arc.radius, arc.axis, arc.extra_turns)
                      : solve_center_arc(start_, arc.target, arc.center, arc.axis, arc.extra_turns);
  if (solution.fault != ArcFault::none) {
    return (end - start_).norm() > same_point ? Vec3((end - start_).normalized()) : Vec3(Vec3::Zero());
  }
  const ArcWords& last = solution.pieces[static_cast<std::size_t>(solution.count - 1)].words;
  return last.axis.cross(end - last.center).normalized();
}

}  // namespace feedscope
