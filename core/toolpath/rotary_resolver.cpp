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

namespace feedscope {
namespace {

constexpr double same_angle = 1e-9;  // [rad]

std::size_t place_of(char axis) {
  return rotary_names.find(axis);
}

class RotaryResolver {
 public:
  RotaryResolver(const Toolpath& path, const Machine& machine, const Settings& settings)
      : from_(path), machine_(machine), chain_(chain_of(machine.kinematics)), path_(path) {
    for (const std::size_t axis : chain_.rotary()) {
      axes_.push_back(machine.kinematics.find(chain_.axes()[axis].name));
    }
    bool placed = machine.kinematics.tool_length.has_value();
    for (int axis = 0; axis < 3; ++axis) {
      const std::string key = fmt::format("part_zero_{}_mm", "xyz"[axis]);
      placed = placed && settings.has(key);
      part_zero_[axis] = settings.has(key) ? settings.number(key) : 0;
    }
    tip_follows_ = placed;
  }

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
        set_limits(turn, move.at_tip);
        turn.tilt = tilt_of(turn);
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

  /// Largest derivatives of an axis by the path.
  struct AxisCourse {
    double first = 0, second = 0, third = 0;
    double velocity = 0, acceleration = 0, jerk = 0;  // its limits
  };

  /// With the derivatives q1, q2, q3 by the path: v q1 <= V, v^2 q2 <= s A, v^3 q3 <= s J. The share 1 - s
  /// and what is not used is for ramps.
  void set_limits(SegmentTurn& turn, bool at_tip) {
    constexpr double share = 0.75;  // as turning_share of limits/segment_limits.h
    std::array<AxisCourse, 6> axes;
    for (const RotaryAxis* axis : axes_) {
      const std::size_t place = place_of(axis->name);
      const double slope = std::abs(turn.to[place] - turn.from[place]) / from_.segments[turn.segment].length;
      axes[3 + place] = {slope, 0, 0, axis->velocity, axis->acceleration, axis->jerk};
    }
    if (at_tip && tip_follows_) {
      add_linear(turn, axes);
    } else if (at_tip && !std::exchange(tip_reported_, true)) {
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
    turn.speed = turn.acceleration = turn.jerk = HUGE_VAL;
    for (std::size_t i = 0; i < axes.size(); ++i) {
      const AxisCourse& axis = axes[i];
      const auto lower = [&](double value, std::uint8_t order) {
        if (value < turn.speed) {
          turn.speed = value;
          turn.speed_order = order;
          turn.speed_slope = order == 1 ? axis.first : order == 2 ? axis.second : axis.third;
          turn.speed_axis = static_cast<std::int8_t>(i);
        }
      };
      if (axis.first > 0) {
        lower(axis.velocity / axis.first, 1);
      }
      if (axis.second > 0) {
        lower(std::sqrt(share * axis.acceleration / axis.second), 2);
      }
      if (axis.third > 0) {
        lower(std::cbrt(share * axis.jerk / axis.third), 3);
      }
    }
    const double v = turn.speed;
    for (std::size_t i = 0; i < axes.size(); ++i) {
      const AxisCourse& axis = axes[i];
      if (!(axis.first > 0)) {
        continue;
      }
      const double acceleration = (axis.acceleration - v * v * axis.second) / axis.first;
      const double jerk = (axis.jerk - v * v * v * axis.third) / axis.first;
      if (acceleration < turn.acceleration) {
        turn.acceleration = acceleration;
        turn.acceleration_axis = static_cast<std::int8_t>(i);
      }
      if (jerk < turn.jerk) {
        turn.jerk = jerk;
        turn.jerk_axis = static_cast<std::int8_t>(i);
      }
    }
  }

  /// Of the tool to the first rotary axis in the middle of a turn [rad]; -1 where there is only one.
  double tilt_of(const SegmentTurn& turn) const {
    if (axes_.size() != 2) {
      return -1;
    }
    std::vector<double> places(chain_.size(), 0);
    for (const std::size_t k : chain_.rotary()) {
      const std::size_t place = place_of(chain_.axes()[k].name);
      places[k] = (turn.from[place] + turn.to[place]) / 2;
    }
    const double along =
        std::abs(chain_.pose(places, 0).direction.dot(chain_.axes()[chain_.rotary()[0]].direction));
    return std::acos(std::min(1.0, along));
  }

  /// X, Y and Z while the tip runs along the segment and the rotary axes turn.
  void add_linear(const SegmentTurn& turn, std::array<AxisCourse, 6>& axes) const {
    constexpr int places = 5;
    const Segment& segment = from_.segments[turn.segment];
    for (int i = 0; i < places; ++i) {
      const double along = i / (places - 1.0);
      CurvePoint at;
      if (segment.kind == SegmentKind::arc) {
        at = from_.arc_of(segment).at(along * segment.length);
      } else {
        const Vec3 start = from_.start_of(turn.segment);
        at.d1 = (segment.end - start) / segment.length;
        at.position = start + along * segment.length * at.d1;
        at.d2 = at.d3 = Vec3::Zero();
      }
      std::array<Series, 3> tip;
      for (int j = 0; j < 3; ++j) {
        tip[static_cast<std::size_t>(j)] = {at.position[j] + part_zero_[j], at.d1[j], at.d2[j], at.d3[j]};
      }
      std::vector<Series> angles;
      for (const RotaryAxis* axis : axes_) {
        const std::size_t place = place_of(axis->name);
        const double way = turn.to[place] - turn.from[place];
        angles.emplace_back(turn.from[place] + along * way, way / segment.length, 0, 0);
      }
      const std::vector<Series> courses = chain_.courses(tip, angles, *machine_.kinematics.tool_length);
      for (const std::size_t k : chain_.linear()) {
        const auto j = static_cast<std::size_t>(chain_.axes()[k].name - 'X');
        const AxisLimits& limit = *machine_.axes.find(chain_.axes()[k].name);
        AxisCourse& axis = axes[j];
        axis = {std::max(axis.first, std::abs(courses[k].d1())),
                std::max(axis.second, std::abs(courses[k].d2())),
                std::max(axis.third, std::abs(courses[k].d3())),
                limit.velocity,
                limit.acceleration,
                limit.jerk};
      }
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
  std::vector<const RotaryAxis*> axes_;  ///< in the order of the chain
  std::array<double, 3> at_{};           ///< [rad]
  std::vector<SegmentTurn> along_;       ///< by segment of from_
  std::size_t next_along_ = 0;
  std::map<std::size_t, double> feeds_;  ///< of segments of from_, along their own length [mm/s]
  Vec3 part_zero_;                       ///< [mm]
  bool tip_follows_ = false;             ///< tool length and part zero are known
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
