#include "core/toolpath/turn_ceiling.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/units.h"
#include "core/toolpath/joint_shape.h"

namespace feedscope {
namespace {

constexpr std::size_t first_rotary_axis = coordinate_names.size();

/// Joint that rounds the turns at the end of `segment`; null for none, and for a jump of the slopes.
const TurnJoint* rounding_joint(const Toolpath& path, std::size_t segment) {
  const TurnJoint* joint = path.turn_joint(segment);
  return joint != nullptr && joint->before > 0 ? joint : nullptr;
}

/// Feed of a segment [mm/s]; infinite for a rapid.
double feed_of(const Segment& segment) {
  return segment.feed > 0 && !segment.rapid ? segment.feed : HUGE_VAL;
}

bool turns_at_tip(const Toolpath& path, std::size_t segment) {
  const SegmentTurn* turn = path.segment_turn(segment);
  return turn != nullptr && turn->at_tip;
}

/// Segments in which rotary axes turn or joints reach, in order.
std::vector<std::size_t> turning_segments(const Toolpath& path) {
  std::vector<std::size_t> segments;
  for (const SegmentTurn& turn : path.segment_turns) {
    segments.push_back(turn.segment);
  }
  for (const TurnJoint& joint : path.turn_joints) {
    segments.push_back(joint.segment);
    segments.push_back(joint.segment + 1);
  }
  std::ranges::sort(segments);
  const auto again = std::unique(segments.begin(), segments.end());
  segments.erase(again, segments.end());
  return segments;
}

}  // namespace

RoundedTurn::RoundedTurn(const KinematicChain& chain, const Toolpath& path, std::size_t segment)
    : chain_(chain), length_(path.segments[segment].length) {
  const std::size_t before = segment - 1;
  const std::size_t behind = segment + 1;
  at_tip_ = turns_at_tip(path, segment);
  if (segment > 0) {
    before_ = rounding_joint(path, before);
  }
  behind_ = rounding_joint(path, segment);
  if (const SegmentTurn* turn = path.segment_turn(segment)) {
    course_.emplace(chain, *turn, length_);
  } else if (before_ != nullptr && path.segment_turn(before) != nullptr) {
    kept_ = path.segment_turn(before)->to;
    at_tip_ = turns_at_tip(path, before);
  }
  if (!course_ && behind_ != nullptr && path.segment_turn(behind) != nullptr) {
    kept_ = path.segment_turn(behind)->from;
    at_tip_ = at_tip_ || turns_at_tip(path, behind);
  }
}

std::vector<double> RoundedTurn::borders() const {
  std::vector<double> places{0, length_};
  const auto add = [&](double at) {
    if (at > 0 && at < length_) {
      places.push_back(at);
    }
  };
  if (before_ != nullptr) {
    add(before_->behind);
  }
  if (behind_ != nullptr) {
    add(length_ - behind_->before);
  }
  if (course_) {
    add(course_->nearest_to_pole().value_or(0));
  }
  std::ranges::sort(places);
  return places;
}

std::vector<Series> RoundedTurn::programmed(double s) const {
  if (course_) {
    return course_->at(s);
  }
  std::vector<Series> angles;
  for (const std::size_t k : chain_.rotary()) {
    angles.emplace_back(kept_[rotary_place(chain_.axes()[k].name)]);
  }
  return angles;
}

std::vector<Series> RoundedTurn::with_joint(std::vector<Series> angles, const TurnJoint& joint,
                                            double away) const {
  for (std::size_t k = 0; k < angles.size(); ++k) {
    angles[k] += joint_turn(joint, rotary_place(chain_.axes()[chain_.rotary()[k]].name), away);
  }
  return angles;
}

TurnCeiling::TurnCeiling(const Machine& machine, KinematicChain chain)
    : chain_(std::move(chain)),
      none_(machine),
      none_of_bound_(machine, {.acceleration = 1, .jerk = HUGE_VAL}) {}

void TurnCeiling::add(const PartOnMachine& part, const CurvePoint& tip, const std::vector<Series>& angles,
                      bool at_tip, AxisCourses& courses) const {
  for (std::size_t k = 0; k < angles.size(); ++k) {
    courses.add(first_rotary_axis + rotary_place(chain_.axes()[chain_.rotary()[k]].name), angles[k]);
  }
  if (!at_tip || !part.known) {
    return;
  }
  const std::vector<Series> all = chain_.courses(tip_on_machine(part, tip), angles, part.tool_length);
  for (const std::size_t k : chain_.linear()) {
    courses.add(static_cast<std::size_t>(chain_.axes()[k].name - 'X'), all[k]);
  }
}

TurnCeiling::Look TurnCeiling::look(const Toolpath& path, const RoundedTurn& turn, std::size_t segment,
                                    double at) const {
  Look look{at, none_, none_, {}};
  const CurvePoint tip = path.place_on(segment, at);
  turn.for_courses(at, [&](const std::vector<Series>& angles) {
    add(path.part, tip, angles, turn.at_tip(), look.rounded);
  });
  const std::vector<Series> programmed = turn.programmed(at);
  for (const Series& angle : programmed) {
    look.angles.push_back(angle.value());
  }
  if (turn.is_programmed()) {
    add(path.part, tip, programmed, turn.at_tip(), look.programmed);
  }
  return look;
}

/// Cuts one segment into parts.
class TurnCeiling::Division {
 public:
  Division(const TurnCeiling& ceiling, const Toolpath& path, std::size_t segment, bool bound)
      : ceiling_(ceiling),
        path_(path),
        segment_(segment),
        turn_(ceiling.chain_, path, segment),
        bound_(bound) {
    feed_ = feed_of(path.segments[segment]);
  }

