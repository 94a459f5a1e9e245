#include "core/analysis/envelope/drive_walk.h"

namespace feedscope {

DriveWalk::DriveWalk(const Source& source, double time)
    : walk_(source.path().response(), time), errors_(source.path()), set_(source.path().trajectory(), time) {
  while (!walk_.done() && walk_.span().end() <= time &&
         walk_.span().end() < source.path().trajectory().duration()) {
    walk_.next_span();
  }
}

void DriveWalk::add(Band& band, double time) {
  const State state = set_.at(time);
  const ActualMotion motion = walk_.within_span(time);
  const ActualSample sample{motion, errors_.at(motion.position, state.element)};
  band.add(Instant(state, &sample));
}

}  // namespace feedscope
