#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/units.h"
#include "core/blend/junction.h"
#include "tests/contract/checks.h"

namespace feedscope::contract {
namespace {

constexpr double rounding = 2e-6;  ///< of a limit, relative
constexpr double met = 1e-9;       ///< a programmed point is met [mm]
constexpr double rest = 1e-3;      ///< speed that rounding of lengths leaves at a standstill [mm/s]

/// One component of what an axis bears, and how many times the limit it may be.
struct Component {
  const char* name;
  Vec3 value;  ///< absolute, of each axis
  double factor;
};

/// What an axis bears by components.
struct AxisLoad {
  Vec3 whole;
  Vec3 parts_sum;  ///< of the two parts that are promised each for itself
  Vec3 along;
  Vec3 across;  ///< of a jerk: what turning takes along the path

  /// All that is promised; two parts that are kept each for itself keep twice the limit together.
  std::vector<Component> promised(const KeptLimit& kept) const {
    switch (kept.of) {
      case KeptLimit::Of::whole:
        return {{"", whole, kept.factor}};
      case KeptLimit::Of::parts:
        return {{" (first part)", along, kept.factor},
                {" (second part)", across, kept.factor},
                {" (both parts)", parts_sum, 2 * kept.factor}};
      case KeptLimit::Of::nothing:
        break;
    }
    return {};
  }
};

AxisLoad acceleration_load(const State& s) {
  const Vec3 along = s.speed > 0 ? Vec3(s.velocity / s.speed * s.tangential_acceleration) : s.acceleration;
  return {s.acceleration.cwiseAbs(), s.acceleration.cwiseAbs(), along.cwiseAbs(),
          (s.acceleration - along).cwiseAbs()};
}

AxisLoad jerk_load(const State& s) {
  if (!(s.speed > 0)) {
    return {s.jerk.cwiseAbs(), s.jerk.cwiseAbs(), s.jerk.cwiseAbs(), Vec3::Zero()};
  }
  const Vec3 tangent = s.velocity / s.speed;
  const double turning = (s.acceleration - tangent * s.tangential_acceleration).squaredNorm() / s.speed;
  const Vec3 along = tangent * s.jerk.dot(tangent);  // v'' - v^3 k^2
  return {s.jerk.cwiseAbs(), along.cwiseAbs(), (tangent * s.tangential_jerk).cwiseAbs(),
          (tangent * turning).cwiseAbs()};
}

Result broken_limit(const Motion& motion, const Part& part, const char* name, const Component& component,
                    const Machine& machine, double AxisLimits::*limit) {
  for (std::size_t j = 0; j < 3; ++j) {
    const double bound = component.factor * machine.axes[j].*limit;
    const double value = component.value[static_cast<Eigen::Index>(j)];
    if (!(value <= bound * (1 + rounding))) {
      static constexpr const char* places[]{"line", "arc", "blend", "curve", "dwell"};
      const char* place = places[static_cast<std::size_t>(part.place)];
      return Finding{
          fmt::format("{}-on-{}", name, place),
          fmt::format("part {} at {} s, line {}: {}{} of axis {} on a {} is {}, {} times the limit; "
                      "promised is {}",
                      part.number, part.time, motion.run().line_of(part.element), name, component.name,
                      coordinate_names[j], place, value, value / (machine.axes[j].*limit), component.factor)};
    }
  }
  return {};
}

const KeptLimits& limits_at(const Guarantees& promised, Place place) {
  switch (place) {
    case Place::line:
      return promised.lines;
    case Place::arc:
      return promised.arcs;
    case Place::curve:
      return promised.curves;
    case Place::blend:
    case Place::dwell:
      break;
  }
  return promised.blends;
}

}  // namespace

namespace {

/// Whether the program lets the acceleration along the path jump on a part.
bool acceleration_jumps(const Motion& motion, const Part& part) {
  const auto brisk = [&](std::size_t segment) {
    return motion.toolpath().path_control_of(segment).acceleration == AccelerationMode::brisk;
  };
  return brisk(part.segment) && (part.place != Place::blend || brisk(part.segment + 1));
}

}  // namespace

std::vector<Finding> check_limits(const Motion& motion, const Guarantees& promised, const Machine& machine) {
  std::map<std::string, Finding> broken;  // the first of every kind of place and limit
  for (const Part& part : motion.parts()) {
    if (part.place == Place::dwell) {
      continue;
    }
    const KeptLimits& kept = limits_at(promised, part.place);
    const bool jumps = promised.follows_brisk && acceleration_jumps(motion, part);
    const auto jerk =
        part.place == Place::blend && kept.of_blend_jerk ? &AxisLimits::blend_jerk : &AxisLimits::jerk;
    for (const double share : {0.0, 0.21, 0.5, 0.79, 1.0}) {
      const State s = motion.at(part, share);
      AxisLoad j = jerk_load(s);
      if (jumps) {
        j.along = Vec3::Zero();
        j.whole = j.parts_sum = j.across;
      }
      const auto look = [&](const char* name, const AxisLoad& load, const KeptLimit& limit,
                            double AxisLimits::*of_axis) {
        for (const Component& component : load.promised(limit)) {
          if (Result found = broken_limit(motion, part, name, component, machine, of_axis)) {
            broken.try_emplace(found->check, *found);
          }
        }
      };
      const Vec3 v = s.velocity.cwiseAbs();
      look("velocity", {v, v, v, v}, kept.velocity, &AxisLimits::velocity);
      look("acceleration", acceleration_load(s), kept.acceleration, &AxisLimits::acceleration);
      look("jerk", j, kept.jerk, jerk);
    }
  }
  std::vector<Finding> findings;
  for (const auto& [check, finding] : broken) {
    findings.push_back(finding);
  }
  return findings;
}

namespace {

/// Largest programmed feed of the elements between two standstills, for every part [mm/s].
std::vector<double> feeds_of_runs(const Motion& motion) {
  const std::vector<Part>& parts = motion.parts();
  std::vector<double> feeds(parts.size());
  for (std::size_t first = 0; first < parts.size();) {
    std::size_t last = first;
    double feed = 0;
    for (; last < parts.size(); ++last) {
      const std::uint32_t segment = parts[last].segment;
      const bool new_segment = last > first && segment != parts[last - 1].segment;
      if (new_segment && junction_kind(motion.toolpath(), segment) == JunctionKind::stop) {
        break;
      }
      feed = std::max(feed, motion.run().feed_of(parts[last].element));
    }
    std::fill(feeds.begin() + static_cast<std::ptrdiff_t>(first),
              feeds.begin() + static_cast<std::ptrdiff_t>(last), feed);
    first = last;
  }
  return feeds;
}

}  // namespace

Result check_feed(const Motion& motion, const Guarantees& promised) {
  if (promised.feed == Guarantees::unbounded) {
    return {};
  }
  const std::vector<double> of_run = promised.feed_of_run ? feeds_of_runs(motion) : std::vector<double>();
  for (const Part& part : motion.parts()) {
    if (!promised.rapids_of_axes && motion.run().is_rapid(part.element)) {
      continue;
    }
    const double programmed = promised.feed_of_run ? of_run[part.number] : motion.run().feed_of(part.element);
    for (const double share : {0.0, 0.5, 1.0}) {
      const double speed = motion.at(part, share).speed;
      if (!(speed <= programmed * promised.feed * (1 + rounding) + met)) {
        return Finding{
            "feed", fmt::format("part {} at {} s, line {}: {} mm/s, programmed {} mm/s, {} times that "
                                "is promised",
                                part.number, part.time, motion.run().line_of(part.element), speed, programmed,
                                promised.feed)};
      }
    }
  }
  return {};
}

namespace {

bool is_promised_stop(const Toolpath& toolpath, std::size_t i, const Guarantees& promised) {
  const Segment& before = toolpath.segments[i - 1];
  const Segment& after = toolpath.segments[i];
  if (before.kind == SegmentKind::dwell || after.kind == SegmentKind::dwell) {
    return promised.continuity != Continuity::position;
  }
  switch (junction_kind(toolpath, i)) {
    case JunctionKind::pass:
      return false;
    case JunctionKind::corner:
      return promised.stops_at_line_corners;
    case JunctionKind::arc_corner:
      return promised.stops_at_arc_corners;
    case JunctionKind::stop:
      break;
  }
  return before.rapid || after.rapid ? promised.stops_at_rapids : promised.stops_at_reversals;
}

/// Distance of the path from the end of segment i - 1, where segment i begins, less what rounding of the time
/// leaves open [mm].
double distance_at_border(const Motion& motion, std::size_t i) {
  const std::size_t part = motion.first_part_of(i);
  const double s =
      part < motion.parts().size() ? motion.element_start(motion.parts()[part]) : motion.run().path_length();
  const State there = motion.run().state_at_path(s);
  constexpr double clock = 4e-16;
  return (there.position - motion.toolpath().segments[i - 1].end).norm() - clock * there.time * there.speed;
}

}  // namespace

Result check_stops(const Motion& motion, const Guarantees& promised, const Machine& machine) {
  const Toolpath& toolpath = motion.toolpath();
  const double open = met + open_by_rounding(motion, promised, machine);
  for (std::size_t i = 1; i < toolpath.segments.size(); ++i) {
    if (!is_promised_stop(toolpath, i, promised)) {
      continue;
    }
    const std::size_t next = motion.first_part_of(i);
    const double before = next > 0 ? motion.at(motion.parts()[next - 1], 1).speed : 0;
    const double after = next < motion.parts().size() ? motion.at(motion.parts()[next], 0).speed : 0;
    const double off = distance_at_border(motion, i);
    if (!(before <= rest && after <= rest && off <= open)) {
      return Finding{"stops", fmt::format("end of line {}: {} and {} mm/s, {} mm off",
                                          toolpath.segments[i - 1].line, before, after, off)};
    }
  }
  return {};
}

namespace {

struct Sample {
  double time = 0;      ///< [s]
  double distance = 0;  ///< [mm]
};

/// Distance of `point` from the path between the ends of segments i - 2 and i + 1, more where the path lags
/// behind its segments [mm]: sampled, then closed
/// in on from every sample that is nearer than its neighbours, until one is within `enough`.
double distance_near(const Motion& motion, std::size_t i, const Vec3& point, double enough) {
  const std::vector<Part>& parts = motion.parts();
  const std::size_t spread = motion.lags() ? 20 : 0;
  const std::size_t first = motion.first_part_of(i - 1 - std::min(spread, i - 1));
  const std::size_t last = std::max(first + 1, motion.first_part_of(i + 1 + spread));
  std::size_t begin = first > 0 ? first - 1 : 0;
  while (begin > 0 && parts[begin - 1].element == parts[begin].element) {  // a curve may pass several blocks
    --begin;
  }
  const double reach = motion.memory(parts[std::min(first, parts.size() - 1)]);
  const double end = last < parts.size() ? parts[last].time + parts[last].duration : motion.run().duration();
  const double from = std::max(0.0, parts[begin].time - reach);
  const double to = std::min(motion.run().duration(), end + reach);
  std::vector<Sample> samples;
  const auto look = [&](double time) { return Sample{time, (motion.position(time) - point).norm()}; };
  constexpr int reached = 64;
  for (int k = 0; reach > 0 && k <= reached; ++k) {
    samples.push_back(look(from + k * (to - from) / reached));
  }
  for (std::size_t p = begin; p < parts.size() && p <= last; ++p) {
    const int of_part = parts[p].place == Place::curve ? 64 : 8;  // a span passes several blocks
    for (int k = 0; k <= of_part; ++k) {
      samples.push_back(look(parts[p].time + parts[p].duration * k / of_part));
    }
  }
  std::sort(samples.begin(), samples.end(), [](const Sample& a, const Sample& b) { return a.time < b.time; });
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < samples.size() && best > enough; ++k) {
    const Sample& before = samples[k > 0 ? k - 1 : k];
    const Sample& after = samples[std::min(k + 1, samples.size() - 1)];
    Sample nearest = samples[k];
    const bool is_least = nearest.distance <= before.distance && nearest.distance <= after.distance;
    double width = is_least ? after.time - before.time : 0;
    for (; width > 1e-12 * (1 + to) && nearest.distance > enough; width /= 2) {
      for (const double time : {nearest.time - width / 2, nearest.time + width / 2}) {
        const Sample there = look(std::clamp(time, from, to));
        nearest = there.distance < nearest.distance ? there : nearest;
      }
    }
    best = std::min(best, nearest.distance);
  }
  return best;
}

}  // namespace

Result check_contour(const Motion& motion, const Guarantees& promised, double tolerance,
                     const Machine& machine) {
  const Toolpath& toolpath = motion.toolpath();
  const double open = met + open_by_rounding(motion, promised, machine);
  for (std::size_t i = 1; i < toolpath.segments.size(); ++i) {
    const JunctionKind kind = junction_kind(toolpath, i);
    const bool exact = promised.contour == 0 || (kind == JunctionKind::pass && promised.meets_tangent_ends);
    if (kind == JunctionKind::stop || (!exact && promised.contour == Guarantees::unbounded)) {
      continue;
    }
    const double allowed = exact ? open : promised.contour * tolerance * (1 + rounding) + met;
    const double distance = exact ? distance_at_border(motion, i)
                                  : distance_near(motion, i, toolpath.segments[i - 1].end, allowed);
    if (!(distance <= allowed)) {
      return Finding{"contour", fmt::format("end of line {}: {} mm from the path, promised is {} mm",
                                            toolpath.segments[i - 1].line, distance, allowed)};
    }
  }
  return {};
}

}  // namespace feedscope::contract
