#include "core/analysis/envelope/rotary_walk.h"

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

}  // namespace feedscope
