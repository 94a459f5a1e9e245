#include "core/program/path/curve_lines.h"

namespace feedscope {

namespace {

/// Halvings of the parameter's range. The first ones are made in any case, so that no bend is overlooked
/// where the curve crosses its chord at the places looked at.
constexpr int most_halvings = 16;
constexpr int least_halvings = 2;

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
  Divider(const std::function<Vec3(double)>& curve, const std::function<void(const Vec3&)>& line_to)
      : curve_(curve), line_to_(line_to) {}

  Place at(double parameter) const { return {parameter, curve_(parameter)}; }

  void divide(const Place& from, const Place& to, int halvings) const {
    const double half = (to.parameter - from.parameter) / 2;
    const Place middle = at(from.parameter + half);
    const bool close = halvings >= least_halvings && is_close(from, to, middle.point) &&
                       is_close(from, to, curve_(from.parameter + half / 2)) &&
                       is_close(from, to, curve_(to.parameter - half / 2));
    if (close || halvings >= most_halvings) {
      line_to_(to.point);
      return;
    }
    divide(from, middle, halvings + 1);
    divide(middle, to, halvings + 1);
  }

 private:
  static bool is_close(const Place& from, const Place& to, const Vec3& point) {
    return distance(point, from.point, to.point) <= curve_chord_error;
  }

  const std::function<Vec3(double)>& curve_;
  const std::function<void(const Vec3&)>& line_to_;
};

}  // namespace

void lines_of_curve(const std::function<Vec3(double)>& curve, double from, double to,
                    const std::function<void(const Vec3&)>& line_to) {
  const Divider divider(curve, line_to);
  divider.divide(divider.at(from), divider.at(to), 0);
}

}  // namespace feedscope
