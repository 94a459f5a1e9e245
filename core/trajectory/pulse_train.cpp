#include "core/trajectory/pulse_train.h"

#include <algorithm>
#include <cmath>

namespace feedscope {
namespace {

CommandPart rest_at(const Vec3& position, double time) {
  CommandPart part;
  part.time = time;
  part.position = position;
  part.velocity = Vec3::Zero();
  return part;
}

/// Line or arc of one block, commanded at any speed from any place on it.
class BlockCourse {
 public:
  BlockCourse(const PulseTrain& train, std::size_t block)
      : start_(train.point(block)), length_(train.segment(block).length) {
    const Segment& segment = train.segment(block);
    if (segment.kind == SegmentKind::arc) {
      arc_ = &train.arc(block);
      // The ends are exactly the programmed points, whatever the rounding of the arc's frame.
      const double a = arc_->sweep;
      const Vec3 turned = arc_->radius * ((std::cos(a) - 1) * arc_->x + std::sin(a) * arc_->y);
      along_ = (segment.end - start_ - turned) / a;
    } else {
      along_ = (segment.end - start_) / length_;
    }
  }

  CommandPart part(double time, double speed, double covered) const {
    CommandPart part = rest_at(start_, time);
    if (arc_ == nullptr) {
      part.position += covered * along_;
      part.velocity = speed * along_;
      return part;
    }
    const double a = covered / length_ * arc_->sweep;
    const double cosine = std::cos(a);
    const double sine = std::sin(a);
    part.cosine = arc_->radius * (cosine * arc_->x + sine * arc_->y);
    part.sine = arc_->radius * (cosine * arc_->y - sine * arc_->x);
    part.rate = speed / length_ * arc_->sweep;
    part.position += a * along_ + part.cosine - arc_->radius * arc_->x;
    part.velocity = part.rate * along_;
    return part;
  }

 private:
  Vec3 start_;
  double length_;
  const Arc* arc_ = nullptr;
  Vec3 along_;  ///< unit direction of a line; advance of an arc along its axis per radian
};

}  // namespace

void CommandPart::begin_later(double h) {
  time += h;
  position += h * velocity;
  if (rate > 0) {
    const double c = std::cos(rate * h);
    const double s = std::sin(rate * h);
    const Vec3 turned = c * cosine + s * sine;
    position += turned - cosine;
    sine = c * sine - s * cosine;
    cosine = turned;
  }
}

PulseWidths PulseTrain::widths(std::size_t block) const {
  const BlockPulses& pulses = blocks[block];
  const double c = half_delay();
  PulseWidths widths;
  widths.left = block > 0 ? c * (1 - pulses.corner_speed / pulses.feed) : 0;
  widths.right = block + 1 < size() ? c * (1 - blocks[block + 1].corner_speed / pulses.feed) : 0;
  widths.middle = std::max(0.0, blocks[block + 1].start - pulses.start - widths.left - widths.right);
  return widths;
}

std::size_t PulseTrain::block_at(double t) const {
  const auto after =
      std::upper_bound(blocks.begin(), blocks.end(), t,
                       [](double time, const BlockPulses& block) { return time < block.start; });
  return after == blocks.begin() ? 0 : static_cast<std::size_t>(after - blocks.begin()) - 1;
}

std::size_t PulseTrain::parts(std::size_t block, std::array<CommandPart, 3>& out) const {
  if (block == size()) {
    out[0] = rest_at(point(block), end());
    return 1;
  }
  constexpr double rounding = 1e-14;
  const BlockPulses& pulses = blocks[block];
  const PulseWidths width = widths(block);
  const double next = blocks[block + 1].start;
  const double least = rounding * (next + filter_time);
  const BlockCourse course(*this, block);
  std::size_t count = 0;
  if (width.left > least) {
    out[count++] = course.part(pulses.start, pulses.corner_speed, 0);
  }
  if (width.middle > least) {
    out[count++] = course.part(pulses.start + width.left, pulses.feed, pulses.corner_speed * width.left);
  }
  if (width.right > least) {
    const double speed = blocks[block + 1].corner_speed;
    out[count++] = course.part(next - width.right, speed, segment(block).length - speed * width.right);
  }
  return count;
}

Vec3 PulseTrain::commanded(std::size_t block, double t) const {
  std::array<CommandPart, 3> all;
  std::size_t k = parts(block, all);
  do {
    --k;
  } while (k > 0 && all[k].time > t);
  all[k].begin_later(t - all[k].time);
  return all[k].position;
}

CommandPart PulseTrain::rest_before(double time) const {
  return rest_at(point(0), time);
}

}  // namespace feedscope
