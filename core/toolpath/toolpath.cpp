#include "core/toolpath/toolpath.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

namespace feedscope {

namespace {

/// Frame and sweep of an arc block from `start` to `end`.
Arc arc_between(const Vec3& start, const Vec3& end, const ArcWords& words) {
  constexpr double full_turn = 2 * std::numbers::pi;
  const auto in_plane = [&](const Vec3& v) -> Vec3 { return v - words.axis.dot(v) * words.axis; };
  const Vec3 from = in_plane(start - words.center);
  const Vec3 to = in_plane(end - words.center);
  Arc arc;
  arc.radius = from.norm();
  arc.x = from / arc.radius;
  arc.y = words.axis.cross(arc.x);
  double partial = 0;
  if ((to - from).norm() > same_point) {
    partial = std::atan2(to.dot(arc.y), to.dot(arc.x));
    partial += partial < 0 ? full_turn : 0;
  }
  arc.sweep = partial + full_turn * words.turns;
  arc.center = start - from;
  arc.rise = words.axis.dot(end - start) / arc.sweep * words.axis;
  return arc;
}

/// Largest gap that may remain before an arc [mm].
constexpr double arc_gap = 1e-10;

/// True for dialects of words of a letter and a number, as any control of ISO programs reads them.
bool is_g_code(Dialect dialect) {
  return dialect == Dialect::iso || dialect == Dialect::fanuc || dialect == Dialect::linuxcnc ||
         dialect == Dialect::grbl;
}

Segment line_segment(const Vec3& start, const MotionBlock& block) {
  Segment segment;
  segment.end = block.target;
  segment.length = (block.target - start).norm();
  segment.feed = block.feed;
  segment.line = block.line;
  segment.path_control = block.path_control;
  segment.spindle = block.spindle;
  segment.rapid = block.motion == Motion::rapid;
  segment.on_curve = block.on_curve;
  return segment;
}

Vec3 tangent(const Toolpath& toolpath, std::size_t i, bool at_end) {
  const Segment& segment = toolpath.segments[i];
  switch (segment.kind) {
    case SegmentKind::line:
      return (segment.end - toolpath.start_of(i)) / segment.length;
    case SegmentKind::arc: {
      const Arc& arc = toolpath.arc_of(segment);
      return arc.at(at_end ? segment.length : 0).d1;
    }
    case SegmentKind::dwell:
      break;
  }
  return Vec3::Zero();
}

/// The item of `segment` in a list sorted by segment; null for none.
template <typename Item>
const Item* of_segment(const std::vector<Item>& items, std::size_t segment) {
  const auto found = std::ranges::lower_bound(items, segment, std::less(), &Item::segment);
  return found != items.end() && found->segment == segment ? &*found : nullptr;
}

}  // namespace

const SegmentTurn* Toolpath::segment_turn(std::size_t i) const {
  return of_segment(segment_turns, i);
}

const TurnJoint* Toolpath::turn_joint(std::size_t i) const {
  return of_segment(turn_joints, i);
}

std::span<const TurnPart> Toolpath::turn_parts_of(std::size_t i) const {
  const auto first = std::ranges::lower_bound(turn_parts, i, std::less(), &TurnPart::segment);
  const auto last = std::ranges::upper_bound(first, turn_parts.end(), i, std::less(), &TurnPart::segment);
  return {first, last};
}

CurvePoint Toolpath::place_on(std::size_t i, double s) const {
  const Segment& segment = segments[i];
  if (segment.kind == SegmentKind::arc) {
    return arc_of(segment).at(s);
  }
  const Vec3& from = start_of(i);
  const Vec3 direction = (segment.end - from) / segment.length;
  return {from + s * direction, direction, Vec3::Zero(), Vec3::Zero()};
}

Vec3 Toolpath::tangent_at_start(std::size_t i) const {
  return tangent(*this, i, false);
}

Vec3 Toolpath::tangent_at_end(std::size_t i) const {
  return tangent(*this, i, true);
}

double Toolpath::length() const {
  double sum = 0;
  for (const Segment& segment : segments) {
    sum += segment.length;
  }
  return sum;
}

Toolpath build_toolpath(const ReadProgram& program) {
  Toolpath toolpath;
  toolpath.source = is_g_code(program.dialect) ? program.source : nullptr;
  toolpath.bounds = program.bounds;
  toolpath.other_axes = program.other_axes;
  toolpath.cutting_axes = program.cutting_axes;
  for (const OffsetUse& use : program.work_offsets) {
    toolpath.zero_points.push_back({use.name, use.zero, !use.given});
  }
  if (!program.path_controls.empty()) {
    toolpath.path_controls = program.path_controls;
  }
  if (!program.spindles.empty()) {
    toolpath.spindles = program.spindles;
  }
  toolpath.segments.reserve(program.motions.size());
  toolpath.arcs.reserve(program.arcs.size());
  Vec3 position = toolpath.start;  // where the last segment ends
  MotionBlock skipped;             // the last line too short to be a segment
  skipped.target = position;
  auto turn = program.rotary_moves.begin();
  const auto take_turns = [&](std::uint64_t motion) {
    for (; turn != program.rotary_moves.end() && turn->motion <= motion; ++turn) {
      toolpath.rotary_moves.push_back(*turn);
      toolpath.rotary_moves.back().motion = toolpath.segments.size();
    }
  };
  std::uint64_t motion = 0;
  for (const MotionBlock& block : program.motions) {
    take_turns(motion++);
    // An arc is exact only from its programmed start.
    if (block.motion == Motion::arc && (skipped.target - position).norm() > arc_gap) {
      toolpath.segments.push_back(line_segment(position, skipped));
      position = skipped.target;
    }
    Segment segment;
    segment.end = block.target;
    segment.feed = block.feed;
    segment.line = block.line;
    segment.path_control = block.path_control;
    segment.spindle = block.spindle;
    segment.rapid = block.motion == Motion::rapid;
    segment.on_curve = block.on_curve;
    switch (block.motion) {
      case Motion::dwell:
        segment.kind = SegmentKind::dwell;
        segment.feed = 0;
        segment.end = position;
        segment.index = static_cast<std::int32_t>(toolpath.pauses.size());
        toolpath.pauses.push_back({block.dwell, block.pause, block.pause == Pause::dwell,
                                   static_cast<std::uint32_t>(toolpath.machine_moves.size())});
        if (block.pause == Pause::machine_move) {
          segment.end = block.target;
          skipped.target = block.target;
          toolpath.machine_moves.push_back(program.machine_moves[static_cast<std::size_t>(block.arc)]);
        }
        break;
      case Motion::arc: {
        const ArcWords& words = program.arcs[static_cast<std::size_t>(block.arc)];
        const Arc arc = arc_between(position, block.target, words);
        segment.kind = SegmentKind::arc;
        segment.index = static_cast<std::int32_t>(toolpath.arcs.size());
        segment.length = arc.length();
        if (words.misfit != Vec3::Zero() || !toolpath.misfits.empty()) {
          toolpath.misfits.resize(toolpath.arcs.size(), Vec3::Zero());
          toolpath.misfits.push_back(words.misfit);
        }
        toolpath.arcs.push_back(arc);
        break;
      }
      case Motion::rapid:
      case Motion::line:
        segment = line_segment(position, block);
        if (segment.length <= same_point) {
          skipped = block;
          continue;
        }
        break;
    }
    position = segment.end;
    if (segment.kind != SegmentKind::dwell) {
      skipped.target = position;
    }
    toolpath.segments.push_back(segment);
  }
  take_turns(std::numeric_limits<std::uint64_t>::max());
  return toolpath;
}

}  // namespace feedscope
