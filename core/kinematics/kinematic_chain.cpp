#include "core/kinematics/kinematic_chain.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/error.h"
#include "core/base/message.h"

namespace feedscope {
namespace {

template <class T>
using Vector = Eigen::Matrix<T, 3, 1>;

constexpr double parallel = 1e-9;  // sine of an angle below which directions are equal

template <class T>
Vector<T> constant(const Vec3& v) {
  return {T(v.x()), T(v.y()), T(v.z())};
}

/// Component of `v` along a constant direction.
template <class T>
T along(const Vec3& direction, const Vector<T>& v) {
  return direction.x() * v[0] + direction.y() * v[1] + direction.z() * v[2];
}

template <class T>
T dot(const Vector<T>& a, const Vector<T>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class T>
Vector<T> cross(const Vector<T>& a, const Vector<T>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

template <class T>
Vector<T> scaled(const T& factor, const Vector<T>& v) {
  return {factor * v[0], factor * v[1], factor * v[2]};
}

/// `v` rotated by `angle` about the unit vector `axis`.
template <class T>
Vector<T> turned(const Vector<T>& v, const Vec3& axis, const T& angle) {
  using std::cos;
  using std::sin;
  const T c = cos(angle);
  const T s = sin(angle);
  const T kept = (T(1) - c) * along<T>(axis, v);
  return {c * v[0] + s * (axis.y() * v[2] - axis.z() * v[1]) + axis.x() * kept,
          c * v[1] + s * (axis.z() * v[0] - axis.x() * v[2]) + axis.y() * kept,
          c * v[2] + s * (axis.x() * v[1] - axis.y() * v[0]) + axis.z() * kept};
}

/// Angle of the rotation about `axis` that takes `from` to `to`, both at the same height along it.
template <class T>
T angle_between(const Vector<T>& from, const Vector<T>& to, const Vector<T>& axis) {
  using std::atan2;
  const Vector<T> a = from - scaled(dot(axis, from), axis);
  const Vector<T> b = to - scaled(dot(axis, to), axis);
  return atan2(dot(axis, cross(a, b)), dot(a, b));
}

[[noreturn]] void refuse(const ChainAxis& axis, const Message& what) {
  throw InputError(message(NC_("core", "axis {} of the kinematic chain: {}"), axis.name, what));
}

double nearest_turn(double angle, double from) {
  constexpr double turn = 2 * std::numbers::pi;
  return angle + turn * std::round((from - angle) / turn);
}

}  // namespace

KinematicChain::KinematicChain(std::vector<ChainAxis> axes, const Vec3& gauge, const Vec3& tool_direction)
    : axes_(std::move(axes)), gauge_(gauge), tool_(tool_direction.normalized()) {
  bool tool_side = false;
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    ChainAxis& axis = axes_[i];
    if (!(axis.direction.norm() > 0) || !axis.direction.allFinite()) {
      refuse(axis, NC_("core", "its direction has no length; give three numbers, such as 0, 0, 1"));
    }
    axis.direction.normalize();
    if (!(axis.least < axis.most)) {
      refuse(axis, message(NC_("core", "its travel is empty, from {:g} to {:g}"), axis.least, axis.most));
    }
    if (axis.carries_part && tool_side) {
      refuse(axis, NC_("core",
                       "it carries the part, but follows one that carries the tool; list those that carry "
                       "the part first"));
    }
    tool_side = !axis.carries_part;
    (axis.rotary ? rotary_ : linear_).push_back(i);
  }
  if (linear_.size() != 3) {
    throw InputError(
        message(NC_("core", "a kinematic chain needs three linear axes and has {}"), linear_.size()));
  }
  Eigen::Matrix3d slides;
  for (int i = 0; i < 3; ++i) {
    slides.col(i) = axes_[linear_[static_cast<std::size_t>(i)]].direction;
  }
  if (std::abs(slides.determinant()) < parallel) {
    throw InputError(Message(NC_("core", "the three linear axes of a kinematic chain lie in one plane")));
  }
  if (rotary_.empty() || rotary_.size() > 2) {
    throw InputError(
        message(NC_("core", "a kinematic chain needs one or two rotary axes and has {}"), rotary_.size()));
  }
  if (rotary_.size() == 2 &&
      axes_[rotary_[0]].direction.cross(axes_[rotary_[1]].direction).norm() < parallel) {
    refuse(axes_[rotary_[1]],
           message(NC_("core", "it is parallel to {}: together they turn the tool in one plane only"),
                   axes_[rotary_[0]].name));
  }
  if (axes_[rotary_.back()].direction.cross(tool_).norm() < parallel) {
    refuse(axes_[rotary_.back()], NC_("core", "it lies along the tool, which it does not turn"));
  }
}

ToolPose KinematicChain::pose(std::span<const double> places, double tool_length) const {
  ToolPose pose{gauge_ - tool_length * tool_, tool_};
  for (std::size_t i = axes_.size(); i-- > 0;) {
    const ChainAxis& axis = axes_[i];
    const double q = sense(i) * places[i];
    if (axis.rotary) {
      pose.tip = axis.point + turned<double>(pose.tip - axis.point, axis.direction, q);
      pose.direction = turned<double>(pose.direction, axis.direction, q);
    } else {
      pose.tip += q * axis.direction;
    }
  }
  return pose;
}

/// The tip is affine in the linear axes: b + the sum of their directions, each rotated by the rotary axes
/// between it and the first linear axis; those between that one and the part are removed from the tip.
template <class T>
std::vector<T> KinematicChain::solve(const Eigen::Matrix<T, 3, 1>& tip, std::span<const T> angles,
                                     double tool_length) const {
  Vector<T> to = tip;
  std::size_t carrying = 0;
  for (; axes_[carrying].rotary; ++carrying) {
    const ChainAxis& axis = axes_[carrying];
    const Vector<T> point = constant<T>(axis.point);
    to = point + turned<T>(to - point, axis.direction, -sense(carrying) * angles[carrying]);
  }
  Vector<T> from = constant<T>(gauge_ - tool_length * tool_);
  std::array<Vector<T>, 3> slides;
  std::size_t found = 3;
  std::size_t turns = rotary_.size();
  bool constant_slides = true;
  for (std::size_t i = axes_.size(); i-- > carrying;) {
    const ChainAxis& axis = axes_[i];
    if (!axis.rotary) {
      slides[--found] = constant<T>(sense(i) * axis.direction);
      continue;
    }
    const T angle = sense(i) * angles[--turns];
    const Vector<T> point = constant<T>(axis.point);
    from = point + turned<T>(from - point, axis.direction, angle);
    for (std::size_t k = found; k < 3; ++k) {
      slides[k] = turned<T>(slides[k], axis.direction, angle);
      constant_slides = false;
    }
  }
  const Vector<T> way = to - from;
  std::vector<T> places(axes_.size());
  const auto slide = [&](std::size_t k) -> Vec3 {
    return sense(linear_[k % 3]) * axes_[linear_[k % 3]].direction;
  };
  if (constant_slides) {
    const double volume = slide(0).dot(slide(1).cross(slide(2)));
    for (std::size_t k = 0; k < 3; ++k) {
      places[linear_[k]] = along<T>(slide(k + 1).cross(slide(k + 2)) / volume, way);
    }
  } else {
    const T volume = dot<T>(slides[0], cross<T>(slides[1], slides[2]));
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector<T> across = cross<T>(slides[(k + 1) % 3], slides[(k + 2) % 3]);
      places[linear_[k]] = dot<T>(way, across) / volume;
    }
  }
  for (std::size_t k = 0; k < rotary_.size(); ++k) {
    places[rotary_[k]] = angles[k];
  }
  return places;
}

/// With u1, u2 the rotary directions, t the tool at zero and d the wanted direction: d = R(u1) z, z = R(u2)
/// t, where z has the height of t along u2 and that of d along u1. z = a u1 + b u2 + c u1 x u2; `side` is the
/// sign of c. Angles include their senses.
template <class T>
std::vector<T> KinematicChain::angles_of(const Eigen::Matrix<T, 3, 1>& direction, double side) const {
  using std::sqrt;
  const Vec3& first = axes_[rotary_[0]].direction;
  const Vec3& second = axes_[rotary_[1]].direction;
  const double along = first.dot(second);
  const double sine_squared = 1 - along * along;
  const T height = dot<T>(constant<T>(first), direction);
  const T depth = T(second.dot(tool_));
  const T a = (height - T(along) * depth) / T(sine_squared);
  const T b = (depth - T(along) * height) / T(sine_squared);
  const T rest = (T(1) - a * a - b * b - T(2 * along) * a * b) / T(sine_squared);
  constexpr double rounding = 1e-14;
  const auto number = [](const T& x) {
    if constexpr (std::is_same_v<T, double>) {
      return x;
    } else {
      return x.value();
    }
  };
  if (number(rest) < -rounding) {
    return {};
  }
  const T c = number(rest) <= rounding ? T(0) : T(T(side) * sqrt(rest));
  const Vector<T> z = scaled(a, constant<T>(first)) + scaled(b, constant<T>(second)) +
                      scaled(c, constant<T>(first.cross(second)));
  return {T(sense(rotary_[0])) * angle_between<T>(z, direction, constant<T>(first)),
          T(sense(rotary_[1])) * angle_between<T>(constant<T>(tool_), z, constant<T>(second))};
}

std::optional<double> KinematicChain::within_travel(std::size_t axis, double angle, double from) const {
  constexpr double turn = 2 * std::numbers::pi;
  constexpr double rounding = 1e-12;
  const double least = axes_[axis].least - rounding;
  const double most = axes_[axis].most + rounding;
  double place = nearest_turn(angle, std::clamp(from, least, most));
  if (place < least) {
    place += turn * std::ceil((least - place) / turn);
  } else if (place > most) {
    place -= turn * std::ceil((place - most) / turn);
  }
  return place >= least && place <= most
             ? std::optional(std::clamp(place, axes_[axis].least, axes_[axis].most))
             : std::nullopt;
}

std::vector<RotaryPlaces> KinematicChain::turn_to(const Vec3& direction, std::span<const double> from) const {
  constexpr double same = 1e-9;
  std::vector<RotaryPlaces> found;
  const auto add = [&](std::vector<double> angles, bool singular) {
    for (std::size_t k = 0; k < angles.size(); ++k) {
      const auto place = within_travel(rotary_[k], angles[k], from[k]);
      if (!place) {
        return;
      }
      angles[k] = *place;
    }
    const auto is_same = [&](const RotaryPlaces& other) {
      return std::ranges::equal(angles, other.angles,
                                [](double a, double b) { return std::abs(a - b) < same; });
    };
    if (std::ranges::none_of(found, is_same)) {
      found.push_back({std::move(angles), singular});
    }
  };
  const ChainAxis& first = axes_[rotary_[0]];
  if (rotary_.size() == 1) {
    if (std::abs(first.direction.dot(direction) - first.direction.dot(tool_)) < same) {
      add({sense(rotary_[0]) * angle_between<double>(tool_, direction, first.direction)}, false);
    }
    return found;
  }
  const bool singular = first.direction.cross(direction).norm() < parallel;
  for (const double side : {1.0, -1.0}) {
    std::vector<double> angles = angles_of<double>(direction, side);
    if (angles.empty()) {
      break;
    }
    if (singular) {
      angles[0] = from[0];
    }
    add(std::move(angles), singular);
  }
  const auto way = [&](const RotaryPlaces& places) {
    double sum = 0;
    for (std::size_t k = 0; k < places.angles.size(); ++k) {
      sum = std::hypot(sum, places.angles[k] - from[k]);
    }
    return sum;
  };
  std::ranges::stable_sort(found, std::less(), way);
  return found;
}

std::vector<double> KinematicChain::places(const Vec3& tip, std::span<const double> angles,
                                           double tool_length) const {
  return solve<double>(tip, angles, tool_length);
}

std::vector<Series> KinematicChain::courses(const std::array<Series, 3>& tip, std::span<const Series> angles,
                                            double tool_length) const {
  return solve<Series>({tip[0], tip[1], tip[2]}, angles, tool_length);
}

std::optional<std::vector<Series>> KinematicChain::turning(const std::array<Series, 3>& direction,
                                                           std::span<const double> at) const {
  const Vec3 now(direction[0].value(), direction[1].value(), direction[2].value());
  const Vector<Series> course(direction[0], direction[1], direction[2]);
  if (rotary_.size() == 1) {
    const ChainAxis& axis = axes_[rotary_[0]];
    const Series angle = Series(sense(rotary_[0])) * angle_between<Series>(constant<Series>(tool_), course,
                                                                           constant<Series>(axis.direction));
    return std::vector{angle + Series(nearest_turn(angle.value(), at[0]) - angle.value())};
  }
  if (axes_[rotary_[0]].direction.cross(now).norm() < parallel) {
    return std::nullopt;
  }
  const ChainAxis& second = axes_[rotary_[1]];
  const double side_of_at = turned<double>(tool_, second.direction, sense(rotary_[1]) * at[1])
                                .dot(axes_[rotary_[0]].direction.cross(second.direction));
  std::optional<std::vector<Series>> best;
  double least = std::numeric_limits<double>::infinity();
  for (const double side : {1.0, -1.0}) {
    if (std::abs(side_of_at) > parallel && side * side_of_at < 0) {
      continue;
    }
    std::vector<Series> angles = angles_of<Series>(course, side);
    double off = 0;
    for (std::size_t k = 0; k < angles.size(); ++k) {
      angles[k] += Series(nearest_turn(angles[k].value(), at[k]) - angles[k].value());
      off = std::max(off, std::abs(angles[k].value() - at[k]));
    }
    if (!angles.empty() && off < least) {
      least = off;
      best = std::move(angles);
    }
  }
  return best;
}

std::optional<std::size_t> KinematicChain::beyond_travel(std::span<const double> places) const {
  constexpr double rounding = 1e-9;
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    if (places[i] < axes_[i].least - rounding || places[i] > axes_[i].most + rounding) {
      return i;
    }
  }
  return std::nullopt;
}

}  // namespace feedscope