  std::vector<TurnPart> parts() {
    const std::vector<double> borders = turn_.borders();
    Look from = look(borders.front());
    for (std::size_t i = 1; i < borders.size(); ++i) {
      Look to = look(borders[i]);
      cut(from, to, 0);
      from = std::move(to);
    }
    return std::move(parts_);
  }

 private:
  Look look(double at) const { return ceiling_.look(path_, turn_, segment_, at); }

  void cut(const Look& from, const Look& to, int depth) {
    constexpr int deepest = 60;
    constexpr double small_doubt = 1.001;
    const Look middle = look((from.at + to.at) / 2);
    AxisCourses rounded = middle.rounded;
    AxisCourses programmed = middle.programmed;
    for (const Look* end : {&from, &to}) {
      rounded.add(end->rounded);
      programmed.add(end->programmed);
    }
    const double looked_at = std::min(rounded.speed_of_velocity().speed, feed_);
    rounded.reach_between((to.at - from.at) / 2);
    TurnLimit slowest = rounded.speed_of_velocity();
    lower(slowest, programmed.speed_of_bend());
    const double fastest = std::max({speed_at(from), speed_at(middle), speed_at(to)});
    const bool is_doubtful = looked_at > small_doubt * rounded.speed_of_velocity().speed;
    if (depth < deepest &&
        (is_doubtful || is_uneven(from, to, std::min(slowest.speed, feed_), std::min(fastest, feed_)))) {
      cut(from, middle, depth + 1);
      cut(middle, to, depth + 1);
      return;
    }
    take(to.at, slowest, rounded, programmed);
  }

  static double speed_at(const Look& look) {
    return std::min(look.rounded.speed_of_velocity().speed, look.programmed.speed_of_bend().speed);
  }

  static bool is_uneven(const Look& from, const Look& to, double slowest, double fastest) {
    constexpr double same_ceiling = 1.01;
    constexpr double most_turn = units::from_deg(15);
    constexpr double least_time = 0.004;  // in this time ramps hardly gain speed [s]
    double turned = 0;
    for (std::size_t k = 0; k < to.angles.size(); ++k) {
      turned += std::abs(to.angles[k] - from.angles[k]);
    }
    return turned > most_turn || (fastest > same_ceiling * slowest && to.at - from.at > least_time * slowest);
  }

