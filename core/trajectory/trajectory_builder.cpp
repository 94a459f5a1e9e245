#include "core/trajectory/trajectory_builder.h"

#include <algorithm>

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
  content_.path = BlendedPath(std::move(programmed), std::move(compacted));
  content_.axis_velocity = axis_velocity;
}

TrajectoryBuilder::TrajectoryBuilder(const Trajectory& same_path) : content_(same_path.content()) {
  content_.pieces.clear();
  content_.duration = 0;
}

void TrajectoryBuilder::reserve(std::size_t elements, std::size_t pieces) {
  content_.path.reserve(elements);
  content_.pieces.reserve(pieces);
}

void TrajectoryBuilder::reserve_for_path(std::size_t most, std::size_t done) {
  constexpr double slack = 1.02;
  constexpr std::size_t growth = 8;  // at most: the first elements may be unlike the others
  std::vector<Piece>& pieces = content_.pieces;
  const std::size_t needed = pieces.size() + most;
  if (needed > pieces.capacity()) {
    const double share =
        static_cast<double>(path().size()) / static_cast<double>(std::max<std::size_t>(done, 1));
    const auto expected = static_cast<std::size_t>(slack * share * static_cast<double>(pieces.size()));
    pieces.reserve(std::clamp(expected + most, needed, growth * needed));
  }
}

std::uint32_t TrajectoryBuilder::add_segment(std::uint32_t block, double length) {
  return content_.path.add(element_kind(programmed().segments[block].kind), block, length);
}

std::uint32_t TrajectoryBuilder::add_segment(std::uint32_t block) {
  return add_segment(block, programmed().segments[block].length);
}

std::uint32_t TrajectoryBuilder::add_corner(ElementKind kind, std::uint32_t block, double transition,
                                            double length) {
  return content_.path.add_corner(kind, block, transition, length);
}

std::uint32_t TrajectoryBuilder::add_filtered(std::uint32_t block, double length, std::uint32_t motion) {
  return content_.path.add(ElementKind::filtered, block, length, motion);
}

std::uint32_t TrajectoryBuilder::add_motion(FilteredMotion motion) {
  content_.motions.push_back(std::move(motion));
  return static_cast<std::uint32_t>(content_.motions.size() - 1);
}

void TrajectoryBuilder::add_pause(std::uint32_t block) {
  pass_pause(add_segment(block));
}

void TrajectoryBuilder::pass_pause(std::uint32_t element) {
  const Segment& segment = programmed().segments[path().segment(element)];
  add_piece({0, 0, 0, 0, 0, element, {cause_of(programmed().pause_of(segment).kind)}},
            programmed().dwell_of(segment));
}

void TrajectoryBuilder::add_piece(Piece piece, double duration) {
  if (!(content_.duration + duration > content_.duration)) {  // nothing, or less than the clock resolves
    return;
  }
  piece.time = content_.duration;
  content_.pieces.push_back(piece);
  content_.duration += duration;
}

void TrajectoryBuilder::add_level_piece(const Piece& piece, double duration) {
  const auto goes_on_from = [&](const Piece& before) {
    return before.law == Law::path_length && before.a == 0 && before.j == 0 && before.v == piece.v &&
           before.cause == piece.cause;
  };
  if (content_.pieces.empty() || !goes_on_from(content_.pieces.back())) {
    add_piece(piece, duration);
    return;
  }
  // By the way from where it began: what the clock rounds would add up over many elements.
  const Piece& before = content_.pieces.back();
  const double way = path().s(piece.element) - path().s(before.element) + piece.q - before.q;
  content_.duration = std::max(content_.duration, before.time + (way / piece.v + duration));
}

void TrajectoryBuilder::take_back(const Mark& start) {
  content_.pieces.resize(start.piece);
  content_.duration = start.time;
}

void TrajectoryBuilder::slow_down(const Mark& start, double factor) {
  for (std::size_t p = start.piece; p < content_.pieces.size(); ++p) {
    Piece& piece = content_.pieces[p];
    piece.time = start.time + (piece.time - start.time) * factor;
    piece.v /= factor;
    piece.a /= factor * factor;
    piece.j /= factor * factor * factor;
  }
  content_.duration = start.time + (content_.duration - start.time) * factor;
}

void TrajectoryBuilder::name_slower_places() {
  const auto& pieces = content_.pieces;
  Cause ahead{CauseKind::exact_stop};
  for (std::size_t p = pieces.size(); p-- > 0;) {
    Piece& piece = content_.pieces[p];
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
    ahead = from_rest ? Cause{CauseKind::exact_stop} : piece.cause;
  }
}

Trajectory TrajectoryBuilder::finish() {
  name_slower_places();
  content_.path.shrink();
  constexpr std::size_t slack = 32;  // a 32nd of the room is not worth a copy
  if (content_.pieces.capacity() - content_.pieces.size() > content_.pieces.capacity() / slack) {
    content_.pieces.shrink_to_fit();
  }
  return Trajectory(std::move(content_));
}

}  // namespace feedscope
