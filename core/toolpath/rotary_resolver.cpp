#include "core/toolpath/rotary_resolver.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "core/base/units.h"
#include "core/kinematics/kinematic_chain.h"
#include "core/program/text/message_codes.h"
#include "core/toolpath/rotary_notes.h"
#include "core/toolpath/turn_limiter.h"

namespace feedscope {
namespace {

constexpr double same_angle = 1e-9;  // [rad]

std::size_t place_of(char axis) {
  return rotary_names.find(axis);
}

class RotaryResolver {
 public:
  RotaryResolver(const Toolpath& path, const Machine& machine, const Settings& settings)
      : from_(path),
        machine_(machine),
        chain_(chain_of(machine.kinematics)),
        limiter_(machine, chain_, settings),
        axes_(limiter_.axes()),
        path_(path) {}

  std::shared_ptr<const Toolpath> run() {
    path_.segments.clear();
    path_.segments.reserve(from_.segments.size() + from_.rotary_moves.size());
    auto move = from_.rotary_moves.begin();
    for (std::size_t i = 0; i <= from_.segments.size(); ++i) {
      double waits = 0;
      RotaryTurn after{};
      for (; move != from_.rotary_moves.end() && move->motion <= i; ++move) {
        const std::array<double, 3> before = at_;
        RotaryTurn turn = turn_of(*move);
        if (move->with_feed && turn_along(*move, i, before)) {
          continue;
        }
        if (move->with_rapid && is_its_rapid(i, *move)) {
          if (turn.time > 0) {
            after = turn;
            waits = std::max(0.0, turn.time - rapid_time(i));
          }
        } else if (turn.time > 0) {
          pause(turn, turn.time, move->line);
        }
      }
      if (i < from_.segments.size()) {
        for (; next_along_ < along_.size() && along_[next_along_].segment == i; ++next_along_) {
          path_.segment_turns.push_back(along_[next_along_]);
          path_.segment_turns.back().segment = path_.segments.size();
        }
        path_.segments.push_back(from_.segments[i]);
        if (const auto feed = feeds_.find(i); feed != feeds_.end()) {
          path_.segments.back().feed = feed->second;
        }
        if (after.time > 0) {
          after.beside_rapid = true;
          pause(after, waits, from_.segments[i].line);
        }
      }
    }
    join_turns();
    notes_.report_singular();
    path_.rotary_moves.clear();
    std::erase_if(path_.other_axes, [&](const std::string& name) {
      return name.size() == 1 && machine_.kinematics.find(name[0]) != nullptr &&
             std::ranges::find(from_.cutting_axes, name) == from_.cutting_axes.end();
    });
    return std::make_shared<const Toolpath>(std::move(path_));
  }

 private:
  bool is_its_rapid(std::size_t i, const RotaryMove& move) const {
    return i < from_.segments.size() && from_.segments[i].line == move.line && from_.segments[i].rapid;
  }

  /// The angles go linearly along the segments of the block, the first of which is `i` or one soon after it;
  /// false if it has none.
  bool turn_along(const RotaryMove& move, std::size_t i, const std::array<double, 3>& before) {
    constexpr std::size_t held_back = 4;
    const auto is_of_block = [&](std::size_t k) {
      const Segment& segment = from_.segments[k];
      return segment.line == move.line && segment.kind != SegmentKind::dwell && !segment.rapid;
    };
    std::size_t first = i;
    while (first < from_.segments.size() && first < i + held_back && !is_of_block(first)) {
      ++first;
    }
    double length = 0;
    std::size_t last = first;
    for (; last < from_.segments.size() && is_of_block(last); ++last) {
      length += from_.segments[last].length;
    }
    if (!(length > 0)) {
      return false;
    }
    double turned = 0;  // [deg]
    for (std::size_t k = 0; k < 3; ++k) {
      turned = std::hypot(turned, units::to_deg(at_[k] - before[k]));
    }
    double done = 0;
    for (std::size_t k = first; k < last; ++k) {
      const auto angles_at = [&](double way) {
        std::array<double, 3> angles{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
          angles[axis] = before[axis] + way / length * (at_[axis] - before[axis]);
        }
        return angles;
      };
      SegmentTurn turn;
      turn.segment = k;
      turn.from = angles_at(done);
      done += from_.segments[k].length;
      turn.to = k + 1 == last ? at_ : angles_at(done);
      if (turn.from != turn.to) {
        turn.at_tip = move.at_tip;
        limiter_.set_limits(from_, turn);
        note_unknown_tip(turn);
        if (axes_.size() == 2) {
          notes_.add_singular(turn, from_.segments[turn.segment], *axes_.front());
        }
        along_.push_back(turn);
        if (move.per_degree > 0) {
          feeds_[k] = from_.segments[k].feed * length / std::hypot(length, turned * move.per_degree);
        }
      }
    }
    return true;
  }

