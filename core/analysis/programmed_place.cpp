#include "core/analysis/programmed_place.h"

#include <algorithm>
#include <ranges>

namespace feedscope {
namespace {

/// Executed path lengths at which a segment begins and ends [mm].
struct Stretch {
  double begin = 0;
  double end = 0;
};

Stretch stretch_of(const BlendedPath& path, std::uint32_t segment) {
  const auto elements = std::views::iota(std::size_t{0}, path.size());
  const auto of = [&path](std::size_t element) { return path.segment(element); };
  const auto [first, last] = std::ranges::equal_range(elements, segment, {}, of);
  return {path.s(static_cast<std::size_t>(first - elements.begin())),
          path.s(static_cast<std::size_t>(last - elements.begin()))};
}

}  // namespace

ProgrammedPlace programmed_place(const Trajectory& trajectory, double time) {
  if (trajectory.pieces().empty()) {
    return {};
  }
  const State state = trajectory.state(time);
  const std::uint32_t segment = trajectory.path().segment(state.element);
  const auto [begin, end] = stretch_of(trajectory.path(), segment);
  return {segment, end > begin ? std::clamp((state.path_length - begin) / (end - begin), 0.0, 1.0) : 0.0};
}

double time_of(const Trajectory& trajectory, const ProgrammedPlace& place) {
  if (trajectory.pieces().empty()) {
    return 0;
  }
  const auto [begin, end] = stretch_of(trajectory.path(), place.segment);
  return trajectory.state_at_path(begin + place.share * (end - begin)).time;
}

}  // namespace feedscope
