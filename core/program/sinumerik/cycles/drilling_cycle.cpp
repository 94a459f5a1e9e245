#include "core/program/sinumerik/cycles/drilling_cycle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "core/base/units.h"
#include "core/program/cycles/tapping.h"

namespace feedscope::sinumerik {

namespace {

constexpr std::size_t max_strokes = 1000;

/// Lead of metric coarse threads by their size, ISO 261 [mm].
constexpr auto metric_leads = std::to_array<std::pair<double, double>>(
    {{3, 0.5},  {4, 0.7},  {5, 0.8},  {6, 1},    {8, 1.25}, {10, 1.5}, {12, 1.75},
     {14, 2},   {16, 2},   {18, 2.5}, {20, 2.5}, {22, 2.5}, {24, 3},   {27, 3},
     {30, 3.5}, {33, 3.5}, {36, 4},   {39, 4},   {42, 4.5}, {45, 4.5}, {48, 5}});

/// PIT in the unit of _PITA, or the lead of the thread of size MPIT [mm]; 0 if neither is given.
double lead_of(double size, double lead, double unit, double mm) {
  if (lead != 0) {
    constexpr double inch = 25.4;
    const double length = std::abs(lead);
    switch (static_cast<int>(unit)) {
      case 1:
        return length;
      case 2:  // threads an inch
        return inch / length;
      case 3:
        return inch * length;
      case 4:  // module
        return units::pi * length;
      default:
        return mm * length;
    }
  }
  for (const auto& [known, its_lead] : metric_leads) {
    if (known == std::abs(size)) {
      return its_lead;
    }
  }
  return 0;
}

/// Depths of the strokes of CYCLE83, from the top. Each is shorter than the one before by `degression` (a
/// share of it if negative), but not below `least`; the last two are equal.
std::vector<double> stroke_depths(double total, double first, double degression, double least) {
  std::vector<double> depths;
  double stroke = first > 0 ? std::min(first, total) : total;
  double depth = stroke;
  depths.push_back(depth);
  while (total - depth > 1e-9 && depths.size() < max_strokes) {
    const double shorter = degression < 0 ? stroke * -degression : stroke - degression;
    const double floor = least > 0 ? least : degression > 0 ? degression : 0;
    const double rest = total - depth;
    stroke = std::max(shorter, floor);
    if (!(stroke > 0) || rest < 2 * stroke || depths.size() + 2 >= max_strokes) {
      if (stroke > 0 && stroke < rest) {
        depths.push_back(depth + rest / 2);
      }
      depths.push_back(total);
      break;
    }
    depth += stroke;
    depths.push_back(depth);
  }
  return depths;
}

class DrillingCycle {
 public:
  DrillingCycle(const Arguments& arguments, const DrillingPlace& place, int axis);

  /// Returns false if `number` is not that of a drilling cycle.
  bool add(int number);
  void end();
  const DrillPlan& plan() const { return plan_; }

 private:
  double number_of(std::size_t argument) const { return number_at(arguments_, argument); }
  void drill(double bottom_dwell);
  void deep_hole();
  struct Thread {
    double lead = 0;   ///< [mm]
    double speed = 0;  ///< [1/s]
    double speed_back = 0;
    double dwell = 0;
    double stroke = 0;  ///< between lifts; 0: in one go
    double lift = 0;    ///< 0: up to the safe height
  };
  void tap(const Thread& thread);
  void lift_off(double first, double second, double up);
  void rapid(double height) { plan_.rapid(place_.mm * height); }
  /// Feeds at the programmed feed times `share`.
  void feed(double height, double share = 1);
  void own_feed(double height, double feed);
  /// Waits for seconds; negative: revolutions.
  void dwell(double time);

