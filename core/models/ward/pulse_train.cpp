#include "core/models/ward/pulse_train.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace feedscope {

double short_block_speed(double speed, double length, double half_delay) {
  const double reach = half_delay * speed;
  return reach > length ? reach * speed / (reach - length) : std::numeric_limits<double>::infinity();
}

void cap_by_short_blocks(std::span<const Link> links, double half_delay, std::span<double> corner_speeds) {
  for (std::size_t i = 1; i + 1 < links.size(); ++i) {
    corner_speeds[i + 1] =
        std::min(corner_speeds[i + 1], short_block_speed(corner_speeds[i], links[i].length, half_delay));
  }
  for (std::size_t i = links.size() - 1; i-- > 1;) {
    corner_speeds[i] =
        std::min(corner_speeds[i], short_block_speed(corner_speeds[i + 1], links[i].length, half_delay));
  }
}

LinkPulses link_pulses(std::span<const Link> links, std::size_t i, double half_delay,
                       std::span<const double> corner_speeds) {
  const double length = links[i].length;
  const double left = i == 0 ? 0 : corner_speeds[i];
  const double right = i + 1 == links.size() ? 0 : corner_speeds[i + 1];
  const bool blends_left = i > 0;
  const bool blends_right = i + 1 < links.size();
  LinkPulses pulses;
  pulses.feed = links[i].feed.value;
  const auto blended = [&](double feed) {
    return half_delay * (left * (1 - left / feed) + right * (1 - right / feed));
  };
  const bool is_short = blended(pulses.feed) > length;
  if (is_short) {
    pulses.feed = half_delay * (left * left + right * right) / (half_delay * (left + right) - length);
  }
  const double fastest = std::max(left, right);
  pulses.feed = std::max(pulses.feed, fastest);
  pulses.width_left = blends_left ? half_delay * (1 - left / pulses.feed) : 0;
  pulses.width_right = blends_right ? half_delay * (1 - right / pulses.feed) : 0;
  const double rest = length - left * pulses.width_left - right * pulses.width_right;
  pulses.width = is_short ? 0 : std::max(0.0, rest / pulses.feed);
  return pulses;
}

PulseTrain lay_pulses(std::span<const Link> links, double half_delay, std::span<const double> corner_speeds,
                      const Vec3& end) {
  PulseTrain train;
  train.pulses.reserve(links.size() + 1);
  train.link_start.reserve(links.size() + 1);
  double time = 0;
  for (std::size_t i = 0; i < links.size(); ++i) {
    const Link& link = links[i];
    train.link_start.push_back(time);
    const LinkPulses pulses = link_pulses(links, i, half_delay, corner_speeds);
    const double left = corner_speeds[i];
    const double right = corner_speeds[i + 1];
    double covered = 0;
    double speed_before = -1;
    const auto add = [&](double speed, double width) {
      if (!(width > 0)) {
        return;
      }
      if (speed != speed_before) {
        train.pulses.push_back({time, link.direction * speed, link.start + link.direction * covered});
        speed_before = speed;
      }
      time += width;
      covered += speed * width;
    };
    add(left, pulses.width_left);
    add(pulses.feed, pulses.width);
    add(right, pulses.width_right);
  }
  train.link_start.push_back(time);
  train.pulses.push_back({time, Vec3::Zero(), end});
  return train;
}

}  // namespace feedscope
