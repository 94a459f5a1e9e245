#include "core/models/ward/short_blocks.h"

#include <algorithm>
#include <limits>

namespace feedscope {

double short_block_speed(double speed, double length, double half_delay) {
  const double reach = half_delay * speed;
  return reach > length ? reach * speed / (reach - length) : std::numeric_limits<double>::infinity();
}

void cap_by_short_blocks(const PulseTrain& train, std::span<double> corner_speeds) {
  const double c = train.half_delay();
  const auto cap = [&](double& speed, double other, std::size_t block) {
    const double length = train.segment(block).length;
    const double reach = c * other;
    if (speed * (reach - length) > reach * other) {  // most are not capped, and need no division
      speed = std::min(speed, short_block_speed(other, length, c));
    }
  };
  for (std::size_t i = 1; i + 1 < train.size(); ++i) {
    cap(corner_speeds[i + 1], corner_speeds[i], i);
  }
  for (std::size_t i = train.size() - 1; i-- > 1;) {
    cap(corner_speeds[i], corner_speeds[i + 1], i);
  }
}

void lay_pulses(PulseTrain& train, std::span<const SpeedBound> limits,
                std::span<const double> corner_speeds) {
  const double c = train.half_delay();
  double time = 0;
  train.largest_feed = 0;
  for (std::size_t i = 0; i < train.size(); ++i) {
    BlockPulses& pulses = train.blocks[i];
    const double length = train.segment(i).length;
    const double left = i > 0 ? corner_speeds[i] : 0;
    const double right = i + 1 < train.size() ? corner_speeds[i + 1] : 0;
    const double sum = c * (left + right);
    const double squares = c * (left * left + right * right);
    // The middle pulse of height f covers L - sum + squares/f.
    const double limit = limits[i].value;
    const bool is_short = sum - squares / limit > length;
    pulses.feed = std::max({is_short ? squares / (sum - length) : limit, left, right});
    train.largest_feed = std::max(train.largest_feed, pulses.feed);
    pulses.start = time;
    pulses.corner_speed = left;
    const double inverse = 1 / pulses.feed;
    const double rest = is_short ? 0 : std::max(0.0, length - sum + squares * inverse);
    time += (i > 0 ? c * (1 - left * inverse) : 0) + (i + 1 < train.size() ? c * (1 - right * inverse) : 0) +
            rest * inverse;
  }
  train.blocks.back() = {time, 0, 0};
}

}  // namespace feedscope