  /// Joins parts that the feed alone limits.
  void take(double end, TurnLimit limit, const AxisCourses& rounded, const AxisCourses& programmed) {
    const bool by_feed = limit.speed >= feed_;
    TurnRamp ramp = programmed.ramp(std::min(limit.speed, feed_), 0);
    if (bound_) {
      AxisCourses courses = ceiling_.none_of_bound_;
      courses.add(programmed);
      limit = rounded.speed_of_velocity();
      lower(limit, courses.speed_of_bend());
      ramp = courses.ramp(0, 0);
    }
    if (by_feed && by_feed_) {
      parts_.back().end = end;
      lower(parts_.back().limit, limit);
      lower(parts_.back().ramp, ramp);
    } else {
      parts_.push_back({segment_, end, limit, ramp});
    }
    by_feed_ = by_feed;
  }

  const TurnCeiling& ceiling_;
  const Toolpath& path_;
  std::size_t segment_;
  RoundedTurn turn_;
  bool bound_;
  double feed_ = 0;  ///< infinite for a rapid [mm/s]
  std::vector<TurnPart> parts_;
  bool by_feed_ = false;  ///< it alone limits the last part
};

void TurnCeiling::divide(Toolpath& path, bool bound, const Progress* progress) const {
  path.turn_parts.clear();
  for (const std::size_t segment : turning_segments(path)) {
    stop_if_cancelled(progress);
    const std::vector<TurnPart> parts = Division(*this, path, segment, bound).parts();
    const auto turn =
        std::ranges::lower_bound(path.segment_turns, segment, std::less(), &SegmentTurn::segment);
    if (turn == path.segment_turns.end() || turn->segment != segment) {
      if (parts.size() > 1 || parts.front().limit.speed < HUGE_VAL) {
        path.turn_parts.insert(path.turn_parts.end(), parts.begin(), parts.end());
      }
      continue;
    }
    if (parts.size() == 1) {
      if (parts.front().limit.speed < feed_of(path.segments[segment])) {
        lower(turn->limit, parts.front().limit);
      }
      continue;
    }
    turn->limit = {};
    turn->ramp = {};
    for (const TurnPart& part : parts) {
      lower(turn->limit, part.limit);
      lower(turn->ramp, part.ramp);
      path.turn_parts.push_back(part);
    }
  }
}

TurnLimit TurnCeiling::on_corner(const Toolpath& path, std::size_t segment, double transition,
                                 const std::vector<CurvePoint>& tips, double length) const {
  const std::array<RoundedTurn, 2> turns{RoundedTurn(chain_, path, segment),
                                         RoundedTurn(chain_, path, segment + 1)};
  if (!turns[0].turns() && !turns[1].turns()) {
    return {};
  }
  AxisCourses courses = none_;
  const bool at_tip = turns[0].at_tip() || turns[1].at_tip();
  const double whole = path.segments[segment].length;
  const std::size_t middle = tips.size() / 2;
  for (std::size_t i = 0; i < tips.size(); ++i) {
    const double way = transition * (static_cast<double>(i) / static_cast<double>(middle) - 1);
    for (const std::size_t side : {0, 1}) {
      if ((side == 0 && i > middle) || (side == 1 && i < middle)) {
        continue;
      }
      const Series s(side == 0 ? whole + way : way, 2 * transition / length, 0, 0);
      turns[side].for_courses(s.value(), [&](std::vector<Series> angles) {
        for (Series& angle : angles) {
          angle = chained(angle, s);
        }
        add(path.part, tips[i], angles, at_tip, courses);
      });
    }
  }
  return courses.speed_of_velocity();
}

}  // namespace feedscope
