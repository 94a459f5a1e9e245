#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numeric>

#include "core/limits/axis_share.h"
#include "tests/contract/checks.h"

namespace feedscope::contract {
namespace {

constexpr double met = 1e-9;        ///< a programmed point is met [mm]
constexpr double clock = 4e-16;     ///< rounding of a time, per s
constexpr double rest = 1e-3;       ///< speed that rounding of lengths leaves at a standstill [mm/s]
constexpr double rounding = 1e-14;  ///< of a coordinate, per mm of its size

std::string place_text(const Motion& motion, const Part& part) {
  return fmt::format("part {} at {} s, line {}", part.number, part.time, motion.run().line_of(part.element));
}

/// What rounding of coordinates and of the time leaves open of a position of the part [mm].
double open_position(const Motion& motion, const Part& part, double speed) {
  return rounding * motion.size(part) + clock * (part.time + part.duration) * speed;
}

}  // namespace

Result check_time(const Motion& motion) {
  double end = 0;
  for (const Part& part : motion.parts()) {
    if (!(part.duration > 0) || !std::isfinite(part.duration) || part.time != end) {
      return Finding{"time", fmt::format("{} lasts {} s", place_text(motion, part), part.duration)};
    }
    end = part.number + 1 < motion.parts().size() ? motion.parts()[part.number + 1].time : part.time;
  }
  const double duration = motion.run().duration();
  const double last =
      motion.parts().empty() ? 0 : motion.parts().back().time + motion.parts().back().duration;
  if (!std::isfinite(duration) || std::abs(last - duration) > 1e-12 * duration ||
      (duration > 0) == motion.toolpath().segments.empty()) {
    return Finding{"time", fmt::format("cycle time {} s, end of the last part {} s", duration, last)};
  }
  return {};
}

Result check_finite(const Motion& motion) {
  for (const Part& part : motion.parts()) {
    for (const double share : {0.0, 0.5, 1.0}) {
      const State s = motion.at(part, share);
      const double sum = s.position.sum() + s.velocity.sum() + s.acceleration.sum() + s.jerk.sum() + s.speed +
                         s.path_length + s.tangential_acceleration + s.tangential_jerk;
      if (!std::isfinite(sum)) {
        return Finding{"finite", fmt::format("{}, at {} of it", place_text(motion, part), share)};
      }
    }
  }
  return {};
}

Result check_summary(const Motion& motion, const Machine& machine) {
  const Summary summary =
      summarise(motion.run(), motion.toolpath(), axis_limit_vector(machine, &AxisLimits::velocity));
  double sum = 0;
  for (const double seconds : summary.time_by_cause) {
    if (!(seconds >= 0)) {
      return Finding{"summary", fmt::format("a cause lasts {} s", seconds)};
    }
    sum += seconds;
  }
  if (!(std::abs(sum - summary.cycle_time) <= 1e-12 * summary.cycle_time)) {
    return Finding{"summary", fmt::format("causes add up to {} s of {} s", sum, summary.cycle_time)};
  }
  double figures =
      summary.programmed_time + summary.mean_feed + summary.max_contour_error + summary.peak_feed;
  for (const AxisPeaks& axis : summary.axes) {
    figures += axis.velocity + axis.acceleration + axis.jerk;
  }
  if (!std::isfinite(figures)) {
    return Finding{"summary", "a figure is not finite"};
  }
  return {};
}

double open_by_rounding(const Motion& motion, const Guarantees& promised, const Machine& machine) {
  if (!promised.rounds_places) {
    return 0;
  }
  double size = motion.toolpath().start.cwiseAbs().maxCoeff();
  for (const Segment& segment : motion.toolpath().segments) {
    size = std::max(size, segment.end.cwiseAbs().maxCoeff());
  }
  double squares = 0;
  for (const AxisDrive& drive : machine.drives) {
    const double half = drive.steps_per_mm ? 0.5 / *drive.steps_per_mm : 0;
    squares += half * half;
  }
  constexpr double of_32_bits = 4e-7;
  return std::sqrt(squares) + of_32_bits * size;
}

Result check_ends(const Motion& motion, const Guarantees& promised, const Machine& machine) {
  const Toolpath& toolpath = motion.toolpath();
  if (toolpath.segments.empty()) {
    return {};
  }
  const State start = motion.run().state(0);
  const State end = motion.run().state_at_path(motion.run().path_length());
  const State last = motion.run().state(motion.run().duration());
  const Vec3& target = toolpath.segments.back().end;
  const double off_start = (start.position - toolpath.start).norm();
  const double off_end = std::max((end.position - target).norm(), (last.position - target).norm());
  const Part& final = motion.parts().back();
  const double rounded = open_by_rounding(motion, promised, machine);
  const double open = open_position(motion, final, motion.at(final, 0.9).speed) + rounded;
  if (!(off_start <= met + rounded) || !(off_end <= met + open)) {
    return Finding{"ends", fmt::format("begins {} mm, ends {} mm off", off_start, off_end)};
  }
  if (promised.continuity != Continuity::position && !(start.speed <= rest && last.speed <= rest)) {
    return Finding{"ends", fmt::format("begins at {} mm/s, ends at {} mm/s", start.speed, last.speed)};
  }
  return {};
}

Result check_continuity(const Motion& motion, const Guarantees& promised) {
  for (std::size_t i = 0; i + 1 < motion.parts().size(); ++i) {
    const State a = motion.at(motion.parts()[i], 1);
    const State b = motion.at(motion.parts()[i + 1], 0);
    const double gap = (a.position - b.position).norm();
    const double along = std::abs(a.path_length - b.path_length);
    const double open = open_position(motion, motion.parts()[i + 1], std::max(a.speed, b.speed));
    if (!(gap <= met + open) || !(along <= met + open + 4e-15 * a.path_length)) {
      return Finding{"continuity", fmt::format("{}: {} mm from the part before, {} mm along the path",
                                               place_text(motion, motion.parts()[i + 1]), gap, along)};
    }
    const double jump = std::abs(a.speed - b.speed);
    if (promised.continuity != Continuity::position && !(jump <= 1e-6 * (1 + a.speed))) {
      return Finding{"continuity", fmt::format("{}: speed jumps by {} mm/s from {} mm/s",
                                               place_text(motion, motion.parts()[i + 1]), jump, a.speed)};
    }
    const double turn = (a.velocity - b.velocity).norm();
    const double kick = (a.acceleration - b.acceleration).norm();
    const double jerk = std::max(a.jerk.norm(), b.jerk.norm());
    const Part& part = motion.parts()[i + 1];
    // Filters difference coordinates twice.
    const double scale = motion.memory(part) > 0 ? motion.time_scale(part) : 0;
    const double smoothed = scale > 0 ? 2 * motion.velocity_rounding(part) / scale +
                                            rounding * motion.size(part) / (scale * scale)
                                      : 0;
    if (promised.continuity == Continuity::acceleration &&
        !(turn <= 1e-6 * (1 + a.speed) &&
          kick <= 1e-5 * (1 + a.acceleration.norm()) + 1e-14 * a.time * jerk + smoothed)) {
      return Finding{"continuity", fmt::format("{}: velocity jumps by {} mm/s, acceleration by {} mm/s2",
                                               place_text(motion, motion.parts()[i + 1]), turn, kick)};
    }
  }
  return {};
}

namespace {

/// Central difference over `h`, and a bound for what is cut off: how far it is from the one over 2 h. Where
/// the third and the fifth derivative happen to take each other out there, the one over 4 h tells.
struct Difference {
  Vec3 value;
  double change;
};
template <typename F>
Difference difference(const std::array<State, 7>& s, double h, F of) {
  const Vec3 fine = (of(s[4]) - of(s[2])) / (2 * h);
  const Vec3 coarse = (of(s[5]) - of(s[1])) / (4 * h);
  const Vec3 coarsest = (of(s[6]) - of(s[0])) / (8 * h);
  return {fine, std::max((fine - coarse).norm(), (coarse - coarsest).norm() / 4)};
}

}  // namespace

namespace {

/// At `share` of the part, by differences over about `step` of its duration.
Result check_derivatives_at(const Motion& motion, const Part& part, double share, double step) {
  const double h = step * part.duration;
  static constexpr std::array<double, 7> places{-4, -2, -1, 0, 1, 2, 4};  // in steps
  std::array<State, 7> s;
  for (std::size_t i = 0; i < s.size(); ++i) {
    s[i] = motion.at(part, share + places[i] * step);
  }
  const State& at = s[3];
  // Rounding of the time counts as well: what it is off by is covered at the rate of the next derivative.
  const double late = clock * (part.time + part.duration);
  const auto wrong = [&](const char* name, const Difference& measured, const Vec3& given, double scale,
                         double rate) {
    const double off = (measured.value - given).norm();
    const double slack = 2 * measured.change + 1e-6 * given.norm() + (rounding * scale + late * rate) / h;
    return off <= slack
               ? Result()
               : Finding{"derivatives",
                         fmt::format("{}: {} is {}, off the difference quotient over {} s by {}, {} allowed",
                                     place_text(motion, part), name, given.norm(), h, off, slack)};
  };
  const auto velocity = difference(s, h, [](const State& x) { return x.position; });
  const auto acceleration = difference(s, h, [](const State& x) { return x.velocity; });
  const auto jerk = difference(s, h, [](const State& x) { return x.acceleration; });
  const double commanded = motion.commanded_speed(part);
  const double change = std::max(at.acceleration.norm(), commanded / motion.time_scale(part));
  const double smoothed = motion.velocity_rounding(part) / rounding;
  for (const Result& result :
       {wrong("velocity", velocity, at.velocity, motion.size(part), at.speed),
        wrong("acceleration", acceleration, at.acceleration, at.speed + smoothed, at.acceleration.norm()),
        wrong("jerk", jerk, at.jerk,
              change + smoothed / motion.time_scale(part) + at.speed * at.speed / motion.length(part),
              at.jerk.norm())}) {
    if (result) {
      return result;
    }
  }
  const double skew = rounding * motion.size(part) / motion.length(part);
  if (!(std::abs(at.velocity.norm() - std::abs(at.speed)) <= 1e-9 + skew * std::abs(at.speed))) {
    return Finding{"derivatives", fmt::format("{}: speed {} mm/s, velocity {} mm/s", place_text(motion, part),
                                              at.speed, at.velocity.norm())};
  }
  return {};
}

}  // namespace

Result check_derivatives(const Motion& motion) {
  constexpr double too_short = 1e-13;  // for a difference of states [s]
  for (const Part& part : motion.parts()) {
    if (part.place == Place::dwell || part.duration < too_short) {
      continue;
    }
    // Where the law changes differences mean nothing: the longest stretch without a change is looked at.
    const std::vector<double> borders = motion.law_borders(part);
    std::size_t longest = 1;
    for (std::size_t i = 1; i < borders.size(); ++i) {
      if (borders[i] - borders[i - 1] > borders[longest] - borders[longest - 1]) {
        longest = i;
      }
    }
    const double from = borders[longest - 1];
    const double width = borders[longest] - from;
    const double most = motion.memory(part) > 0 ? 2e-4 * motion.time_scale(part) / part.duration : width;
    if (Result wrong =
            check_derivatives_at(motion, part, from + 0.43 * width, std::min(0.01 * width, most))) {
      return wrong;
    }
  }
  return {};
}

namespace {

/// Integral of the velocity over shares [low, high] of a part, halved until the halves agree [mm].
Vec3 way(const Motion& motion, const Part& part, double low, double high, double allowed, int depth) {
  static constexpr std::array<double, 3> nodes{-0.7745966692414834, 0, 0.7745966692414834};
  static constexpr std::array<double, 3> weights{5.0 / 18, 8.0 / 18, 5.0 / 18};
  const auto rule = [&](double from, double to) {
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < 3; ++i) {
      sum += weights[i] * motion.kinematics(part, (from + to) / 2 + (to - from) / 2 * nodes[i]).velocity;
    }
    return Vec3(sum * (to - from) * part.duration);
  };
  const double middle = (low + high) / 2;
  const Vec3 halves = rule(low, middle) + rule(middle, high);
  if (depth == 0 || (halves - rule(low, high)).norm() <= allowed) {
    return halves;
  }
  return way(motion, part, low, middle, allowed / 2, depth - 1) +
         way(motion, part, middle, high, allowed / 2, depth - 1);
}

}  // namespace

