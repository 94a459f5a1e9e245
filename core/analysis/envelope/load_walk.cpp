#include "core/analysis/envelope/load_walk.h"

namespace feedscope {

LoadWalk::LoadWalk(const Source& source, double time)
    : trajectory_(source.load().trajectory()),
      walk_(trajectory_, trajectory_.pieces().empty() ? 0 : trajectory_.piece_at(time)),
      sampler_(source.load()) {
  while (!walk_.done() && end() <= time && end() < trajectory_.duration()) {
    walk_.next();
  }
}

const PartMotion& LoadWalk::motion() {
  if (!motion_) {
    motion_.emplace(walk_.motion());
  }
  return *motion_;
}

void LoadWalk::add(Band& band, double time) {
  const State state = motion().state_without_length(time - begin());
  const LoadSample sample = sampler_.at(state);
  if (sample.has_load()) {
    band.add(Instant(state, nullptr, &sample));
  }
}

void LoadWalk::next() {
  walk_.next();
  motion_.reset();
}

}  // namespace feedscope
