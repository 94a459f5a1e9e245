#include "core/trajectory/filtered_motion.h"

#include <cassert>
#include <cmath>

namespace feedscope {

FilteredMotion::FilteredMotion(double start, PulseTrain train, double contour_error)
    : start_(start), train_(std::move(train)), contour_error_(contour_error) {
  assert(train_.filters == 2 || train_.filters == 3);
  assert(train_.filter_time > 0 && train_.blocks.size() >= 2);
}

Kinematics FilteredMotion::at(double t) const {
  return FilterWalk().at(train_, t);
}

bool FilteredMotion::is_settled(double t0, double t1) const {
  const double oldest = t0 - delay();
  if (oldest < 0) {
    return false;
  }
  const std::size_t block = train_.block_at(oldest);
  if (block == train_.size() || train_.segment(block).kind == SegmentKind::arc) {
    return block == train_.size();
  }
  const PulseWidths widths = train_.widths(block);
  const double start = train_.blocks[block].start;
  if (oldest < start + widths.left) {
    return t1 <= start + widths.left;
  }
  const double right = train_.blocks[block + 1].start - widths.right;
  return t1 <= (oldest < right ? right : right + widths.right);
}

}  // namespace feedscope