  const Arguments& arguments_;
  const DrillingPlace& place_;
  double retract_ = 0;  ///< RTP
  double top_ = 0;      ///< RFP
  double safe_ = 0;     ///< RFP and SDIS
  double bottom_ = 0;   ///< DP, or from DPR
  double up_ = 1;       ///< direction out of the hole: 1 or -1
  Vec3 aside_ = Vec3::Zero();
  DrillPlan plan_;
};

DrillingCycle::DrillingCycle(const Arguments& arguments, const DrillingPlace& place, int axis)
    : arguments_(arguments), place_(place), plan_(axis, place.position[axis]) {
  retract_ = number_of(0);
  top_ = number_of(1);
  const std::optional<double> absolute = given_at(arguments, 3);
  const double depth = std::abs(number_of(4));
  const bool down = depth > 0 ? retract_ >= top_ : absolute.value_or(top_) <= top_;
  up_ = down ? 1 : -1;
  safe_ = top_ + up_ * std::abs(number_of(2));
  bottom_ = depth > 0 ? top_ - up_ * depth : absolute.value_or(top_);
}

bool DrillingCycle::add(int number) {
  switch (number) {
    case 87:
      drill(0);
      return true;
    case 81:
    case 82:
    case 88:
      drill(number_of(5));
      return true;
    case 86:
      drill(number_of(5));
      lift_off(number_of(7), number_of(8), number_of(9));
      return true;
    case 83:
      deep_hole();
      return true;
    case 84: {
      const bool strokes = number_of(15) > 0;  // 1 breaks chips, 2 clears them
      tap({.lead = lead_of(number_of(7), number_of(8), number_of(13), place_.mm),
           .speed = number_of(10) / 60,
           .speed_back = number_of(11) / 60,
           .dwell = number_of(5),
           .stroke = strokes ? std::abs(number_of(16)) : 0,
           .lift = number_of(15) == 1 ? std::abs(number_of(17)) : 0});
      return true;
    }
    case 840:
      tap({.lead = lead_of(number_of(9), number_of(10), number_of(12), place_.mm), .dwell = number_of(5)});
      return true;
    case 85:
      rapid(safe_);
      own_feed(bottom_, number_of(6));
      dwell(number_of(5));
      own_feed(safe_, number_of(7));
      return true;
    case 89:
      drill(number_of(5));
      feed(safe_);
      return true;
    default:
      return false;
  }
}

/// Goes to the retract height, above the hole.
void DrillingCycle::end() {
  Vec3 back = -aside_;
  back[plan_.axis()] = place_.mm * retract_ - plan_.level();
  plan_.shift(back);
}

void DrillingCycle::feed(double height, double share) {
  plan_.feed(place_.mm * height,
             share == 1 ? std::nullopt : std::optional(DrillFeed{share * place_.feed, place_.mode}));
}

void DrillingCycle::own_feed(double height, double feed_value) {
  if (feed_value > 0) {
    plan_.feed(place_.mm * height, DrillFeed{place_.feed_of(feed_value), place_.mode});
  } else {
    feed(height);
  }
}

void DrillingCycle::dwell(double time) {
  const double speed = place_.spindle_speed;
  plan_.dwell(time > 0 ? time : speed > 0 ? -time / speed : 0);
}

void DrillingCycle::drill(double bottom_dwell) {
  rapid(safe_);
  feed(bottom_);
  dwell(bottom_dwell);
}

void DrillingCycle::deep_hole() {
  const double total = std::abs(top_ - bottom_);
  const std::optional<double> first_height = given_at(arguments_, 5);
  const double first_depth = std::abs(number_of(6));
  const double first = first_depth > 0 ? first_depth : first_height ? std::abs(top_ - *first_height) : total;
  const double share = number_of(10) > 0 ? number_of(10) : 1;
  const bool clears = number_of(11) != 0;
  const double back = number_of(14) > 0 ? number_of(14) : 1;
  const std::vector<double> depths = stroke_depths(total, first, number_of(7), number_of(13));
  rapid(safe_);
  for (std::size_t i = 0; i < depths.size(); ++i) {
    feed(top_ - up_ * depths[i], i == 0 ? share : 1);
    dwell(i + 1 == depths.size() && number_of(15) != 0 ? number_of(15) : number_of(8));
    if (i + 1 == depths.size()) {
      break;
    }
    if (clears) {
      // Distance above the last depth at which the feed begins again: given, 0.6 mm, or a fiftieth of deep
      // holes.
      constexpr double shallow = 30;
      const double given = number_of(16);
      const double gap = given > 0 ? given : depths[i] <= shallow ? 0.6 : std::min(depths[i] / 50, 7.0);
      rapid(safe_);
      dwell(number_of(9));
      rapid(top_ - up_ * std::max(0.0, depths[i] - gap));
    } else {
      feed(top_ - up_ * std::max(0.0, depths[i] - back));
    }
  }
}

void DrillingCycle::tap(const Thread& thread) {
  const auto feed_at = [&](double speed) {
    return thread.lead > 0 ? std::optional(DrillFeed{thread.lead, FeedMode::per_revolution, speed})
                           : std::nullopt;
  };
  rapid(safe_);
  feedscope::tap({.safe = place_.mm * safe_,
                  .surface = place_.mm * top_,
                  .bottom = place_.mm * bottom_,
                  .stroke = place_.mm * thread.stroke,
                  .lift = place_.mm * thread.lift,
                  .dwell = thread.dwell,
                  .down = feed_at(thread.speed),
                  .back = feed_at(thread.speed_back > 0 ? thread.speed_back : thread.speed)},
                 plan_);
}

/// Moves the edge off the wall by RPA, RPO and RPAP while the spindle is at rest; it then leaves the hole off
/// its axis.
void DrillingCycle::lift_off(double first, double second, double up) {
  if (first == 0 && second == 0 && up == 0) {
    return;
  }
  aside_[first_axis(place_.plane)] = place_.mm * first;
  aside_[second_axis(place_.plane)] = place_.mm * second;
  Vec3 off = aside_;
  off[plan_.axis()] += place_.mm * up;
  plan_.shift(off);
  rapid(safe_);
}

/// Deep holes and threads may name another axis than the normal of the plane: 1 its first one, 2 its second.
int axis_of(int number, const Arguments& arguments, Plane plane) {
  const bool names_axis = number == 83 || number == 84 || number == 840;
  const double axis = names_axis ? number_at(arguments, number == 840 ? 11 : 12) : 0;
  return axis == 1 ? first_axis(plane) : axis == 2 ? second_axis(plane) : normal_axis(plane);
}

}  // namespace

std::optional<DrillPlan> drill_plan(int number, const Arguments& arguments, const DrillingPlace& place) {
  DrillingCycle cycle(arguments, place, axis_of(number, arguments, place.plane));
  if (!cycle.add(number)) {
    return std::nullopt;
  }
  cycle.end();
  return cycle.plan();
}

}  // namespace feedscope::sinumerik
