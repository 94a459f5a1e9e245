#include "core/analysis/envelope/usual_motion.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/trajectory/part_walk.h"

namespace feedscope {

namespace {

constexpr std::size_t least_instants = 20;
constexpr double golden = 0.6180339887498949;

using Values = std::array<std::vector<float>, charted_of_motion.count>;

void add(Values& values, const State& state) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto id = static_cast<QuantityId>(static_cast<std::size_t>(charted_of_motion.first) + i);
    values[i].push_back(static_cast<float>(info_of(id).of(Instant(state))));
  }
}

float value_below(std::vector<float>& values, double share) {
  const auto at = values.begin() +
                  static_cast<std::ptrdiff_t>(std::lround(share * static_cast<double>(values.size() - 1)));
  std::ranges::nth_element(values, at);
  return *at;
}

MotionBand usual_ranges(Values& values) {
  MotionBand band;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (values[i].size() >= least_instants) {
      band.extents[i] = {value_below(values[i], usual_from), value_below(values[i], usual_to)};
    }
  }
  return band;
}

}  // namespace

UsualMotion usual_motion(const Trajectory& trajectory, std::span<const double> times, bool rapids,
                         int instants, Progress* progress) {
  UsualMotion usual;
  if (times.size() < 2 || trajectory.pieces().empty()) {
    return usual;
  }
  usual.ranges.reserve(times.size() - 1);
  Values values;
  double phase = 0;  // of the instant within its part
  for (std::size_t i = 0; i + 1 < times.size(); ++i) {
    std::ranges::for_each(values, [](std::vector<float>& of_one) { of_one.clear(); });
    for (int k = 0; k < instants; ++k) {
      phase = std::fmod(phase + golden, 1);
      const double time =
          std::clamp(std::lerp(times[i], times[i + 1], (k + phase) / instants), 0.0, trajectory.duration());
      const std::size_t piece = trajectory.piece_at(time);
      PartWalk walk(trajectory, piece, time - trajectory.pieces()[piece].time);
      if (!walk.done() && (rapids || !trajectory.is_rapid(walk.part().element))) {
        add(values, walk.motion().state_without_length(0));
      }
    }
    const std::vector<float>& feeds = values[charted_index(QuantityId::feed) - charted_of_motion.index];
    usual.feeds.insert(usual.feeds.end(), feeds.begin(), feeds.end());
    usual.ranges.push_back(usual_ranges(values));
    if (progress != nullptr) {
      progress->report(static_cast<double>(i + 1) / static_cast<double>(times.size() - 1));
    }
  }
  std::ranges::sort(usual.feeds);
  return usual;
}

}  // namespace feedscope
