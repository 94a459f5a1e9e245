#include "core/analysis/envelope/drive_walk.h"

namespace feedscope {

DriveWalk::DriveWalk(const Source& source, double time)
    : rigid_(source.path().response().is_rigid()),
      walk_(source.path().response(), time),
      errors_(source.path()),
      set_(source.path().trajectory(), time) {
  while (!walk_.done() && walk_.span().end() <= time &&
         walk_.span().end() < source.path().trajectory().duration()) {
    walk_.next_span();
  }
}

void DriveWalk::add(Band& band, double time) {
  if (time == seen_) {
    band.add(last_);
    return;
  }
  const State state = set_.at_without_length(time);
  const ActualMotion motion = walk_.within_span(time);
  const ActualSample sample{motion, errors_.at(motion.position, state.element)};
  last_ = {};
  last_.add(Instant(state, &sample));
  seen_ = time;
  band.add(last_);
}

void DriveWalk::next() {
  walk_.next_span();
  if (!walk_.done() && walk_.span().begins) {
    seen_ = -1;
  }
}

}  // namespace feedscope