Result check_displacement(const Motion& motion, const Guarantees& promised, const Machine& machine) {
  if (motion.parts().empty()) {
    return {};
  }
  constexpr double allowed = 1e-10;  // a part [mm]
  Vec3 sum = motion.toolpath().start;
  double slack = met + 2 * open_by_rounding(motion, promised, machine);
  for (const Part& part : motion.parts()) {
    const std::vector<double> borders = motion.law_borders(part);
    const double turn = motion.turn_rate(part) * part.duration;
    Vec3 along = Vec3::Zero();
    for (std::size_t i = 1; i < borders.size(); ++i) {
      const double width = borders[i] - borders[i - 1];
      constexpr double max_pieces = 300;
      const double pieces = std::clamp(std::ceil(turn * width), 1.0, max_pieces);
      for (double piece = 0; piece < pieces; ++piece) {
        const double from = borders[i - 1] + piece / pieces * width;
        along += way(motion, part, from, from + width / pieces, allowed * width / pieces, 12);
      }
    }
    const State start = motion.at(part, 0);
    const State end = motion.at(part, 1);
    const double open = allowed + open_position(motion, part, std::max(start.speed, end.speed)) +
                        1e-13 * along.norm() +
                        motion.velocity_rounding(part) * (part.duration + motion.memory(part));
    const double off = (start.position + along - end.position).norm();
    if (!(off <= met + open)) {
      return Finding{"displacement",
                     fmt::format("{}: the velocity leads {} mm past its end", place_text(motion, part), off)};
    }
    sum += along;
    slack += 2 * open;
  }
  const double off = (sum - motion.toolpath().segments.back().end).norm();
  if (!(off <= slack)) {
    return Finding{"displacement", fmt::format("the velocity leads {} mm past the last point", off)};
  }
  return {};
}

Result check_path_lookup(const Motion& motion) {
  if (motion.parts().empty()) {
    return {};
  }
  const double length = motion.run().path_length();
  for (int i = 0; i <= 16; ++i) {
    const double s = length * i / 16;
    const State found = motion.run().state_at_path(s);
    const State again = motion.run().state(found.time);
    const double slack = 1e-8 + 4e-15 * s + 4 * clock * found.time * found.speed;
    if (!(std::abs(found.path_length - s) <= slack) || !((found.position - again.position).norm() <= slack)) {
      return Finding{"path-lookup",
                     fmt::format("state_at_path({}) is at {} mm, {} mm from state({})", s, found.path_length,
                                 (found.position - again.position).norm(), found.time)};
    }
  }
  return {};
}

}  // namespace feedscope::contract
