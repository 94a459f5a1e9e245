#include "core/program/path/contour_corners.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace feedscope {

namespace {

/// The rest of a motion, without its target, after a part was cut off at one of its ends.
PathMotion part_of(PathMotion motion, const PlaneElement& curve, const Vec2& from, const Vec2& to) {
  if (curve.is_arc()) {
    const double part = PlaneElement::arc(from, to, curve.center, curve.turn, 0).sweep;
    motion.arc.turns = std::max(0.0, std::floor((curve.sweep - part) / (2 * std::numbers::pi)));
    const bool vanishes = motion.arc.turns == 0 && part * curve.radius <= same_point;
    motion.block.motion = vanishes ? Motion::line : Motion::arc;
  }
  return motion;
}

}  // namespace

void ContourCorners::cut_next(const CornerCut& cut, const ContourPlane& plane) {
  if (!held_) {
    plane_ = plane;
  } else if ((plane.normal - plane_.normal).norm() > same_point) {
    finish();
    plane_ = plane;
  }
  next_ = cut;
}

void ContourCorners::end_motion() {
  if (next_) {
    corner_ = std::exchange(next_, std::nullopt);
  }
}

void ContourCorners::take(PathMotion motion, Vec3 from) {
  if (corner_) {
    resolve(motion, from);
  }
  if (held_) {
    ready_.push_back(held_->motion);
    held_.reset();
  }
  if (next_) {
    held_ = Held{motion, from};
  } else {
    ready_.push_back(motion);
  }
}

void ContourCorners::finish() {
  if (corner_ && !corner_->modal) {
    report(NC_("core", "no line or arc follows in the same plane"),
           NC_("core", "the corner stays sharp; write it between two of them"));
  }
  corner_.reset();
  if (held_) {
    ready_.push_back(held_->motion);
    held_.reset();
  }
}

bool ContourCorners::in_plane(const PathMotion& motion, const Vec3& from) const {
  constexpr double across = 1e-9;
  const bool level = std::abs(plane_.normal.dot(motion.block.target - from)) <= same_point;
  const bool is_arc = motion.block.motion == Motion::arc;
  return level && motion.block.motion != Motion::dwell &&
         (!is_arc || plane_.normal.cross(motion.arc.axis).norm() <= across);
}

void ContourCorners::resolve(PathMotion& next, Vec3& from) {
  const bool beside_rapid = held_->motion.block.motion == Motion::rapid || next.block.motion == Motion::rapid;
  if (!in_plane(held_->motion, held_->from) || !in_plane(next, from)) {
    if (!corner_->modal) {
      report(NC_("core", "the adjacent elements leave the working plane"),
             NC_("core", "the corner stays sharp"));
    }
  } else if (corner_->at_feed_only && beside_rapid) {
    if (!corner_->modal) {
      report(NC_("core", "it is adjacent to a rapid"), NC_("core", "the corner stays sharp"));
    }
  } else {
    const PlaneElement first = plane_.element_of(held_->motion, plane_.in_plane(held_->from));
    const PlaneElement second = plane_.element_of(next, plane_.in_plane(from));
    PlaneCorner piece = piece_of(first, second, corner_->size);
    if (piece.fault == CornerFault::too_large && corner_->shrinks) {
      piece = largest_piece(first, second);
    }
    if (piece.fault == CornerFault::none) {
      write(piece, first, next);
      next = part_of(next, second, piece.to, second.end);
      from = plane_.in_space(piece.to, from);
    } else {
      report(piece.fault);
    }
  }
  corner_.reset();
}

void ContourCorners::write(const PlaneCorner& piece, const PlaneElement& first, const PathMotion& next) {
  const Vec3 corner = held_->motion.block.target;
  PathMotion cut = held_->motion;
  PathMotion before = part_of(held_->motion, first, first.start, piece.from);
  before.block.target = plane_.in_space(piece.from, corner);
  cut.block.target = plane_.in_space(piece.to, corner);
  cut.block.line = corner_->line.value_or(held_->motion.block.line);
  const PathMotion& gives_feed = corner_->feed_of_next ? next : held_->motion;
  cut.block.feed = corner_->feed.value_or(gives_feed.block.feed);
  cut.block.motion = piece.turn != 0                            ? Motion::arc
                     : gives_feed.block.motion == Motion::rapid ? Motion::rapid
                                                                : Motion::line;
  cut.arc = {plane_.in_space(piece.center, corner), piece.turn * plane_.normal, 0};
  cut.place = corner_->place;
  ready_.push_back(before);
  ready_.push_back(cut);
  held_.reset();
}

PlaneCorner ContourCorners::piece_of(const PlaneElement& first, const PlaneElement& second,
                                     double size) const {
  switch (corner_->kind) {
    case CornerCut::Kind::rounding:
      return round_corner(first, second, size);
    case CornerCut::Kind::chamfer:
      break;
    case CornerCut::Kind::chamfer_by_length:
      const double cosine = first.tangent_at_end().dot(second.tangent_at_start());
      return chamfer_corner(first, second, size / std::sqrt(2 * (1 + cosine)));
  }
  return chamfer_corner(first, second, size);
}

PlaneCorner ContourCorners::largest_piece(const PlaneElement& first, const PlaneElement& second) {
  constexpr int halvings = 40;
  PlaneCorner largest;
  largest.fault = CornerFault::too_large;
  double fits = 0;
  double too_large = corner_->size;
  for (int i = 0; i < halvings; ++i) {
    const double size = (fits + too_large) / 2;
    const PlaneCorner piece = piece_of(first, second, size);
    if (piece.fault == CornerFault::none) {
      fits = size;
      largest = piece;
    } else {
      too_large = size;
    }
  }
  if (largest.fault == CornerFault::none) {
    report(message(NC_("core", "it does not fit between the adjacent elements; {:.3f} mm are used"), fits),
           NC_("core", "the control reduces it too, by its own rule"), Severity::warning);
  }
  return largest;
}

void ContourCorners::report(CornerFault fault) const {
  switch (fault) {
    case CornerFault::none:
    case CornerFault::smooth:
      break;
    case CornerFault::reversal:
      if (!corner_->modal) {
        report(NC_("core", "the path turns back at the corner"), NC_("core", "the corner stays sharp"));
      }
      break;
    case CornerFault::too_large:
      report(NC_("core", "it does not fit between the adjacent elements"),
             NC_("core", "the corner stays sharp; make it smaller"));
      break;
    case CornerFault::not_lines:
      report(NC_("core", "it is adjacent to an arc"),
             NC_("core", "the corner stays sharp; a chamfer is supported between two lines"));
      break;
  }
}

void ContourCorners::report(const Message& what, const Message& hint, Severity severity) const {
  log_.add(severity, "corner", 0, corner_->place, [&] {
    return DiagnosticLog::Text{
        message(NC_("core", "the {} of {:.3f} mm: {}"),
                corner_->kind == CornerCut::Kind::rounding ? NC_("core", "rounding") : NC_("core", "chamfer"),
                corner_->size, what),
        hint};
  });
}

}  // namespace feedscope
