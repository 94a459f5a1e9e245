#include "core/compressor/smoothed_points.h"

#include <algorithm>

namespace feedscope {
namespace {

/// Smallest share of their programmed distance that points on the curve keep.
constexpr double least_share = 0.1;

/// Walks along a curve from point to point.
class NearestPlaces {
 public:
  explicit NearestPlaces(const SmoothCurve& curve)
      : curve_(curve), here_(curve.knots[0], curve.knots[1]), position_(curve.knots[0].position) {}

  /// Place of the curve nearest to `point`, the end of `segment`, at least `ahead` [mm] after the previous
  /// place.
  Vec3 next(std::uint32_t segment, const Vec3& point, double ahead) {
    const std::size_t spans = curve_.blocks.size();
    const double least = s_ + ahead;
    while (span_ + 1 < spans && (curve_.blocks[span_ + 1] <= segment || curve_.knots[span_ + 1].s <= least)) {
      go_to(span_ + 1);
    }
    const double begin = curve_.knots[span_].s;
    double along = std::clamp(s_ + (point - position_).norm() - begin, 0.0, here_.length());
    here_.distance(point, along);
    s_ = begin + std::clamp(std::max(along, least - begin), 0.0, here_.length());
    position_ = here_.at(s_ - begin).position;
    return position_;
  }
  double left() const { return curve_.knots.back().s - s_; }  ///< length of the curve after the place [mm]

 private:
  void go_to(std::size_t span) {
    span_ = span;
    here_ = CourseSpan(curve_.knots[span], curve_.knots[span + 1]);
  }

  const SmoothCurve& curve_;
  std::size_t span_ = 0;
  CourseSpan here_;
  double s_ = 0;  ///< of the last place [mm]
  Vec3 position_;
};

}  // namespace

bool move_points(const SmoothCurve& curve, Toolpath& commanded) {
  const SmoothingRun& run = curve.run;
  std::vector<Vec3> moved;
  moved.reserve(run.last - run.first);
  NearestPlaces places(curve);
  for (std::size_t i = run.first; i < run.last; ++i) {
    const Segment& line = commanded.segments[i];
    const Vec3 place = places.next(static_cast<std::uint32_t>(i), line.end, least_share * line.length);
    if ((place - line.end).norm() > curve.tolerance) {
      return false;
    }
    moved.push_back(place);
  }
  if (places.left() < least_share * run.end) {
    return false;
  }
  for (std::size_t i = run.first; i < run.last; ++i) {
    commanded.segments[i].end = moved[i - run.first];
  }
  for (std::size_t i = run.first; i <= run.last; ++i) {
    Segment& line = commanded.segments[i];
    line.length = (line.end - commanded.start_of(i)).norm();
  }
  return true;
}

}  // namespace feedscope
