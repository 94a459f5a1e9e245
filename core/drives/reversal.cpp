#include "core/drives/reversal.h"

#include <algorithm>
#include <cmath>

#include "core/base/roots.h"

namespace feedscope {
namespace {

/// Sampling of the motor: in steps of half the drive's fastest time while it settles, then in several parts
/// of the set course, within each of which it reverses at most once.
constexpr double step_in_rates = 0.5;
constexpr int settling_steps = 40;
constexpr double parts_of_course = 8;

}  // namespace

Reversal::Reversal(const AxisDrive& drive)
    : play_(drive.backlash.value_or(0) * (1 - drive.backlash_compensation.value_or(0))),
      spike_(drive.friction_spike.value_or(0)),
      decay_(drive.friction_time.value_or(0)) {}

void Reversal::move(double distance, double time) {
  slack_ = std::clamp(slack_ - distance, -play_ / 2, play_ / 2);
  if (spike_ == 0) {
    return;
  }
  pull_ *= std::exp(-time / decay_);
  if (direction_ == 0) {
    direction_ = distance > 0 ? 1 : distance < 0 ? -1 : 0;
    return;
  }
  // Measured against the direction: 0 while the motor runs in it.
  turned_ = std::min(0.0, turned_ + distance * direction_);
  if (turned_ <= -least_reversal) {
    direction_ = -direction_;
    turned_ = 0;
    pull_ -= direction_ * spike_;
  }
}

/// Follows the motor from `from` to `to` in one direction.
void Reversal::follow_straight(const DriveCourse& course, double from, double to) {
  const double start = course.at(from).offset;
  const double end = course.at(to).offset;
  const double to_reversal = direction_ * (least_reversal + turned_);
  const bool reverses =
      spike_ > 0 && direction_ * (end - start) < 0 && std::abs(end - start) > std::abs(to_reversal);
  if (!reverses) {
    move(end - start, to - from);
    return;
  }
  // Time of detection; the spike decays from there.
  constexpr int halvings = 40;
  const Bracket noticed = halve({from, to}, halvings, [&](double t) {
    return std::abs(course.at(t).offset - start) < std::abs(to_reversal);
  });
  move(-to_reversal, noticed.high - from);
  move(end - start + to_reversal, to - noticed.high);
}

void Reversal::follow(const DriveCourse& course, const DriveLaw& law, double from, double to) {
  double h = from;
  MotorMotion at = course.at(h);
  int settled = 0;
  while (h < to) {
    const double step = law.follows_exactly() || settled++ > settling_steps
                            ? (to - from) / parts_of_course
                            : step_in_rates / law.fastest_rate();
    const double next = std::min(to, h + std::max(step, 1e-9 * (to - from)));
    const MotorMotion then = course.at(next);
    if (at.velocity * then.velocity < 0) {
      constexpr int halvings = 40;
      const double sign = then.velocity > 0 ? 1 : -1;
      const double turn =
          halve({h, next}, halvings, [&](double t) { return course.at(t).velocity * sign < 0; }).middle();
      follow_straight(course, h, turn);
      follow_straight(course, turn, next);
    } else {
      follow_straight(course, h, next);
    }
    h = next;
    at = then;
  }
}

}  // namespace feedscope
