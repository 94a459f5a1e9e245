#include "core/program/path/other_axes.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/units.h"
#include "core/machine/rotary_axis.h"

namespace feedscope {

AxisBlock turning_alone(const PathWriter& path, double unit, bool rapid) {
  AxisBlock block;
  block.alone = true;
  if (rapid) {
    return block;
  }
  if (path.feed_mode() == FeedMode::inverse_time) {
    block.time = path.feed() > 0 ? 1 / path.feed() : 0;
  } else {
    block.feed = units::from_deg(path.feed_rate() / unit);
  }
  return block;
}

/// Rotary move of the current block, or a new one.
RotaryMove& OtherAxes::move_of_block() {
  std::vector<RotaryMove>& moves = program_.rotary_moves;
  const std::uint64_t block = lines_.block_count();
  if (moves.empty() || moves.back().block != block || moves.back().motion != program_.motions.size() ||
      moves.back().direction) {
    RotaryMove move;
    move.block = block;
    move.motion = program_.motions.size();
    move.line = lines_.shown_line();
    moves.push_back(move);
  }
  return moves.back();
}

void OtherAxes::report_feed(char axis, bool at_tip, std::uint32_t column) {
  // One kind for each axis: detail 0 to 255 are letters, and those at the tip follow.
  log_.add(
      at_tip ? Severity::info : Severity::warning, "rotary-feed", axis + (at_tip ? 256 : 0),
      lines_.place(column), [&] {
        return at_tip ? DiagnosticLog::Text{message(NC_("core",
                                                        "axis {} turns in feed motions of the tool's tip"),
                                                    axis),
                                            NC_("core",
                                                "its limits hold along each block and where blocks meet")}
                      : DiagnosticLog::Text{message(NC_("core",
                                                        "axis {} turns in a feed motion of X, Y and Z "
                                                        "without tool centre point control"),
                                                    axis),
                                            NC_("core",
                                                "X, Y and Z are shown as programmed, not as the tool moves "
                                                "on the part; the limits of the axis hold along each block")};
      });
}

void OtherAxes::note_turn(std::size_t axis, double target, AxisMotion motion, std::uint32_t column,
                          const AxisBlock& block) {
  constexpr double half = 180;
  double way = target - programmed_[axis];
  constexpr double turn = 2 * half;
  if (block.way == AxisBlock::Way::shortest) {
    way -= turn * std::round(way / turn);
  } else if (block.way == AxisBlock::Way::positive) {
    way -= turn * std::floor(way / turn);
  } else if (block.way == AxisBlock::Way::negative) {
    way -= turn * std::ceil(way / turn);
  } else if (std::abs(way) > half && options_.rotary_axes.find(rotary_names[axis]) != std::string::npos) {
    log_.add(Severity::info, "rotary-way", static_cast<int>(axis), lines_.place(column), [&] {
      return DiagnosticLog::Text{message(NC_("core", "axis {} turns by {:g} degrees, from {:g} to {:g}"),
                                         rotary_names[axis], way, programmed_[axis], target),
                                 NC_("core",
                                     "a control whose axis takes the shortest way turns less; its time is "
                                     "that of the way as written")};
    });
  }
  if (const std::vector<RotaryMove>& moves = program_.rotary_moves;
      !moves.empty() && moves.back().direction && moves.back().block == lines_.block_count() &&
      options_.rotary_axes.find(rotary_names[axis]) != std::string::npos) {
    log_.add(Severity::error, "rotary-direction", 3, lines_.place(column), [&] {
      return DiagnosticLog::Text{
          message(NC_("core", "the tool's direction and axis {} are given in one block"), rotary_names[axis]),
          NC_("core", "the direction is used; remove one of them")};
    });
    return;
  }
  RotaryMove& move = move_of_block();
  move.to[axis] = units::from_deg(at_[axis] + way);
  at_[axis] += way;
  programmed_[axis] = target;
  move.feed = block.feed;
  move.time = block.time;
  move.with_rapid = !block.alone && motion == AxisMotion::positions;
  move.with_feed = !block.alone && motion != AxisMotion::positions;
  move.at_tip = (move.with_feed || block.alone) && (block.at_tip || motion == AxisMotion::at_tip);
  move.great_circle = move.at_tip && block.great_circle;
  move.per_degree = move.at_tip ? 0 : block.per_degree;
}

void OtherAxes::turn_tool(const Vec3& direction, int side, double feed) {
  RotaryMove move;
  move.block = lines_.block_count();
  move.motion = program_.motions.size();
  move.line = lines_.shown_line();
  move.direction = direction.normalized();
  move.side = side;
  move.feed = feed;
  program_.rotary_moves.push_back(move);
}

void OtherAxes::orient_tool(const Vec3& direction, AxisMotion motion, std::uint32_t column,
                            const AxisBlock& block) {
  constexpr double same_direction = 1e-12;
  const std::vector<RotaryMove>& moves = program_.rotary_moves;
  if (!moves.empty() && moves.back().direction &&
      (*moves.back().direction - direction).squaredNorm() < same_direction * same_direction) {
    return;
  }
  turn_tool(direction, 0, block.feed);
  RotaryMove& move = program_.rotary_moves.back();
  move.time = block.time;
  move.with_rapid = !block.alone && motion == AxisMotion::positions;
  move.with_feed = !block.alone && motion != AxisMotion::positions;
  move.at_tip = (move.with_feed || block.alone) && (block.at_tip || motion == AxisMotion::at_tip);
  move.great_circle = move.at_tip && block.great_circle;
  if (!turns()) {
    this->move(orientation_axis, 0, motion, column, block);
  } else if (move.with_feed) {
    const bool circle = move.great_circle;
    log_.add(Severity::info, "rotary-feed", circle ? 3 : 2, lines_.place(column), [circle] {
      return DiagnosticLog::Text{NC_("core", "tool vectors turn the rotary axes"),
                                 circle ? NC_("core",
                                              "the tool goes along a great circle in each block, to the "
                                              "position that it leads to; rounded where blocks meet")
                                        : NC_("core",
                                              "to the nearer of two positions, the axes linearly along each "
                                              "block; rounded where blocks meet")};
    });
  }
}

void OtherAxes::turn_to_zero(double feed) {
  RotaryMove& move = move_of_block();
  move.to = {0, 0, 0};
  move.feed = feed;
  at_ = programmed_ = {};
}

Message OtherAxes::moves_text(std::string_view axis, double target, AxisMotion motion) {
  const bool with_feed = motion != AxisMotion::positions;
  if (axis == orientation_axis) {
    return with_feed ? NC_("core", "the tool turns in a feed move, which is not simulated")
                     : NC_("core", "the tool turns, which is not simulated");
  }
  return with_feed ? message(NC_("core", "axis {} moves to {} in a feed move, which is not simulated"), axis,
                             target)
                   : message(NC_("core", "axis {} moves to {}, which is not simulated"), axis, target);
}

void OtherAxes::move(std::string_view axis, double target, AxisMotion motion, std::uint32_t column,
                     const AxisBlock& block) {
  auto known =
      std::find_if(axes_.begin(), axes_.end(), [&](const Axis& other) { return other.name == axis; });
  if (known == axes_.end()) {
    program_.other_axes.emplace_back(axis);
    known = axes_.insert(known, {std::string(axis), {}});
  }
  const std::size_t rotary = axis.size() == 1 ? rotary_names.find(axis[0]) : std::string_view::npos;
  if (rotary != std::string_view::npos) {
    note_turn(rotary, target, motion, column, block);
    if (options_.rotary_axes.find(axis[0]) != std::string::npos) {
      if (motion != AxisMotion::positions && !block.alone) {
        report_feed(axis[0], block.at_tip || motion == AxisMotion::at_tip, column);
      }
      return;
    }
  } else if (std::vector<std::string>& cutting = program_.cutting_axes;
             std::find(cutting.begin(), cutting.end(), axis) == cutting.end()) {
    cutting.emplace_back(axis);
  }
  if (std::exchange(known->reported[static_cast<std::size_t>(motion)], true)) {
    return;
  }
  const Severity severity = motion == AxisMotion::cuts ? Severity::error : Severity::warning;
  const Translatable path =
      motion == AxisMotion::at_tip
          ? NC_("core", "X, Y and Z are those of the tool's tip and shown as programmed")
          : NC_("core", "X, Y and Z are shown as programmed");
  const int kind = static_cast<int>(motion) + 3 * static_cast<int>(known - axes_.begin());
  log_.add(severity, "unread-axis", kind, lines_.place(column), [&] {
    return DiagnosticLog::Text{
        moves_text(axis, target, motion),
        message(
            NC_("core",
                "{}; the time of this axis is not included, so the cycle time is too short; reported once"),
            path)};
  });
}

}  // namespace feedscope
