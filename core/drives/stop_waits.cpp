#include "core/drives/stop_waits.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/drives/drive_response.h"

namespace feedscope {
namespace {

struct Wait {
  std::size_t piece = 0;  ///< the wait follows it
  double begin = 0;       ///< on the clock without waits [s]
  double duration = 0;    ///< [s]
};

bool stops_exactly(const Toolpath& path, std::size_t segment) {
  const PathControl& control = path.path_control_of(segment);
  return control.mode == PathMode::exact_stop &&
         control.exact_stop_window != ExactStopWindow::interpolation_end;
}

/// Whether the control waits for its axes at the end of a piece, after motion.
bool waits_behind(const Trajectory& motion, std::size_t piece) {
  const BlendedPath& path = motion.path();
  const std::uint32_t last = motion.last_element(piece);
  const auto is_pause = [&](std::uint32_t element) { return path.kind(element) == ElementKind::dwell; };
  if (is_pause(last)) {
    return false;
  }
  if (piece + 1 == motion.pieces().size()) {
    return true;
  }
  const std::uint32_t next = motion.pieces()[piece + 1].element;
  if (next == last) {
    return false;
  }
  constexpr double at_rest = 1e-9;  // [mm/s]
  return is_pause(next) || (stops_exactly(path.base(), path.base_segment_of(last)) &&
                            motion.state(motion.pieces()[piece + 1].time).speed <= at_rest);
}

std::vector<Wait> find_waits(const Trajectory& motion, const Machine& machine, double window,
                             const Progress* progress) {
  constexpr double rounding = 1e-10;  // [s]
  std::vector<Wait> waits;
  const AxisDrives drives(machine);
  ActualWalk walk(motion, drives);
  for (std::size_t piece = 0; piece < motion.pieces().size(); ++piece) {
    if (!waits_behind(motion, piece)) {
      continue;
    }
    stop_if_cancelled(progress);
    const double end = motion.piece_end(piece);
    // Pieces and the spans of the drives add up times differently: an end that is later by rounding counts.
    while (!walk.done() && walk.span().end() <= end + rounding) {
      walk.next_span();
    }
    if (const double wait = walk.settling_time(window); wait > 0) {
      walk.rest(wait);
      waits.push_back({piece, end, wait});
    }
  }
  return waits;
}

}  // namespace

Trajectory with_stop_waits(Trajectory motion, const Machine& machine, double window,
                           const Progress* progress) {
  const std::vector<Wait> waits = find_waits(motion, machine, window, progress);
  if (waits.empty()) {
    return motion;
  }
  std::vector<std::uint32_t> elements;  // the waits are at their ends
  for (const Wait& wait : waits) {
    elements.push_back(motion.last_element(wait.piece));
  }
  Trajectory::Content content = std::move(motion).take();
  std::vector<Piece> pieces;
  pieces.reserve(content.pieces.size() + waits.size());
  double later = 0;
  std::size_t next = 0;
  for (std::size_t i = 0; i < content.pieces.size(); ++i) {
    pieces.push_back(content.pieces[i]);
    pieces.back().time += later;
    if (next < waits.size() && waits[next].piece == i) {
      Piece rest;
      rest.time = waits[next].begin + later;
      rest.element = elements[next];
      rest.q = content.path.length(rest.element);
      rest.cause = {CauseKind::exact_stop};
      pieces.push_back(rest);
      later += waits[next].duration;
      ++next;
    }
  }
  content.pieces = std::move(pieces);
  content.duration += later;
  later = 0;
  next = 0;
  for (FilteredMotion& filtered : content.motions) {  // in order of time
    for (; next < waits.size() && waits[next].begin <= filtered.start(); ++next) {
      later += waits[next].duration;
    }
    filtered.begin_later(later);
  }
  return Trajectory(std::move(content));
}

}  // namespace feedscope
