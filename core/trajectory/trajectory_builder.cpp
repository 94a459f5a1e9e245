#include "core/trajectory/trajectory_builder.h"

#include <algorithm>

#include "core/base/make_room.h"
#include "core/limits/segment_limits.h"

namespace feedscope {
namespace {

ElementKind element_kind(SegmentKind kind) {
  switch (kind) {
    case SegmentKind::arc:
      return ElementKind::arc;
    case SegmentKind::dwell:
      return ElementKind::dwell;
    case SegmentKind::line:
      break;
  }
  return ElementKind::line;
}

CauseKind cause_of(Pause pause) {
  switch (pause) {
    case Pause::tool_change:
      return CauseKind::tool_change;
    case Pause::spindle_start:
      return CauseKind::spindle_start;
    case Pause::indexing:
      return CauseKind::indexing;
    case Pause::swing:
      return CauseKind::swing;
    case Pause::dwell:
    case Pause::stop:
    case Pause::machine_move:
      break;
  }
  return CauseKind::dwell;
}

}  // namespace

TrajectoryBuilder::TrajectoryBuilder(std::shared_ptr<const Toolpath> programmed, const Vec3& axis_velocity,
                                     std::shared_ptr<const CompactedPath> compacted) {
  content().path = BlendedPath(std::move(programmed), std::move(compacted));
  content().axis_velocity = axis_velocity;
}

TrajectoryBuilder::TrajectoryBuilder(std::shared_ptr<const Toolpath> programmed, const Vec3& axis_velocity,
                                     std::shared_ptr<const ExecutedPath> executed) {
  content().path = BlendedPath(std::move(programmed), std::move(executed));
  content().axis_velocity = axis_velocity;
}

TrajectoryBuilder::TrajectoryBuilder(const Trajectory& same_path) : so_far_(same_path) {
  content().pieces.clear();
  content().duration = 0;
}

void TrajectoryBuilder::reserve(std::size_t elements, std::size_t pieces) {
  content().path.reserve(elements);
  content().pieces.reserve(pieces);
}

void TrajectoryBuilder::reserve_for_path(std::size_t most, std::size_t done) {
  constexpr double slack = 1.02;
  constexpr std::size_t growth = 8;  // upper limit: the first elements may differ from the others
  std::vector<Piece>& pieces = content().pieces;
  const std::size_t needed = pieces.size() + most;
  if (needed > pieces.capacity()) {
    const double share =
        static_cast<double>(path().size()) / static_cast<double>(std::max<std::size_t>(done, 1));
    const auto expected = static_cast<std::size_t>(slack * share * static_cast<double>(pieces.size()));
    pieces.reserve(std::clamp(expected + most, needed, growth * needed));
  }
}

TrajectoryBuilder TrajectoryBuilder::part() const {
  TrajectoryBuilder part;
  part.content().path = path().without_elements();
  part.content().axis_velocity = content().axis_velocity;
  part.stop_with(progress_);
  return part;
}

void TrajectoryBuilder::append(TrajectoryBuilder part, double done) {
  Trajectory::Content& more = part.content();
  Trajectory::Content& whole = content();
  const auto elements = static_cast<std::uint32_t>(whole.path.size());
  const double start = whole.duration;
  whole.path.append(more.path, motion_count(), done);
  make_room(whole.pieces, more.pieces.size(), done);
  for (std::size_t p = 0; p < more.pieces.size(); ++p) {
    Piece piece = more.pieces[p];
    const double end = p + 1 < more.pieces.size() ? more.pieces[p + 1].time : more.duration;
    piece.time += start;
    piece.element += elements;
    if (start + end > piece.time) {  // otherwise below the resolution of the clock
      whole.pieces.push_back(piece);
    }
  }
  for (FilteredMotion& motion : more.motions) {
    motion.begin_later(start);
    whole.motions.push_back(std::move(motion));
  }
  for (const std::uint32_t element : more.filtered_corners) {
    whole.filtered_corners.push_back(elements + element);
  }
  whole.compaction_error = std::max(whole.compaction_error, more.compaction_error);
  whole.duration = start + more.duration;
}

std::uint32_t TrajectoryBuilder::add_segment(std::uint32_t block, double length) {
  count_addition();
  return content().path.add(element_kind(programmed().segments[block].kind), block, length);
}

std::uint32_t TrajectoryBuilder::add_segment(std::uint32_t block) {
  return add_segment(block, programmed().segments[block].length);
}

std::uint32_t TrajectoryBuilder::add_corner(ElementKind kind, std::uint32_t block, double transition,
                                            double length) {
  count_addition();
  return content().path.add_corner(kind, block, transition, length);
}

std::uint32_t TrajectoryBuilder::add_filtered(std::uint32_t block, double length, std::uint32_t motion) {
  count_addition();
  return content().path.add(ElementKind::filtered, block, length, motion);
}

std::uint32_t TrajectoryBuilder::add_motion(FilteredMotion motion) {
  content().motions.push_back(std::move(motion));
  return static_cast<std::uint32_t>(content().motions.size() - 1);
}

void TrajectoryBuilder::add_pause(std::uint32_t block) {
  pass_pause(add_segment(block));
}

void TrajectoryBuilder::pass_pause(std::uint32_t element) {
  pass_pause(element, programmed().dwell_of(programmed().segments[path().segment(element)]));
}

void TrajectoryBuilder::pass_pause(std::uint32_t element, double time) {
  const Segment& segment = programmed().segments[path().segment(element)];
  const ToolpathPause& pause = programmed().pause_of(segment);
  add_piece({0, 0, 0, 0, 0, element, {cause_of(pause.kind), pause.axis}}, time);
}

void TrajectoryBuilder::add_piece(Piece piece, double duration) {
  count_addition();
  if (!(content().duration + duration > content().duration)) {  // zero, or below the resolution of the clock
    return;
  }
  piece.time = content().duration;
  content().pieces.push_back(piece);
  content().duration += duration;
}

void TrajectoryBuilder::add_level_piece(const Piece& piece, double duration) {
  const auto goes_on_from = [&](const Piece& before) {
    return before.law == Law::path_length && before.a == 0 && before.j == 0 && before.v == piece.v &&
           before.cause == piece.cause;
  };
  if (content().pieces.empty() || !goes_on_from(content().pieces.back())) {
    add_piece(piece, duration);
    return;
  }
  // By the way from its beginning: rounding of the clock would add up over many elements.
  const Piece& before = content().pieces.back();
  const double way = path().s(piece.element) - path().s(before.element) + piece.q - before.q;
  content().duration = std::max(content().duration, before.time + (way / piece.v + duration));
}

void TrajectoryBuilder::take_back(const Mark& start) {
  content().pieces.resize(start.piece);
  content().duration = start.time;
}

void TrajectoryBuilder::slow_down(const Mark& start, double factor) {
  for (std::size_t p = start.piece; p < content().pieces.size(); ++p) {
    Piece& piece = content().pieces[p];
    piece.time = start.time + (piece.time - start.time) * factor;
    piece.v /= factor;
    piece.a /= factor * factor;
    piece.j /= factor * factor * factor;
  }
  content().duration = start.time + (content().duration - start.time) * factor;
}

void TrajectoryBuilder::name_slower_places() {
  const auto& pieces = content().pieces;
  Cause ahead{CauseKind::exact_stop};
  for (std::size_t p = pieces.size(); p-- > 0;) {
    Piece& piece = content().pieces[p];
    if (piece.cause.kind == CauseKind::ramp_down) {
      if (piece.second == Piece::no_cause) {
        piece.second = static_cast<std::uint8_t>(cause_index(ahead));
      }
      continue;
    }
    const bool filtered = piece.law == Law::filtered;
    const bool from_rest = filtered ? p == 0 || pieces[p - 1].law != Law::filtered ||
                                          path().index(pieces[p - 1].element) != path().index(piece.element)
                                    : piece.v <= 0;
    const std::uint32_t segment = path().segment(piece.element);
    ahead = !from_rest ? piece.cause
            : segment > 0 && path().programmed() != nullptr
                ? stop_cause(*path().programmed(), segment - std::size_t{1})
                : Cause{CauseKind::exact_stop};
  }
}

Trajectory TrajectoryBuilder::finish() {
  name_slower_places();
  content().path.shrink();
  constexpr std::size_t slack = 32;  // a 32nd of the capacity is not worth a copy
  if (content().pieces.capacity() - content().pieces.size() > content().pieces.capacity() / slack) {
    content().pieces.shrink_to_fit();
  }
  return Trajectory(std::move(content()));
}

}  // namespace feedscope
