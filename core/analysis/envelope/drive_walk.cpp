#include "core/analysis/envelope/drive_walk.h"

#include <algorithm>
#include <cmath>

namespace feedscope {
namespace {

constexpr double longest_step = 0.002;  // [s]
constexpr double least_looks = 2;
constexpr double most_looks = 64;

}  // namespace

DriveWalk::DriveWalk(const Source& source, double time)
    : walk_(source.path().response(), time), errors_(source.path()), set_(source.path().trajectory(), time) {
  while (!walk_.done() && walk_.span().end() <= time &&
         walk_.span().end() < source.path().trajectory().duration()) {
    walk_.next_span();
  }
}

int looks_in(const SetSpan& span) {
  return static_cast<int>(std::clamp(std::ceil(span.duration / longest_step), least_looks, most_looks));
}

void DriveWalk::add(Band& band, double time) {
  const State state = set_.at(time);
  const ActualMotion motion = walk_.within_span(time);
  const ActualSample sample{motion, errors_.at(motion.position, state.element)};
  band.add(Instant(state, &sample));
}

}  // namespace feedscope
