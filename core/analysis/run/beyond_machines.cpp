#include "core/analysis/run/beyond_machines.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/base/units.h"

namespace feedscope {
namespace {

constexpr double farthest = 1e8;        // [mm]
constexpr double widest = 1e6;          // [mm]
constexpr double longest_motion = 1e7;  // [mm]
constexpr double most_turns = 1e5;      // of a rotary axis
constexpr double day = 24 * 3600;       // [s]
constexpr double longest_time = 365 * day;

constexpr Translatable not_simulated =
    NC_("core", "the program is not simulated; check the number, its decimal point and the unit");

Diagnostic fault(std::uint32_t line, Message what) {
  return {Severity::error, line, 0, "beyond-machines", std::move(what), not_simulated};
}

/// Follows a path up to the first element beyond a bound.
class Reach {
 public:
  explicit Reach(const Toolpath& path) : path_(path) {}

  std::optional<Diagnostic> add(const Segment& segment) {
    if (segment.kind == SegmentKind::dwell) {
      return pass(segment, path_.dwell_of(segment));
    }
    for (int axis = 0; axis < 3; ++axis) {
      const double at = segment.end[axis];
      least_[axis] = std::min(least_[axis], at);
      most_[axis] = std::max(most_[axis], at);
      if (std::abs(at) > farthest || most_[axis] - least_[axis] > widest) {
        return fault(segment.line,
                     message(NC_("core", "{} goes to {:.4g} km, beyond the travel of any machine"),
                             coordinate_names[static_cast<std::size_t>(axis)], km(at)));
      }
    }
    if (segment.length > longest_motion) {
      return fault(
          segment.line,
          message(NC_("core", "a motion of {:.4g} km is longer than any machine makes"), km(segment.length)));
    }
    return segment.feed > 0 ? pass(segment, segment.length / segment.feed) : std::nullopt;
  }

 private:
  static double km(double mm) { return mm / units::from_m(1000); }

  std::optional<Diagnostic> pass(const Segment& segment, double time) {
    time_ += time;
    if (!(time_ > longest_time)) {
      return std::nullopt;
    }
    const double days = time_ / day;
    return fault(
        segment.line,
        segment.feed > 0
            ? message(NC_("core",
                          "{:.4g} days pass up to this line, which runs at F{:.4g} mm/min: more than a year"),
                      days, units::to_mm_min(segment.feed))
            : message(
                  NC_("core",
                      "{:.4g} days pass up to this line, which waits for {:.4g} of them: more than a year"),
                  days, time / day));
  }

  const Toolpath& path_;
  Vec3 least_ = Vec3::Constant(INFINITY);
  Vec3 most_ = Vec3::Constant(-INFINITY);
  double time_ = 0;
};

}  // namespace

std::optional<Diagnostic> beyond_machines(const Toolpath& toolpath) {
  Reach reach(toolpath);
  for (const Segment& segment : toolpath.segments) {
    if (std::optional<Diagnostic> found = reach.add(segment)) {
      return found;
    }
  }
  for (const RotaryMove& move : toolpath.rotary_moves) {
    for (const std::optional<double>& to : move.to) {
      if (to && std::abs(*to) > units::from_turns(most_turns)) {
        return fault(
            move.line,
            message(NC_("core", "a rotary axis goes to {:.4g} degrees, beyond what any machine turns"),
                    units::to_deg(*to)));
      }
    }
  }
  return std::nullopt;
}

}  // namespace feedscope
