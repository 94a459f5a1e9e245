#include "core/trajectory/trajectory.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/limits/segment_limits.h"
#include "core/trajectory/corner_record.h"
#include "core/trajectory/filtered_corner.h"
#include "core/trajectory/part_walk.h"

namespace feedscope {

double Trajectory::piece_end(std::size_t piece) const {
  return piece + 1 < pieces().size() ? pieces()[piece + 1].time : duration();
}

std::size_t Trajectory::piece_at(double time) const {
  const auto after = std::upper_bound(pieces().begin(), pieces().end(), time,
                                      [](double t, const Piece& p) { return t < p.time; });
  return after == pieces().begin() ? 0 : static_cast<std::size_t>(after - pieces().begin()) - 1;
}

std::uint32_t Trajectory::last_element(std::size_t piece) const {
  const std::uint32_t first = pieces()[piece].element;
  const Law law = pieces()[piece].law;
  if (law == Law::parameter || law == Law::filtered) {
    return first;
  }
  auto last = static_cast<std::uint32_t>(path().size() - 1);
  if (piece + 1 < pieces().size()) {
    const Piece& next = pieces()[piece + 1];
    last = next.q > 0 || next.element == 0 ? next.element : next.element - 1;
  }
  while (last > first && path().kind(last) == ElementKind::dwell) {  // takes no time
    --last;
  }
  return std::max(first, last);
}

Cause Trajectory::slower_place(std::size_t index) const {
  const Piece& piece = pieces()[index];
  return piece.cause.kind == CauseKind::ramp_down && piece.second != Piece::no_cause
             ? all_causes()[piece.second]
             : piece.cause;
}

double Trajectory::feed_of(std::size_t element) const {
  const bool executed = path().is_executed();
  return programmed_speed(executed ? path().base() : *path().programmed(),
                          executed ? path().base_segment_of(element) : path().segment(element),
                          content_.axis_velocity)
      .value;
}

State Trajectory::state(double time) const {
  if (pieces().empty()) {
    State rest;
    rest.position = rest.velocity = rest.acceleration = rest.jerk = Vec3::Zero();
    return rest;
  }
  const double t = std::clamp(time, 0.0, duration());
  const std::size_t piece = piece_at(t);
  return PartMotion(*this, PartWalk(*this, piece, t - pieces()[piece].time).part()).state(0);
}

State Trajectory::state_at_path(double path_length) const {
  if (pieces().empty()) {
    return state(0);
  }
  if (path_length >= path().length()) {
    return state(duration());
  }
  const double s = std::max(path_length, 0.0);
  const std::size_t element = path().element_at(s);
  const double local = s - path().s(element);
  const auto curved = [&] { return path().curve(element).blend.parameter_at(local); };
  const auto begins_before = [&](const Piece& piece, double) {
    if (piece.element != element) {
      return piece.element < element;
    }
    return piece.q < (piece.law == Law::parameter ? curved() : local);
  };
  auto found = std::lower_bound(pieces().begin(), pieces().end(), s, begins_before);
  if (found != pieces().begin()) {
    --found;
  }
  const auto piece = static_cast<std::size_t>(found - pieces().begin());
  const double q = found->law == Law::parameter ? curved() : s - path().s(found->element);
  return PartMotion(*this, PartWalk(*this, piece, time_in_piece(piece, q)).part()).state(0);
}

double Trajectory::time_in_piece(std::size_t index, double q) const {
  const Piece& piece = pieces()[index];
  const double duration = piece_end(index) - piece.time;
  if (piece.law == Law::filtered) {
    const double length = filtered_end(index) - piece.q;
    const double share = length > 0 ? std::clamp((q - piece.q) / length, 0.0, 1.0) : 0;
    FilterWalk filters;
    const double start = piece.time - motion_of(piece.element).start();
    return filtered_course(index, filters).time_at(share) - start;
  }
  const PiecePhases phases(piece, duration);
  double tau = 0;
  for (int phase = 0; phase < phases.count(); ++phase) {
    tau = phases.begin(phase) +
          time_to_reach(phases.at_begin(phase), q, phases.end(phase) - phases.begin(phase));
    if (tau < phases.end(phase)) {
      break;
    }
  }
  return std::min(tau, duration);
}

PartWalk Trajectory::walk_from(std::uint32_t element) const {
  const auto at_or_after =
      std::lower_bound(pieces().begin(), pieces().end(), element,
                       [](const Piece& piece, std::uint32_t e) { return piece.element < e; });
  const auto piece = static_cast<std::size_t>(at_or_after - pieces().begin());
  const bool begins_with_it =
      at_or_after != pieces().end() && at_or_after->element == element && (at_or_after->q <= 0 || piece == 0);
  if (begins_with_it || piece == 0) {
    return PartWalk(*this, piece);
  }
  const std::uint32_t first = pieces()[piece - 1].element;
  return PartWalk(*this, piece - 1, time_in_piece(piece - 1, path().s(element) - path().s(first)));
}

double Trajectory::time_of_line(std::uint32_t line) const {
  std::uint32_t best = 0;
  std::uint32_t nearest = std::numeric_limits<std::uint32_t>::max();
  for (std::uint32_t i = 0; i < path().size(); ++i) {
    const std::uint32_t here = line_of(i);
    if (here >= line && here < nearest) {
      best = i;
      nearest = here;
    }
  }
  if (nearest == std::numeric_limits<std::uint32_t>::max()) {
    return duration();
  }
  const PartWalk walk = walk_from(best);
  return walk.done() ? duration() : walk.part().time;
}

int Trajectory::filtered_spans(const Part& part, double a_filter_time) const {
  const FilteredMotion& motion = motion_of(part.element);
  const double start = part.time - motion.start();
  if (motion.is_settled(start, start + part.duration)) {
    return 1;
  }
  constexpr double most = 1e6;
  return static_cast<int>(
      std::ceil(std::clamp(part.duration / motion.filter_time() * a_filter_time, 1.0, most)));
}

double Trajectory::filtered_end(std::size_t piece) const {
  const std::uint32_t element = pieces()[piece].element;
  const std::size_t next = piece + 1;
  const bool ends_here = next == pieces().size() || pieces()[next].element != element;
  return ends_here ? path().length(element) : pieces()[next].q;
}

SpanCourse Trajectory::filtered_course(std::size_t piece, FilterWalk& filters) const {
  const FilteredMotion& motion = motion_of(pieces()[piece].element);
  const double start = pieces()[piece].time - motion.start();
  return {filters, motion.train(), start, start + (piece_end(piece) - pieces()[piece].time)};
}

double Trajectory::filtered_q(std::size_t piece, double tau, FilterWalk& filters) const {
  const Piece& at = pieces()[piece];
  const double start = at.time - motion_of(at.element).start();
  return at.q + (filtered_end(piece) - at.q) * filtered_course(piece, filters).share_at(start + tau);
}

double Trajectory::filtered_length(const Part& part) const {
  const Piece& piece = pieces()[part.piece];
  const bool whole = part.time == piece.time && part.duration == piece_end(part.piece) - piece.time;
  FilterWalk filters;
  const double end = whole ? filtered_end(part.piece)
                           : filtered_q(part.piece, part.time - piece.time + part.duration, filters);
  return end - part.q;
}

std::size_t Trajectory::blend_count() const {
  return path().corner_count() + content_.filtered_corners.size() + path().rounded_count();
}

BlendRecord Trajectory::blend(std::size_t i) const {
  FilterWalk filters;
  return blend(i, filters);
}

BlendRecord Trajectory::blend(std::size_t i, FilterWalk& filters) const {
  if (!content_.filtered_corners.empty()) {
    const std::uint32_t before = content_.filtered_corners[i];
    const PulseTrain& train = motion_of(before).train();
    BlendRecord rounded = filtered_corner(filters, train, path().base_segment_of(before) + 1 - train.first);
    rounded.element = before;
    return rounded;
  }
  const bool own = path().rounded_count() > 0;
  const BlendRecord record = own ? rounded_corner(path(), path().rounded(i)) : laid_corner(path(), i);
  return with_speeds(record, own ? path().rounded(i).last : record.element);
}

BlendRecord Trajectory::with_speeds(BlendRecord record, std::uint32_t last_element) const {
  PartWalk walk = walk_from(record.element);
  if (walk.done()) {
    return record;
  }
  record.entry_speed = PartMotion(*this, walk.part()).kinematics(0).velocity.norm();
  Part last = walk.part();
  for (; !walk.done() && walk.part().element <= last_element; walk.next()) {
    last = walk.part();
  }
  record.exit_speed = PartMotion(*this, last).kinematics(last.duration).velocity.norm();
  return record;
}

}  // namespace feedscope
