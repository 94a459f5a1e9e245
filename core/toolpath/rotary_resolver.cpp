#include "core/toolpath/rotary_resolver.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "core/base/units.h"
#include "core/kinematics/kinematic_chain.h"
#include "core/program/text/message_codes.h"
#include "core/toolpath/rotary_notes.h"
#include "core/toolpath/rotary_positions.h"
#include "core/toolpath/tip_swing.h"
#include "core/toolpath/turn_ceiling.h"
#include "core/toolpath/turn_course.h"
#include "core/toolpath/turn_limiter.h"

namespace feedscope {
namespace {

constexpr double same_angle = 1e-9;  // [rad]

/// The path with the part placed on the machine by the settings.
Toolpath placed(Toolpath path, const Machine& machine, const Settings& settings) {
  path.part = part_on_machine(machine, settings);
  return path;
}

class RotaryResolver {
 public:
  RotaryResolver(const Toolpath& path, const Machine& machine, const Settings& settings,
                 const Progress* progress)
      : from_(path),
        progress_(progress),
        machine_(machine),
        chain_(chain_of(machine.kinematics)),
        path_(placed(path, machine, settings)),
        positions_(machine, chain_, from_.rotary_moves, path_.part, faults_, notes_),
        limiter_(machine, chain_, settings, path_.part),
        axes_(limiter_.axes()) {}