  /// Once, where tool centre point control is on and it is not known how the linear axes follow.
  void note_unknown_tip(const SegmentTurn& turn) {
    if (!turn.at_tip || limiter_.knows_linear() || std::exchange(tip_reported_, true)) {
      return;
    }
    Diagnostic note;
    note.severity = Severity::info;
    note.line = from_.segments[turn.segment].line;
    note.code = std::string(MessageCode("rotary-feed").text());
    note.message = "how X, Y and Z follow the rotary axes is not known without tool length and part zero";
    note.hint =
        "where rotary axes turn, their own limits hold and those of X, Y and Z as without them; give "
        "tool_length_mm in [kinematics] and part_zero_x_mm, _y_mm, _z_mm";
    path_.machine_faults.push_back(std::move(note));
  }

  /// At both ends of every turn beside which the feed goes on.
  void join_turns() {
    const auto is_feed = [&](std::size_t i) {
      return i < path_.segments.size() && path_.segments[i].kind != SegmentKind::dwell &&
             !path_.segments[i].rapid;
    };
    const auto join = [&](std::size_t i, const SegmentTurn* before, const SegmentTurn* behind) {
      if (is_feed(i) && is_feed(i + 1)) {
        const TurnJoint joint = limiter_.joint(path_, i, before, behind);
        if (std::isfinite(joint.limit.speed)) {
          path_.turn_joints.push_back(joint);
        }
      }
    };
    const SegmentTurn* before = nullptr;
    for (const SegmentTurn& turn : path_.segment_turns) {
      const bool meets = before != nullptr && before->segment + 1 == turn.segment;
      if (before != nullptr && !meets) {
        join(before->segment, before, nullptr);
      }
      if (turn.segment > 0) {
        join(turn.segment - 1, meets ? before : nullptr, &turn);
      }
      before = &turn;
    }
    if (before != nullptr) {
      join(before->segment, before, nullptr);
    }
  }

  void fault(const RotaryMove& move, MessageCode code, std::string message, std::string hint) {
    Diagnostic diagnostic;
    diagnostic.severity = Severity::error;
    diagnostic.line = move.line;
    diagnostic.code = std::string(code.text());
    diagnostic.message = std::move(message);
    diagnostic.hint = std::move(hint);
    path_.machine_faults.push_back(std::move(diagnostic));
  }

  /// Angles after the move, by rotary_names.
  std::array<double, 3> targets_of(const RotaryMove& move) {
    std::array<double, 3> to = at_;
    if (!move.direction) {
      for (const RotaryAxis* axis : axes_) {
        const std::size_t place = place_of(axis->name);
        to[place] = move.to[place].value_or(to[place]);
        if (to[place] < axis->minimum.value_or(to[place]) - same_angle ||
            to[place] > axis->maximum.value_or(to[place]) + same_angle) {
          fault(move, "rotary-travel",
                fmt::format("axis {} goes to {:g} degrees, beyond its travel from {:g} to {:g}", axis->name,
                            units::to_deg(to[place]), units::to_deg(axis->minimum.value_or(-HUGE_VAL)),
                            units::to_deg(axis->maximum.value_or(HUGE_VAL))),
                "the time of the whole way is counted; a control refuses the block");
        }
      }
      return to;
    }
    std::vector<double> from;
    for (const RotaryAxis* axis : axes_) {
      from.push_back(at_[place_of(axis->name)]);
    }
    std::vector<RotaryPlaces> found = chain_.turn_to(*move.direction, from);
    if (found.empty()) {
      fault(move, "rotary-direction",
            fmt::format("no position of the rotary axes of machine '{}' gives the tool the direction {:.4g}, "
                        "{:.4g}, {:.4g} of {}",
                        machine_.id, move.direction->x(), move.direction->y(), move.direction->z(),
                        move.with_feed || move.with_rapid ? "the tool vector" : "the tilted plane"),
            "the rotary axes stay; tilt less, or choose another machine");
      return to;
    }
    if (move.with_feed) {
      notes_.add_unclear(move.line, found, from, *axes_.front());
    }
    const auto on_side = [&](const RotaryPlaces& places) {
      return move.side == 0 || move.side * places.angles.back() > -same_angle;
    };
    const auto asked = std::ranges::find_if(found, on_side);
    if (asked == found.end()) {
      fault(
          move, "rotary-direction",
          fmt::format("no position of the rotary axes with {} of axis {} gives the tool the direction of the "
                      "tilted plane within its travel",
                      move.side > 0 ? "a positive angle" : "a negative angle", axes_.back()->name),
          "the other position is used; ask for the other side");
    }
    const std::vector<double>& angles = asked == found.end() ? found.front().angles : asked->angles;
    for (std::size_t k = 0; k < angles.size(); ++k) {
      to[place_of(axes_[k]->name)] = angles[k];
    }
    return to;
  }

