#include "core/analysis/contour/corner_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/trajectory/filtered_corner.h"

namespace feedscope {
namespace {

/// Distance between a point and the places on one element.
class ElementDistance {
 public:
  ElementDistance(const ElementCurve& curve, const Vec3& point) : curve_(curve), point_(point) {}

  double least() {
    if (!curve_.course.empty()) {
      for (const CourseKnot& knot : curve_.course) {
        look(knot.s - curve_.course.front().s);
      }
    } else {
      for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        look(share * end());
      }
    }
    approach();
    return std::sqrt(squared_);
  }

 private:
  /// Blends are traversed by their parameter, which needs no quadrature.
  double end() const { return curve_.kind == ElementKind::blend ? 1 : curve_.length; }

  CurvePoint look(double place) {
    const CurvePoint at = curve_.kind == ElementKind::blend ? curve_.blend.at(place) : curve_.at(place);
    const double squared = (at.position - point_).squaredNorm();
    if (squared < squared_) {
      squared_ = squared;
      place_ = place;
    }
    return at;
  }

  /// Newton steps from the nearest sampled place.
  void approach() {
    constexpr int most_steps = 8;
    constexpr double precision = 1e-9;  // of the squared distance: smallest gain worth another step
    for (int i = 0; i < most_steps; ++i) {
      const double from = place_;
      const CurvePoint at = look(from);
      const Vec3 offset = at.position - point_;
      const double slope = offset.dot(at.d1);
      const double bend = at.d1.squaredNorm() + offset.dot(at.d2);
      if (!(bend > 0) || slope * slope <= precision * bend * squared_) {
        return;
      }
      look(std::clamp(from - slope / bend, 0.0, end()));
      if (place_ == from) {
        return;
      }
    }
  }

  const ElementCurve& curve_;
  const Vec3& point_;
  double squared_ = std::numeric_limits<double>::infinity();
  double place_ = 0;
};

double distance_of(const BlendedPath& path, std::size_t element, const Vec3& point) {
  const ElementCurve curve = path.curve(element);
  if (curve.kind == ElementKind::line || curve.kind == ElementKind::dwell) {
    return (curve.at((point - curve.start).dot(curve.direction)).position - point).norm();
  }
  return ElementDistance(curve, point).least();
}

/// Part of the path searched for the point nearest to a corner.
struct Search {
  double reach = 0;        ///< from the expected place, plus twice the distance [mm]
  std::size_t blocks = 0;  ///< smallest number of blocks after that place
  double enough = 0;       ///< a distance up to this ends the search [mm]
};

/// Distance of `point` from the path on both sides of the start of `element`.
double distance_about(const BlendedPath& path, std::size_t element, const Vec3& point, const Search& search) {
  double least = std::numeric_limits<double>::infinity();
  double gone = 0;
  std::size_t blocks = 0;
  for (std::size_t e = element; e < path.size() && least > search.enough; ++e) {
    blocks += e == element || path.segment(e) != path.segment(e - 1) ? 1 : 0;
    if (blocks > search.blocks && gone > search.reach + 2 * least) {
      break;
    }
    least = std::min(least, distance_of(path, e, point));
    gone += path.length(e);
  }
  gone = 0;
  for (std::size_t e = element; e > 0 && least > search.enough && gone <= search.reach + 2 * least; --e) {
    least = std::min(least, distance_of(path, e - 1, point));
    gone += path.length(e - 1);
  }
  return least;
}

/// The corner is near the junction of its blocks' elements. A control that joins blocks may pass it anywhere
/// on them, or in a corner that it assigns to the next.
double largest_of_path(const BlendedPath& path, const Progress* progress) {
  constexpr std::size_t blocks_of_joined = 2;
  const std::vector<Segment>& segments = path.programmed()->segments;
  double largest = 0;
  std::size_t element = 0;
  for (std::size_t i = 0; i + 1 < segments.size(); ++i) {
    stop_if_cancelled(progress);
    while (element < path.size() && path.segment(element) <= i) {
      ++element;
    }
    const bool meet = element > 0 && element < path.size() && path.segment(element - 1) == i &&
                      path.segment(element) == i + 1;
    const Search search =
        meet ? Search{0, 0, largest}
             : Search{segments[i].length + segments[i + 1].length, blocks_of_joined, largest};
    largest = std::max(largest, distance_about(path, element, segments[i].end, search));
  }
  return largest;
}

double largest_of_motion(const PulseTrain& train, FilterWalk& filters, const Progress* progress) {
  double largest = 0;
  for (std::size_t block = 1; block < train.size(); ++block) {
    stop_if_cancelled(progress);
    const double middle = train.blocks[block].start + train.half_delay();
    const Approach nearest = closest_approach(filters, train, train.programmed_point(block), middle);
    largest = std::max(largest, nearest.distance);
  }
  return largest;
}

}  // namespace

double largest_corner_distance(const Trajectory& trajectory, const Progress* progress) {
  if (trajectory.path().empty()) {
    return 0;
  }
  if (trajectory.motions().empty()) {
    return largest_of_path(trajectory.path(), progress);
  }
  double largest = 0;
  FilterWalk filters;
  for (const FilteredMotion& motion : trajectory.motions()) {
    largest = std::max(largest, largest_of_motion(motion.train(), filters, progress));
  }
  return largest;
}

}  // namespace feedscope
