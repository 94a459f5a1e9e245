#include "core/analysis/envelope/rotary_walk.h"

#include <algorithm>
#include <cmath>

namespace feedscope {

int RotaryLooks::first_after(double time) const {
  if (!waits_) {
    return motion_.first_after(time);
  }
  int i = 0;
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

RotarySample RotaryWalk::sample(double time) {
  return course_.at(motion().state(time - begin()));
}

void RotaryWalk::next() {
  walk_.next();
  motion_.reset();
}

bool RotaryWalk::follows_tip() const {
  const BlendedPath& path = course_.trajectory().path();
  const SegmentTurn* turn = path.programmed()->segment_turn(path.segment(walk_.part().element));
  return turn != nullptr && turn->at_tip;
}

std::array<double, 3> RotaryWalk::linear_velocity(double time) {
  const State state = motion().state(time - begin());
  return course_.linear_velocity(state, course_.at(state));
}

std::array<double, 3> largest_velocities(const std::shared_ptr<const RotaryCourse>& course) {
  std::array<double, 3> largest{};
  const RotaryWalk::Source source(course);
  for (RotaryWalk walk(source, 0); !walk.done(); walk.next()) {
    const RotaryLooks looks = walk.looks();
    for (int i = 0; i < looks.count(); ++i) {
      const RotarySample sample = walk.sample(looks.at(i));
      for (std::size_t axis = 0; axis < largest.size(); ++axis) {
        largest[axis] = std::max(largest[axis], std::abs(sample.velocity[axis]));
      }
    }
  }
  for (std::size_t axis = 0; axis < largest.size(); ++axis) {
    largest[axis] =
        course->has(rotary_names[axis]) ? largest[axis] : std::numeric_limits<double>::quiet_NaN();
  }
  return largest;
}

std::optional<std::array<double, 3>> largest_linear_velocities(
    const std::shared_ptr<const RotaryCourse>& course) {
  if (!course->knows_linear()) {
    return std::nullopt;
  }
  std::optional<std::array<double, 3>> largest;
  const RotaryWalk::Source source(course);
  for (RotaryWalk walk(source, 0); !walk.done(); walk.next()) {
    const RotaryLooks looks = walk.looks();
    for (int i = 0; i < looks.count() && walk.follows_tip(); ++i) {
      const std::array<double, 3> velocity = walk.linear_velocity(looks.at(i));
      largest = largest.value_or(std::array<double, 3>{});
      for (std::size_t axis = 0; axis < largest->size(); ++axis) {
        (*largest)[axis] = std::max((*largest)[axis], std::abs(velocity[axis]));
      }
    }
  }
  return largest;
}

}  // namespace feedscope