  RotaryTurn turn_of(const RotaryMove& move) {
    RotaryTurn turn;
    turn.from = at_;
    turn.to = targets_of(move);
    at_ = turn.to;
    double way = 0;
    for (const RotaryAxis* axis : axes_) {
      const std::size_t place = place_of(axis->name);
      way = std::hypot(way, turn.to[place] - turn.from[place]);
    }
    if (way < same_angle) {
      return turn;
    }
    // Axes of one block that turn at a feed arrive together: each as fast as its share of the way allows.
    double least_velocity = HUGE_VAL;
    double least_acceleration = HUGE_VAL;
    double least_jerk = HUGE_VAL;
    double longest = 0;
    for (const RotaryAxis* axis : axes_) {
      const std::size_t place = place_of(axis->name);
      const double share = std::abs(turn.to[place] - turn.from[place]) / way;
      if (share * way < same_angle) {
        continue;
      }
      const double alone = turning_time(*axis, share * way);
      if (alone > longest) {
        longest = alone;
        turn.axis = static_cast<std::int8_t>(coordinate_names.size() + place);
      }
      least_velocity = std::min(least_velocity, axis->velocity / share);
      least_acceleration = std::min(least_acceleration, axis->acceleration / share);
      least_jerk = std::min(least_jerk, axis->jerk / share);
    }
    const double feed = move.time > 0 ? way / move.time : move.feed;
    turn.feed = feed;
    turn.time = feed > 0
                    ? rest_to_rest_time(way, std::min(feed, least_velocity), least_acceleration, least_jerk)
                    : longest;
    return turn;
  }

  /// Of the rapid, a line, from rest to rest.
  double rapid_time(std::size_t i) const {
    const Segment& segment = from_.segments[i];
    const Vec3 way = segment.end - from_.start_of(i);
    double velocity = HUGE_VAL;
    double acceleration = HUGE_VAL;
    double jerk = HUGE_VAL;
    for (int j = 0; j < 3; ++j) {
      const double share = std::abs(way[j]) / segment.length;
      const AxisLimits* axis = machine_.axes.find(coordinate_names[static_cast<std::size_t>(j)]);
      if (share > 0 && axis != nullptr) {
        velocity = std::min(velocity, axis->velocity / share);
        acceleration = std::min(acceleration, axis->acceleration / share);
        jerk = std::min(jerk, axis->jerk / share);
      }
    }
    return segment.length > 0 ? rest_to_rest_time(segment.length, velocity, acceleration, jerk) : 0;
  }

  void pause(RotaryTurn turn, double time, std::uint32_t line) {
    turn.segment = path_.segments.size();
    if (time > 0) {
      Segment segment;
      segment.kind = SegmentKind::dwell;
      segment.line = line;
      segment.end = path_.segments.empty() ? path_.start : path_.segments.back().end;
      segment.index = static_cast<std::int32_t>(path_.pauses.size());
      if (!path_.segments.empty()) {
        segment.path_control = path_.segments.back().path_control;
        segment.spindle = path_.segments.back().spindle;
      }
      path_.pauses.push_back({time, Pause::indexing, true, 0, turn.axis});
      path_.segments.push_back(segment);
    }
    path_.rotary_turns.push_back(turn);
  }

  const Toolpath& from_;
  const Machine& machine_;
  KinematicChain chain_;
  TurnLimiter limiter_;
  const std::vector<const RotaryAxis*>& axes_;  ///< in the order of the chain
  std::array<double, 3> at_{};                  ///< [rad]
  std::vector<SegmentTurn> along_;              ///< by segment of from_
  std::size_t next_along_ = 0;
  std::map<std::size_t, double> feeds_;  ///< of segments of from_, along their own length [mm/s]
  bool tip_reported_ = false;
  Toolpath path_;
  RotaryNotes notes_{path_};
};

}  // namespace

std::shared_ptr<const Toolpath> with_rotary_moves(std::shared_ptr<const Toolpath> path,
                                                  const Machine& machine, const Settings& settings) {
  if (machine.kinematics.empty() || path->rotary_moves.empty()) {
    return path;
  }
  return RotaryResolver(*path, machine, settings).run();
}

}  // namespace feedscope
