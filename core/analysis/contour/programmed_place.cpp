#include "core/analysis/contour/programmed_place.h"

#include <algorithm>

namespace feedscope {
namespace {

/// Executed path lengths at which a segment begins and ends [mm].
struct ProgrammedStretch {
  double begin = 0;
  double end = 0;
};

/// First element of `path` whose segment is not before `segment`; path.size() if there is none.
std::size_t first_element_from(const BlendedPath& path, std::uint64_t segment) {
  std::size_t low = 0;
  std::size_t high = path.size();
  while (low < high) {
    const std::size_t middle = low + (high - low) / 2;
    if (path.segment(middle) < segment) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low;
}

/// Executed path length at which `segment` begins: the middle of the corner before it, which is one element
/// or several of the segment before.
double begin_of(const BlendedPath& path, std::uint64_t segment) {
  const std::size_t first = first_element_from(path, segment);
  std::size_t corner = first;
  while (first < path.size() && corner > 0 && path.rounds_corner(corner - 1) &&
         path.segment(corner - 1) == path.segment(first - 1)) {
    --corner;
  }
  return (path.s(corner) + path.s(first)) / 2;
}

ProgrammedStretch stretch_of(const BlendedPath& path, std::uint32_t segment) {
  return {begin_of(path, segment), begin_of(path, std::uint64_t{segment} + 1)};
}

/// Place at path length `s`, which is on `element`.
ProgrammedPlace place_on(const BlendedPath& path, std::size_t element, double s) {
  std::uint32_t segment = path.segment(element);
  const std::size_t next = first_element_from(path, std::uint64_t{segment} + 1);
  if (next < path.size() && s > begin_of(path, path.segment(next))) {
    segment = path.segment(next);
  }
  const auto [begin, end] = stretch_of(path, segment);
  return {segment, end > begin ? std::clamp((s - begin) / (end - begin), 0.0, 1.0) : 0.0};
}

}  // namespace

ProgrammedPlace programmed_place(const BlendedPath& path, double s) {
  if (path.empty()) {
    return {};
  }
  return place_on(path, path.element_at(std::clamp(s, 0.0, path.length())), s);
}

double path_length_of(const BlendedPath& path, const ProgrammedPlace& place) {
  const auto [begin, end] = stretch_of(path, place.segment);
  return begin + place.share * (end - begin);
}

ProgrammedPlace programmed_place(const Trajectory& trajectory, double time) {
  if (trajectory.pieces().empty()) {
    return {};
  }
  const State state = trajectory.state(time);
  return place_on(trajectory.path(), state.element, state.path_length);
}

double time_of(const Trajectory& trajectory, const ProgrammedPlace& place) {
  return trajectory.pieces().empty()
             ? 0
             : trajectory.state_at_path(path_length_of(trajectory.path(), place)).time;
}

}  // namespace feedscope
