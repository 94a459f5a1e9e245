#include "core/analysis/envelope/part_looks.h"

#include <algorithm>
#include <cmath>

#include "core/base/units.h"

namespace feedscope {
namespace {

constexpr double arc_step = units::from_deg(5);
constexpr double samples_a_blend = 3;  // of a gentle blend
constexpr double samples_a_span = 4;   // of a smooth curve
constexpr double samples_a_filter_time = 8;
constexpr double sharpest = 0.2;        // cosine of half the turn
constexpr int max_inner_samples = 720;  // ten turns of a helix in one piece; further turns repeat

/// Proportional to the share of a blend in which it turns: |S'(1/2)| / |S'(0)| = (3/alpha - 1/2) cos.
double half_turn_cosine(const CubicBlend& blend) {
  return (blend.end - blend.start).norm() / (2 * (blend.corner - blend.start).norm());
}

}  // namespace

int inner_looks(const Trajectory& trajectory, const Part& part, const ElementCurve& curve, double duration) {
  const double advanced = advance({0, part.v, part.a, part.j}, duration).q;
  double steps = 0;
  if (part.law == Law::filtered) {
    steps = duration / part.duration * trajectory.filtered_spans(part, samples_a_filter_time);
  } else if (curve.is_arc()) {
    steps = advanced / curve.arc.length_per_radian() / arc_step;
  } else if (curve.kind == ElementKind::curve) {
    steps = advanced / curve.length * samples_a_span;
  } else if (curve.kind == ElementKind::blend) {
    const double share = part.law == Law::parameter ? advanced : advanced / curve.length;
    const double cosine = std::max(sharpest, half_turn_cosine(curve.blend));
    steps = share * samples_a_blend / (cosine * cosine);
  }
  return static_cast<int>(std::clamp(std::ceil(steps) - 1, 0.0, double{max_inner_samples}));
}

PartLooks::PartLooks(const Trajectory& trajectory, const Part& part, const ElementCurve& curve)
    : start_(part.time),
      duration_(part.duration),
      turn_(part.j == 0 ? 0 : -part.a / part.j),
      spaced_(inner_looks(trajectory, part, curve, part.duration) + 1) {
  if (!(turn_ > 0 && turn_ < duration_)) {
    turn_ = duration_ / 2;
  }
  before_turn_ = duration_ > 0 ? static_cast<int>(std::floor(turn_ / duration_ * spaced_)) + 1 : 1;
  count_ = spaced_ + 2;
}

double PartLooks::at(int i) const {
  if (i == before_turn_) {
    return start_ + turn_;
  }
  const int spaced = i < before_turn_ ? i : i - 1;
  return start_ + duration_ * spaced / spaced_;
}

int PartLooks::first_after(double time) const {
  int low = 0;
  int high = count_;
  while (low < high) {
    const int middle = (low + high) / 2;
    (at(middle) > time ? high : low) = at(middle) > time ? middle : middle + 1;
  }
  return low;
}

}  // namespace feedscope
