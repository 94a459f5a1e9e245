#include "core/trajectory/trajectory_builder.h"

namespace feedscope {

TrajectoryBuilder::TrajectoryBuilder(const Trajectory& same_path)
    : path_(same_path.path()), records_(same_path.blends()), compaction_error_(same_path.compaction_error()) {
  for (std::size_t e = 0; e < path_.elements.size(); ++e) {
    lines_.push_back(same_path.line_of(e));
    feeds_.push_back(same_path.feed_of(e));
    rapid_.push_back(same_path.is_rapid(e));
  }
}

void TrajectoryBuilder::reserve(std::size_t elements, std::size_t pieces) {
  path_.elements.reserve(elements);
  lines_.reserve(elements);
  feeds_.reserve(elements);
  rapid_.reserve(elements);
  pieces_.reserve(pieces);
}

std::uint32_t TrajectoryBuilder::add_element(PathElement element, std::uint32_t line, double feed,
                                             bool rapid) {
  element.s = path_.length();
  path_.elements.push_back(element);
  lines_.push_back(line);
  feeds_.push_back(feed);
  rapid_.push_back(rapid);
  return static_cast<std::uint32_t>(path_.elements.size() - 1);
}

std::uint32_t TrajectoryBuilder::add_segment(const Toolpath& toolpath, std::size_t i, double feed,
                                             double cut_before, double cut_after) {
  const Segment& segment = toolpath.segments[i];
  PathElement element;
  element.start = toolpath.start_of(i);
  element.end = segment.end;
  element.length = segment.length - cut_before - cut_after;
  element.segment = static_cast<std::uint32_t>(i);
  switch (segment.kind) {
    case SegmentKind::line: {
      const Vec3 direction = toolpath.tangent_at_start(i);
      element.kind = ElementKind::line;
      element.start += cut_before * direction;
      element.end -= cut_after * direction;
      break;
    }
    case SegmentKind::arc: {
      const Arc& arc = toolpath.arcs[static_cast<std::size_t>(segment.arc)];
      element.kind = ElementKind::arc;
      element.geometry = add_arc(arc);
      element.arc_offset = cut_before;
      if (cut_before > 0) {
        element.start = arc.at(cut_before).position;
      }
      if (cut_after > 0) {
        element.end = arc.at(segment.length - cut_after).position;
      }
      break;
    }
    case SegmentKind::dwell:
      element.kind = ElementKind::dwell;
      break;
  }
  return add_element(element, segment.line, feed, segment.rapid);
}

std::uint32_t TrajectoryBuilder::add_arc(const Arc& arc) {
  path_.arcs.push_back(arc);
  return static_cast<std::uint32_t>(path_.arcs.size() - 1);
}

std::uint32_t TrajectoryBuilder::add_blend(const CubicBlend& blend) {
  path_.blends.push_back(blend);
  return static_cast<std::uint32_t>(path_.blends.size() - 1);
}

std::uint32_t TrajectoryBuilder::add_motion(FilteredMotion motion) {
  motions_.push_back(std::move(motion));
  return static_cast<std::uint32_t>(motions_.size() - 1);
}

void TrajectoryBuilder::add_piece(Piece piece, double duration) {
  if (!(duration > 0)) {
    return;
  }
  piece.time = time_;
  pieces_.push_back(piece);
  time_ += duration;
}

void TrajectoryBuilder::slow_down(const Mark& start, double factor) {
  for (std::size_t p = start.piece; p < pieces_.size(); ++p) {
    Piece& piece = pieces_[p];
    piece.time = start.time + (piece.time - start.time) * factor;
    piece.v /= factor;
    piece.a /= factor * factor;
    piece.j /= factor * factor * factor;
  }
  time_ = start.time + (time_ - start.time) * factor;
}

Trajectory TrajectoryBuilder::finish() {
  Trajectory trajectory(std::move(path_), std::move(pieces_), time_, std::move(records_), std::move(lines_),
                        std::move(feeds_), std::move(rapid_), compaction_error_, std::move(motions_));
  *this = TrajectoryBuilder();
  return trajectory;
}

}  // namespace feedscope
