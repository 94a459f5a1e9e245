#include "core/program/sinumerik/drilling_cycle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/base/units.h"

namespace feedscope::sinumerik {

namespace {

constexpr std::size_t most_strokes = 1000;

/// Lead of metric coarse threads by their size, ISO 261 [mm].
constexpr auto metric_leads = std::to_array<std::pair<double, double>>(
    {{3, 0.5},  {4, 0.7},  {5, 0.8},  {6, 1},    {8, 1.25}, {10, 1.5}, {12, 1.75},
     {14, 2},   {16, 2},   {18, 2.5}, {20, 2.5}, {22, 2.5}, {24, 3},   {27, 3},
     {30, 3.5}, {33, 3.5}, {36, 4},   {39, 4},   {42, 4.5}, {45, 4.5}, {48, 5}});

/// PIT in the unit that _PITA says, or the lead of the thread of size MPIT [mm]; 0 if neither is given.
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
/// share of it if negative), but not shorter than `least`; the last two are equal.
std::vector<double> stroke_depths(double total, double first, double degression, double least) {
  std::vector<double> depths;
  double stroke = first > 0 ? std::min(first, total) : total;
  double depth = stroke;
  depths.push_back(depth);
  while (total - depth > 1e-9 && depths.size() < most_strokes) {
    const double shorter = degression < 0 ? stroke * -degression : stroke - degression;
    const double floor = least > 0 ? least : degression > 0 ? degression : 0;
    const double rest = total - depth;
    stroke = std::max(shorter, floor);
    if (!(stroke > 0) || rest < 2 * stroke || depths.size() + 2 >= most_strokes) {
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

}  // namespace

std::optional<DrillingCycle> DrillingCycle::make(int number, const Arguments& arguments, double mm) {
  DrillingCycle cycle(arguments);
  const auto number_of = [&](std::size_t place) { return number_at(arguments, place); };
  const auto set_axis = [&](std::size_t place) {
    const double axis = number_of(place);
    cycle.axis_ = axis == 1 ? 0 : axis == 2 ? 1 : 2;
  };
  switch (number) {
    case 87:
      cycle.drill(0);
      break;
    case 81:
    case 82:
    case 88:
      cycle.drill(number_of(5));
      break;
    case 86:
      cycle.drill(number_of(5));
      cycle.lift_off(number_of(7), number_of(8), number_of(9));
      break;
    case 83:
      set_axis(12);
      cycle.deep_hole(arguments);
      break;
    case 84: {
      set_axis(12);
      const bool strokes = number_of(15) > 0;  // 1 breaks chips, 2 clears them
      cycle.tap({.lead = lead_of(number_of(7), number_of(8), number_of(13), mm),
                 .speed = number_of(10) / 60,
                 .speed_back = number_of(11) / 60,
                 .dwell = number_of(5),
                 .stroke = strokes ? std::abs(number_of(16)) : 0,
                 .lift = number_of(15) == 1 ? std::abs(number_of(17)) : 0});
      break;
    }
    case 840:
      set_axis(11);
      cycle.tap({.lead = lead_of(number_of(9), number_of(10), number_of(12), mm), .dwell = number_of(5)});
      break;
    case 85:
      cycle.rapid(cycle.safe_);
      cycle.own_feed(cycle.bottom_, number_of(6));
      cycle.dwell(number_of(5));
      cycle.own_feed(cycle.safe_, number_of(7));
      break;
    case 89:
      cycle.rapid(cycle.safe_);
      cycle.feed(cycle.bottom_);
      cycle.dwell(number_of(5));
      cycle.feed(cycle.safe_);
      break;
    default:
      return std::nullopt;
  }
  cycle.rapid(cycle.retract_);
  return cycle;
}

DrillingCycle::DrillingCycle(const Arguments& arguments) {
  retract_ = number_at(arguments, 0);
  top_ = number_at(arguments, 1);
  const std::optional<double> absolute = given_at(arguments, 3);
  const double depth = std::abs(number_at(arguments, 4));
  const bool down = depth > 0 ? retract_ >= top_ : absolute.value_or(top_) <= top_;
  up_ = down ? 1 : -1;
  safe_ = top_ + up_ * std::abs(number_at(arguments, 2));
  bottom_ = depth > 0 ? top_ - up_ * depth : absolute.value_or(top_);
}

void DrillingCycle::own_feed(double height, double feed_value) {
  if (feed_value > 0) {
    add(DrillingStep::Kind::own_feed, height, feed_value);
  } else {
    feed(height);
  }
}

void DrillingCycle::dwell(double time) {
  if (time != 0) {
    add(DrillingStep::Kind::dwell, 0, time);
  }
}

void DrillingCycle::drill(double bottom_dwell) {
  rapid(safe_);
  feed(bottom_);
  dwell(bottom_dwell);
}

void DrillingCycle::deep_hole(const Arguments& arguments) {
  const double total = std::abs(top_ - bottom_);
  const std::optional<double> first_height = given_at(arguments, 5);
  const double first_depth = std::abs(number_at(arguments, 6));
  const double first = first_depth > 0 ? first_depth : first_height ? std::abs(top_ - *first_height) : total;
  const double share = number_at(arguments, 10) > 0 ? number_at(arguments, 10) : 1;
  const bool clears = number_at(arguments, 11) != 0;
  const double back = number_at(arguments, 14) > 0 ? number_at(arguments, 14) : 1;
  const std::vector<double> depths =
      stroke_depths(total, first, number_at(arguments, 7), number_at(arguments, 13));
  rapid(safe_);
  for (std::size_t i = 0; i < depths.size(); ++i) {
    feed(top_ - up_ * depths[i], i == 0 ? share : 1);
    dwell(i + 1 == depths.size() && number_at(arguments, 15) != 0 ? number_at(arguments, 15)
                                                                  : number_at(arguments, 8));
    if (i + 1 == depths.size()) {
      break;
    }
    if (clears) {
      // How far above the last depth the feed begins again: given, 0.6 mm, or a fiftieth of deep holes.
      constexpr double shallow = 30;
      const double given = number_at(arguments, 16);
      const double gap = given > 0 ? given : depths[i] <= shallow ? 0.6 : std::min(depths[i] / 50, 7.0);
      rapid(safe_);
      dwell(number_at(arguments, 9));
      rapid(top_ - up_ * std::max(0.0, depths[i] - gap));
    } else {
      feed(top_ - up_ * std::max(0.0, depths[i] - back));
    }
  }
}

void DrillingCycle::tap(const Tapping& tapping) {
  const double speed_back = tapping.speed_back > 0 ? tapping.speed_back : tapping.speed;
  const auto cut = [&](double height, double speed) {
    if (tapping.lead > 0) {
      add(DrillingStep::Kind::thread, height, tapping.lead, speed);
    } else {
      feed(height);
    }
  };
  rapid(safe_);
  const double total = std::abs(top_ - bottom_);
  double depth = tapping.stroke > 0 ? tapping.stroke : total;
  for (std::size_t strokes = 0; depth < total && strokes < most_strokes; ++strokes) {
    cut(top_ - up_ * depth, tapping.speed);
    cut(tapping.lift > 0 ? top_ - up_ * (depth - tapping.lift) : safe_, speed_back);
    depth += tapping.stroke;
  }
  cut(bottom_, tapping.speed);
  dwell(tapping.dwell);
  cut(safe_, speed_back);
}

/// The spindle stands: the edge leaves the wall by RPA, RPO and RPAP, and the hole beside its axis.
void DrillingCycle::lift_off(double first, double second, double up) {
  if (first == 0 && second == 0 && up == 0) {
    return;
  }
  rapid(bottom_ + up);
  steps_.back().aside = {first, second};
  rapid(safe_);
  steps_.back().aside = {first, second};
}

}  // namespace feedscope::sinumerik
