#include "core/program/path/curve_lines.h"

#include <algorithm>
#include <utility>

namespace feedscope {

namespace {

/// Halvings of the parameter's range. The first ones are always made, so that no bend is missed where the
/// curve crosses its chord at the checked places.
constexpr int min_halvings = 2;

struct Place {
  double parameter = 0;
  Vec3 point;
};

double distance(const Vec3& point, const Vec3& from, const Vec3& to) {
  const Vec3 chord = to - from;
  const double length = chord.squaredNorm();
  const double share = length > 0 ? std::clamp(chord.dot(point - from) / length, 0.0, 1.0) : 0;
  return (point - from - share * chord).norm();
}

class Divider {
 public:
  explicit Divider(const ParametricCurve& curve) : curve_(curve) {}

  Place at(double parameter) const { return {parameter, curve_(parameter).point}; }

  void divide(const Place& from, const Place& to, int halvings) {
    const double half = (to.parameter - from.parameter) / 2;
    const Place middle = at(from.parameter + half);
    const bool close = halvings >= min_halvings && is_close(from, to, middle.point) &&
                       is_close(from, to, curve_(from.parameter + half / 2).point) &&
                       is_close(from, to, curve_(to.parameter - half / 2).point);
    if (close || halvings >= max_curve_halvings) {
      ends.push_back(to.point);
      return;
    }
    divide(from, middle, halvings + 1);
    divide(middle, to, halvings + 1);
  }

  std::vector<Vec3> ends;

 private:
  static bool is_close(const Place& from, const Place& to, const Vec3& point) {
    return distance(point, from.point, to.point) <= curve_tolerance;
  }

  const ParametricCurve& curve_;
};

}  // namespace

std::vector<Vec3> lines_of_curve(const ParametricCurve& curve, double from, double to) {
  Divider divider(curve);
  divider.divide(divider.at(from), divider.at(to), 0);
  return std::move(divider.ends);
}

}  // namespace feedscope
