#include "core/models/linuxcnc/linuxcnc_canon.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/limits/axis_share.h"
#include "core/limits/segment_limits.h"

namespace feedscope {
namespace {

constexpr std::size_t longest_chain = 101;

/// Least limit of the moving axes along a displacement of `length` [mm], and its axis.
AxisBound along(const Vec3& way, double length, const Vec3& limits) {
  constexpr double no_way = 1e-8;
  double time = 0;
  std::int8_t axis = -1;
  for (std::int8_t i = 0; i < 3; ++i) {
    const double part = std::abs(way[i]);
    if (part >= no_way && part / limits[i] > time) {
      time = part / limits[i];
      axis = i;
    }
  }
  return {time > 0 ? length / time : limits.minCoeff(), axis};
}

/// Angle from spoke `from` to `to` about `normal`, including the full turns of `sweep` [rad].
double angle_between(const Vec3& from, const Vec3& to, const Vec3& normal, double sweep) {
  constexpr double full_turn = 2 * std::numbers::pi;
  constexpr double least = 1e-12;
  const double angle = std::atan2(normal.dot(from.cross(to)), from.dot(to));
  const double whole = angle + full_turn * std::round((sweep - angle) / full_turn);
  return whole > least ? whole : whole + full_turn;
}

}  // namespace

LinuxCncCanon::LinuxCncCanon(const Toolpath& toolpath, const LinuxCncSettings& settings)
    : toolpath_(toolpath), settings_(settings), waits_(toolpath) {
  mode_ = mode_of_settings();
}

LinuxCncCanon::Mode LinuxCncCanon::mode_of_settings() const {
  switch (settings_.path_mode) {
    case LinuxCncPathMode::exact_path:
      return {LinuxCncEnd::exact, 0, 0};
    case LinuxCncPathMode::exact_stop:
      return {LinuxCncEnd::stop, 0, 0};
    case LinuxCncPathMode::blend:
      break;
  }
  return {LinuxCncEnd::parabolic, settings_.blend_tolerance, settings_.naive_tolerance};
}

LinuxCncCanon::Mode LinuxCncCanon::mode_of(std::size_t block) const {
  const PathControl& control = toolpath_.path_control_of(block);
  switch (control.mode) {
    case PathMode::exact_stop:
      return {control.exact_path ? LinuxCncEnd::exact : LinuxCncEnd::stop, 0, 0};
    case PathMode::continuous: {
      const double tolerance =
          settings_.follows_program ? control.contour_tolerance.value_or(0) : settings_.blend_tolerance;
      const double naive = !settings_.follows_program && settings_.own_naive_tolerance
                               ? settings_.naive_tolerance
                               : control.compaction_tolerance.value_or(tolerance);
      return {LinuxCncEnd::parabolic, tolerance, naive};
    }
    case PathMode::machine:
      break;
  }
  return mode_of_settings();
}

void LinuxCncCanon::send(LinuxCncMessage::Kind kind, std::uint32_t block, double time) {
  LinuxCncMessage& message = sent_.emplace_back();
  message.kind = kind;
  message.block = block;
  message.time = time;
}

void LinuxCncCanon::enter_mode(const Mode& mode, std::uint32_t block) {
  if (mode == mode_) {
    return;
  }
  flush();
  mode_ = mode;
  send(LinuxCncMessage::Kind::mode, block);
}

std::optional<LinuxCncMessage> LinuxCncCanon::next() {
  while (sent_.empty() && block_ < toolpath_.segments.size()) {
    read_block(block_++);
    if (block_ == toolpath_.segments.size()) {
      flush();
    }
  }
  if (sent_.empty()) {
    return std::nullopt;
  }
  std::optional<LinuxCncMessage> first(std::move(sent_.front()));
  sent_.pop_front();
  return first;
}

void LinuxCncCanon::read_block(std::size_t i) {
  const auto block = static_cast<std::uint32_t>(i);
  const LinuxCncWaits::Found found = waits_.before(i);
  if (found.count > 0) {
    flush();
    for (int k = 0; k < found.count; ++k) {
      send(LinuxCncMessage::Kind::wait, block);
    }
    spindle_starts_ = spindle_starts_ || found.spindle_starts;
  }
  const Segment& segment = toolpath_.segments[i];
  if (segment.kind != SegmentKind::dwell) {
    enter_mode(mode_of(i), block);
  }
  switch (segment.kind) {
    case SegmentKind::line:
      line(i);
      break;
    case SegmentKind::arc:
      arc(i);
      break;
    case SegmentKind::dwell: {
      flush();
      const double time = toolpath_.dwell_of(segment);
      const bool is_dwell = toolpath_.pause_of(segment).kind == Pause::dwell;
      send(is_dwell || time > 0 ? LinuxCncMessage::Kind::dwell : LinuxCncMessage::Kind::pause, block, time);
      break;
    }
  }
}

void LinuxCncCanon::line(std::size_t i) {
  const Segment& segment = toolpath_.segments[i];
  const auto block = static_cast<std::uint32_t>(i);
  if (segment.rapid || segment.feed == 0) {
    flush();
    send_line(toolpath_.start_of(i), segment.end, 0, true, block);
    return;
  }
  if (toolpath_.segment_turn(i) != nullptr) {  // its naive cam does not join blocks in which rotary axes turn
    flush();
    send_line(toolpath_.start_of(i), segment.end, segment.feed, false, block);
    return;
  }
  if (chain_.empty()) {
    chain_start_ = toolpath_.start_of(i);
  }
  collect(segment.end, block, segment.feed);
}

bool LinuxCncCanon::linkable(const Vec3& end) const {
  if (!mode_.blends() || !(mode_.naive > 0) || chain_.size() >= longest_chain || end == chain_start_) {
    return false;
  }
  const Vec3 way = end - chain_start_;
  const double square = way.squaredNorm();
  return std::ranges::all_of(chain_, [&](const Point& point) {
    const Vec3 to = point.place - chain_start_;
    const double share = std::clamp(to.dot(way) / square, 0.0, 1.0);
    return (to - share * way).norm() <= mode_.naive;
  });
}

/// Adds a point of a chain of lines, which continues or is sent and begins again.
void LinuxCncCanon::collect(const Vec3& end, std::uint32_t block, double feed) {
  if (!chain_.empty() && (feed != chain_feed_ || !linkable(end))) {
    const Vec3 start = chain_.back().place;
    flush();
    chain_start_ = start;
  }
  chain_feed_ = feed;
  chain_.push_back({end, block});
}

void LinuxCncCanon::flush() {
  if (chain_.empty()) {
    return;
  }
  send_line(chain_start_, chain_.back().place, chain_feed_, false, chain_.back().block);
  chain_start_ = chain_.back().place;
  chain_.clear();
}

void LinuxCncCanon::send_line(const Vec3& from, const Vec3& to, double feed, bool rapid,
                              std::uint32_t block) {
  LinuxCncMessage& message = sent_.emplace_back();
  message.block = block;
  LinuxCncSegment& move = message.move;
  move.course = LinuxCncCourse::line(from, to);
  move.block = block;
  move.rapid = rapid;
  AxisBound velocity = along(to - from, move.course.length, settings_.velocity);
  AxisBound acceleration = along(to - from, move.course.length, settings_.acceleration);
  lower_by_turn(block, move, velocity, acceleration);
  move.largest = velocity.value;
  move.acceleration = acceleration.value;
  move.acceleration_axis = acceleration.axis;
  const bool of_axis = rapid || feed == 0 || feed > move.largest;
  move.requested = of_axis ? move.largest : feed;
  move.speed_cause = !of_axis ? feed_cause(toolpath_.segments[block])
                              : Cause{rapid ? CauseKind::rapid : CauseKind::axis_velocity, velocity.axis};
  move.tolerance = mode_.tolerance;
  move.end = mode_.end;
  move.waits_for_spindle = spindle_starts_ && !rapid;
  spindle_starts_ = spindle_starts_ && rapid;
}

/// The control uses the longest time that any axis, linear or rotary, needs for its part of the block at its
/// velocity and at its acceleration. It ignores the motion of the joints that its kinematics derive.
void LinuxCncCanon::lower_by_turn(std::uint32_t block, LinuxCncSegment& move, AxisBound& velocity,
                                  AxisBound& acceleration) const {
  const SegmentTurn* turn = toolpath_.segment_turn(block);
  if (turn == nullptr) {
    return;
  }
  move.turns = true;
  for (std::size_t i = 0; i < rotary_names.size(); ++i) {
    const double slope = std::abs(turn->to[i] - turn->from[i]) / move.course.length;
    const auto axis = static_cast<std::int8_t>(*cause_axes.find(rotary_names[i]));
    if (slope > 0 && settings_.turn_velocity[i] / slope < velocity.value) {
      velocity = {settings_.turn_velocity[i] / slope, axis};
    }
    if (slope > 0 && settings_.turn_acceleration[i] / slope < acceleration.value) {
      acceleration = {settings_.turn_acceleration[i] / slope, axis};
    }
  }
}

void LinuxCncCanon::arc(std::size_t i) {
  const Segment& segment = toolpath_.segments[i];
  const auto block = static_cast<std::uint32_t>(i);
  const Arc& given = toolpath_.arc_of(segment);
  const Vec3& start = toolpath_.start_of(i);
  LinuxCncCourse course;
  course.is_arc = true;
  course.start = start;
  course.normal = given.x.cross(given.y);
  course.height = course.normal.dot(segment.end - start);
  const Vec3 center = toolpath_.programmed_center(segment);
  const auto spoke_to = [&](const Vec3& place) -> Vec3 {
    const Vec3 spoke = place - center;
    return spoke - course.normal.dot(spoke) * course.normal;
  };
  const Vec3 from = spoke_to(start);
  const Vec3 to = spoke_to(segment.end);
  course.radius = from.norm();
  course.spoke = from / course.radius;
  course.center = start - from;
  course.angle = angle_between(from, to, course.normal, given.sweep);
  course.spiral = to.norm() - course.radius;
  course.length = course.arc_length();
  constexpr double flat = 1e-9;
  const bool in_xy = std::abs(std::abs(course.normal.z()) - 1) < flat;
  if (in_xy && mode_.blends() && toolpath_.segment_turn(i) == nullptr &&
      course.radius * (1 - std::cos(course.angle / 2)) < mode_.naive) {
    if (chain_.empty()) {
      chain_start_ = start;
    }
    collect(course.at(course.length / 2), block, segment.feed);
    collect(segment.end, block, segment.feed);
    return;
  }
  flush();
  Eigen::Index third = 0;
  course.normal.cwiseAbs().maxCoeff(&third);
  const auto least = [&](const Vec3& limits) {
    return std::min(limits[(third + 1) % 3], limits[(third + 2) % 3]);
  };
  const double speed = least(settings_.velocity);
  const double acceleration = least(settings_.acceleration);
  const double smaller = std::min(course.radius, to.norm());
  const double slope = course.spiral / course.angle;
  const double effective = std::hypot(slope, smaller);
  const double in_plane = std::min(std::sqrt(acceleration * linuxcnc_across_share * effective), speed);
  const double turn = std::hypot(smaller * course.angle, course.spiral);
  const double length = std::hypot(turn, course.height);
  const Vec3 way = segment.end - start;
  const auto time = [&](const Vec3& limits) { return way.cwiseAbs().cwiseQuotient(limits).maxCoeff(); };
  LinuxCncMessage& message = sent_.emplace_back();
  message.block = block;
  LinuxCncSegment& move = message.move;
  move.course = course;
  move.block = block;
  AxisBound largest{length / std::max(time(settings_.velocity), turn / in_plane), -1};
  AxisBound along_arc{length / std::max(time(settings_.acceleration), turn / acceleration), -1};
  lower_by_turn(block, move, largest, along_arc);
  move.largest = largest.value;
  move.acceleration = along_arc.value;
  move.acceleration_axis = along_arc.axis;
  move.requested = std::min(segment.feed > 0 ? segment.feed : move.largest, move.largest);
  const bool turns_fast = in_plane < speed && turn / in_plane >= time(settings_.velocity);
  const bool by_rotary = largest.axis >= 0;
  move.speed_cause = segment.feed > 0 && segment.feed <= move.largest ? feed_cause(segment)
                     : turns_fast && !by_rotary                       ? Cause{CauseKind::radial_acceleration}
                                                : Cause{CauseKind::axis_velocity, largest.axis};
  move.tolerance = mode_.tolerance;
  move.end = mode_.end;
  move.waits_for_spindle = spindle_starts_;
  spindle_starts_ = false;
  chain_start_ = segment.end;
}

}  // namespace feedscope