  MachinePath run() {
    path_.segments.clear();
    path_.segments.reserve(from_.segments.size() + from_.rotary_moves.size());
    auto move = from_.rotary_moves.begin();
    for (std::size_t i = 0; i <= from_.segments.size(); ++i) {
      for (; move != from_.rotary_moves.end() && move->motion <= i; ++move) {
        stop_if_cancelled(progress_);
        const std::array<double, 3> before = positions_.at();
        RotaryTurn turn = turn_of(*move);
        const bool along = (move->with_feed || move->with_rapid) && turn_along(*move, i, before);
        if (!along && turn.time > 0) {
          swing(*move, turn);
          pause(turn, move->line);
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
      }
    }
    join_turns();
    notes_.report_singular();
    path_.rotary_moves.clear();
    std::erase_if(path_.other_axes, [&](const std::string& name) {
      return name.size() == 1 && machine_.kinematics.find(name[0]) != nullptr &&
             std::ranges::find(from_.cutting_axes, name) == from_.cutting_axes.end();
    });
    return {std::make_shared<const Toolpath>(std::move(path_)), std::move(faults_)};
  }

 private:
  /// Turns the axes along the segments of the block, which begin at `i` or shortly after; false if it has
  /// none.
  bool turn_along(const RotaryMove& move, std::size_t i, const std::array<double, 3>& before) {
    constexpr std::size_t held_back = 4;
    const auto is_of_block = [&](std::size_t k) {
      const Segment& segment = from_.segments[k];
      return segment.line == move.line && segment.kind != SegmentKind::dwell &&
             segment.rapid == move.with_rapid;
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
    const std::array<double, 3>& behind = positions_.at();
    double turned = 0;  // [deg]
    for (std::size_t k = 0; k < 3; ++k) {
      turned = std::hypot(turned, units::to_deg(behind[k] - before[k]));
    }
    SegmentTurn whole;
    whole.from = before;
    whole.to = behind;
    whole.great_circle = move.great_circle;
    if (!TurnCourse(chain_, whole, length).goes_on()) {
      whole.great_circle = false;
    }
    const TurnCourse course(chain_, whole, length);
    double done = 0;
    for (std::size_t k = first; k < last; ++k) {
      SegmentTurn turn = whole;
      turn.segment = k;
      turn.from = k == first ? before : course.angles(done);
      done += from_.segments[k].length;
      turn.to = k + 1 == last ? behind : course.angles(done);
      if (turn.from != turn.to) {
        turn.at_tip = move.at_tip;
        limiter_.set_limits(from_, turn);
        note_unknown_tip(turn.at_tip, from_.segments[k].line);
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

  /// Reports once that tool centre point control is on while the motion of the linear axes is unknown.
  void note_unknown_tip(bool at_tip, std::uint32_t line) {
    if (!at_tip || limiter_.knows_linear() || std::exchange(tip_reported_, true)) {
      return;
    }
    Diagnostic note;
    note.severity = Severity::warning;
    note.line = line;
    note.code = std::string(MessageCode("rotary-feed").text());
    note.message =
        NC_("core", "how X, Y and Z follow the rotary axes is not known without tool length and part zero");
    note.hint = NC_("core",
                    "where rotary axes turn, their own limits hold and those of X, Y and Z as without them; "
                    "give tool_length_mm and part_zero_x_mm, _y_mm, _z_mm");
    faults_.push_back(std::move(note));
  }

  /// Adds joints at both ends of every turn where the motion goes on, at a feed or as a rapid.
  void join_turns() {
    const auto go_on = [&](std::size_t i) {
      return i + 1 < path_.segments.size() && path_.segments[i].kind != SegmentKind::dwell &&
             path_.segments[i + 1].kind != SegmentKind::dwell &&
             path_.segments[i].rapid == path_.segments[i + 1].rapid;
    };
    struct Between {
      SegmentTurn* before;
      SegmentTurn* behind;
    };
    std::vector<TurnJoint>& joints = path_.turn_joints;
    std::vector<Between> between;
    const auto join = [&](std::size_t i, SegmentTurn* before, SegmentTurn* behind) {
      if (go_on(i)) {
        const TurnJoint joint = limiter_.join(path_, i, before, behind);
        if (joint.step != std::array<double, 3>{}) {
          joints.push_back(joint);
          between.push_back({before, behind});
        }
      }
    };
    SegmentTurn* before = nullptr;
    for (SegmentTurn& turn : path_.segment_turns) {
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
    const auto beside = [&](std::size_t k) {
      const bool follows = k > 0 && joints[k - 1].segment + 1 == joints[k].segment;
      const bool goes_on = k + 1 < joints.size() && joints[k].segment + 1 == joints[k + 1].segment;
      const auto rounds = [](const TurnJoint& joint) { return joint.stops ? nullptr : &joint; };
      return TurnLimiter::Neighbours{follows ? rounds(joints[k - 1]) : nullptr,
                                     goes_on ? rounds(joints[k + 1]) : nullptr};
    };
    // The best reach of a joint depends on its neighbours: it uses the final reach of the one before it and
    // the longest reach of the one after it.
    for (std::size_t k = 0; k < joints.size(); ++k) {
      stop_if_cancelled(progress_);
      limiter_.choose_reach(path_, between[k].before, between[k].behind, beside(k), joints[k]);
    }
    const auto set_limits = [&] {
      for (std::size_t k = 0; k < joints.size(); ++k) {
        stop_if_cancelled(progress_);
        limiter_.set_limit(path_, between[k].before, between[k].behind, beside(k), joints[k]);
      }
    };
    set_limits();
    bool some_stop = false;
    for (std::size_t k = 0; k < joints.size(); ++k) {
      stop_if_cancelled(progress_);
      joints[k].stops = !path_.segments[joints[k].segment].rapid &&  // rapids stop anyway
                        limiter_.stops(path_, between[k].before, between[k].behind, joints[k]);
      some_stop = some_stop || joints[k].stops;
    }
    if (some_stop) {  // the neighbours are rounded without it
      set_limits();
    }
    if (limiter_.is_bound()) {
      for (SegmentTurn& turn : path_.segment_turns) {
        stop_if_cancelled(progress_);
        limiter_.set_bound(path_, turn);
      }
      for (std::size_t k = 0; k < joints.size(); ++k) {
        stop_if_cancelled(progress_);
        limiter_.set_bound(path_, between[k].before, between[k].behind, joints[k]);
      }
    }
    path_.turn_ceiling = std::make_shared<const TurnCeiling>(machine_, chain_);
    path_.turn_ceiling->divide(path_, limiter_.is_bound(), progress_);
  }

  RotaryTurn turn_of(const RotaryMove& move) {
    RotaryTurn turn;
    turn.from = positions_.at();
    positions_.follow(move);
    turn.to = positions_.at();
    double way = 0;
    for (const RotaryAxis* axis : axes_) {
      const std::size_t place = rotary_place(axis->name);
      way = std::hypot(way, turn.to[place] - turn.from[place]);
    }
    if (way < same_angle) {
      return turn;
    }
    // Axes of one block that turn at a feed arrive together, each as fast as its share of the way allows.
    double least_velocity = HUGE_VAL;
    double least_acceleration = HUGE_VAL;
    double least_jerk = HUGE_VAL;
    double longest = 0;
    for (const RotaryAxis* axis : axes_) {
      const std::size_t place = rotary_place(axis->name);
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

  /// In a turn on its own under tool centre point control X, Y and Z keep the tip in place.
  void swing(const RotaryMove& move, RotaryTurn& turn) {
    turn.at_tip = move.at_tip;
    turn.great_circle = move.great_circle;
    note_unknown_tip(turn.at_tip, move.line);
    if (turn.at_tip && limiter_.knows_linear()) {
      const Vec3& tip = path_.segments.empty() ? path_.start : path_.segments.back().end;
      TipSwing(machine_, chain_, path_.part).set_law(tip, move.feed, move.time, turn);
    }
  }

  void pause(RotaryTurn turn, std::uint32_t line) {
    turn.segment = path_.segments.size();
    Segment segment;
    segment.kind = SegmentKind::dwell;
    segment.line = line;
    segment.end = path_.segments.empty() ? path_.start : path_.segments.back().end;
    segment.index = static_cast<std::int32_t>(path_.pauses.size());
    if (!path_.segments.empty()) {
      segment.path_control = path_.segments.back().path_control;
      segment.spindle = path_.segments.back().spindle;
    }
    path_.pauses.push_back(
        {turn.time, turn.law.way > 0 ? Pause::swing : Pause::indexing, true, 0, turn.axis});
    path_.segments.push_back(segment);
    path_.rotary_turns.push_back(turn);
  }

  const Toolpath& from_;
  const Progress* progress_;
  const Machine& machine_;
  KinematicChain chain_;
  Toolpath path_;
  std::vector<Diagnostic> faults_;
  RotaryNotes notes_{faults_};
  RotaryPositions positions_;
  TurnLimiter limiter_;
  const std::vector<const RotaryAxis*>& axes_;  ///< in the order of the chain
  std::vector<SegmentTurn> along_;              ///< by segment of from_
  std::size_t next_along_ = 0;
  std::map<std::size_t, double> feeds_;  ///< of segments of from_, along their own length [mm/s]
  bool tip_reported_ = false;
};

}  // namespace

MachinePath with_rotary_moves(std::shared_ptr<const Toolpath> path, const Machine& machine,
                              const Settings& settings, const Progress* progress) {
  if (machine.kinematics.empty() || path->rotary_moves.empty()) {
    return {std::move(path), {}};
  }
  return RotaryResolver(*path, machine, settings, progress).run();
}

}  // namespace feedscope
