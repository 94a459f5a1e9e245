#include "core/analysis/envelope/rotary_walk.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/roots.h"
#include "core/base/units.h"
#include "core/toolpath/turn_course.h"

namespace feedscope {

namespace {

constexpr double turn_between_looks = units::from_deg(5);

/// Rotation of all axes together [rad].
double turned_between(const std::array<double, 3>& from, const std::array<double, 3>& to) {
  double sum = 0;
  for (std::size_t i = 0; i < to.size(); ++i) {
    sum += std::isnan(to[i]) ? 0 : std::abs(to[i] - from[i]);  // NaN: no such axis
  }
  return sum;
}

}  // namespace

RotaryLooks::RotaryLooks(const Trajectory& trajectory, const Part& part, const ElementCurve& curve,
                         double turned)
    : motion_(trajectory, part, curve),
      start_(part.time),
      duration_(part.duration),
      waits_(is_pause(part.cause.kind)) {
  constexpr double least_at_rest = 24;
  const double steps = turned / turn_between_looks;
  between_ = static_cast<int>(
      std::ceil(waits_ ? std::max(steps, least_at_rest) : std::max(steps / (motion_.count() - 1), 1.0)));
}

double RotaryLooks::at(int i) const {
  const double from = motion_at(i / between_);
  const int steps = i % between_;
  return steps == 0 ? from : from + (motion_at(i / between_ + 1) - from) * steps / between_;
}

int RotaryLooks::first_after(double time) const {
  if (!waits_ && between_ == 1) {
    return motion_.first_after(time);
  }
  int i = waits_ ? 0 : std::max(motion_.first_after(time) - 1, 0) * between_;
  while (i < count() && at(i) <= time) {
    ++i;
  }
  return i;
}

RotaryWalk::RotaryWalk(const Source& source, double time)
    : course_(source.course()),
      walk_(course_.trajectory(),
            course_.trajectory().pieces().empty() ? 0 : course_.trajectory().piece_at(time)) {
  while (!walk_.done() && end() <= time && end() < course_.trajectory().duration()) {
    walk_.next();
  }
}

const PartMotion& RotaryWalk::motion() {
  if (!motion_) {
    motion_.emplace(walk_.motion());
  }
  return *motion_;
}

void RotaryWalk::add(Band& band, double time) {
  const State state = motion().state(time - begin());
  const RotarySample sample = course_.at(state);
  band.add(Instant(state, nullptr, nullptr, &sample));
}

/// 0 if the whole segment turns less than the usual step between two samples.
double RotaryWalk::turned() {
  const Toolpath& programmed = *course_.trajectory().path().programmed();
  const std::uint32_t segment = course_.trajectory().path().segment(walk_.part().element);
  if (is_pause(walk_.part().cause.kind)) {
    const auto turn = std::ranges::lower_bound(programmed.rotary_turns, segment, {}, &RotaryTurn::segment);
    return turn != programmed.rotary_turns.end() && turn->segment == segment
               ? turned_between(turn->from, turn->to)
               : 0;
  }
  const SegmentTurn* turn = programmed.segment_turn(segment);
  if (turn == nullptr || turned_between(turn->from, turn->to) < turn_between_looks) {
    return 0;
  }
  return turned_between(sample(begin()).angles(), sample(end()).angles());
}

RotarySample RotaryWalk::sample(double time) {
  return course_.at(motion().state(time - begin()));
}

std::vector<double> RotaryWalk::turning_places() {
  constexpr int halvings = 50;
  constexpr std::array within_reach{0.25, 0.5, 0.75};
  constexpr std::array beside_pole{-0.03, -0.01, -0.003, 0.0, 0.003, 0.01, 0.03};  // of the line
  std::vector<double> times;
  const BlendedPath& path = course_.trajectory().path();
  const std::uint32_t segment = path.segment(walk_.part().element);
  const Toolpath& programmed = *path.programmed();
  if (programmed.segment_turns.empty() || path.kind(walk_.part().element) != ElementKind::line) {
    return times;
  }
  const double length = programmed.segments[segment].length;
  const Vec3& start = programmed.start_of(segment);
  const Vec3 direction = (programmed.segments[segment].end - start) / length;
  const auto add = [&](double at, bool from_there_on = false) {
    const auto before = [&](double tau) {
      return (motion().kinematics(tau).position - start).dot(direction) <= at;
    };
    const double duration = walk_.part().duration;
    if (at > 0 && at < length && before(0) && !before(duration)) {
      const Bracket passed = halve({0, duration}, halvings, before);
      times.push_back(begin() + (from_there_on ? passed.high : passed.low));
    }
  };
  if (const TurnJoint* joint = segment > 0 ? course_.joint_behind(segment - std::size_t{1}) : nullptr) {
    add(joint->behind);
    for (const double share : within_reach) {
      add(share * joint->behind);
    }
  }
  if (const TurnJoint* joint = course_.joint_behind(segment)) {
    add(length - joint->before, true);
    for (const double share : within_reach) {
      add(length - share * joint->before);
    }
  }
  const SegmentTurn* turn = programmed.segment_turn(segment);
  if (turn != nullptr && turn->great_circle) {
    if (const std::optional<double> pole = TurnCourse(course_.chain(), *turn, length).nearest_to_pole()) {
      for (const double share : beside_pole) {
        add(*pole + share * length);
      }
    }
  }
  return times;
}

void RotaryWalk::next() {
  walk_.next();
  motion_.reset();
}

}  // namespace feedscope
