#include "core/lessons/measure.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/analysis/contour/contour_errors.h"
#include "core/analysis/run/peak_search.h"
#include "core/analysis/time/line_times.h"
#include "core/base/error.h"
#include "core/base/nearest_name.h"
#include "core/base/roots.h"
#include "core/base/units.h"
#include "core/drives/span_looks.h"
#include "core/lessons/lesson_language.h"
#include "core/trajectory/part_walk.h"
#include "core/trajectory/state_walk.h"

namespace feedscope {
namespace {

enum What : std::uint8_t {
  cycle_time,
  programmed_time,
  against_cam,
  mean_feed,
  peak_feed,
  min_feed,
  corner_feed,
  contour_error,
  path_length,
  blends,
  peak_velocity,
  peak_acceleration,
  peak_jerk,
  time_by_cause,
  share_by_cause,
  peak_of_quantity,
  least_chip,
  rubbing_time,
  rubbing_share,
};

constexpr double mm_min = units::from_mm_min(1);
constexpr double m_min = units::from_m_min(1);

/// Adds the largest value along the path of every acceleration, jerk and error, in its unit:
/// "peak_acceleration_across_m_s2", "peak_following_error_um".
void add_peaks(std::vector<MeasureSpec>& measures) {
  for (const QuantityInfo& quantity : all_quantities()) {
    const bool is_error = quantity.dimension == Dimension::error;
    const bool is_limited =
        quantity.dimension == Dimension::acceleration || quantity.dimension == Dimension::jerk;
    if (quantity.axis >= 0 || (is_error ? !quantity.colours : quantity.column.empty() || !is_limited)) {
      continue;
    }
    const ShownUnit& unit = shown_unit(quantity.dimension);
    std::string title(quantity.title);
    title.front() = static_cast<char>(title.front() - 'A' + 'a');
    const std::string_view in_unit =
        is_error ? std::string_view("_um") : quantity.column.substr(quantity.column.find('_'));
    measures.push_back({fmt::format("peak_{}{}", quantity.key, in_unit), "largest " + title,
                        std::string(unit.text), unit.decimals, 1 / unit.factor, peak_of_quantity,
                        LineUse::optional, false, false, quantity.id});
  }
}

std::vector<MeasureSpec> make_measures() {
  using enum LineUse;
  std::vector<MeasureSpec> measures{
      {"cycle_time_s", "cycle time", "s", 3, 1, cycle_time, optional},
      {"cycle_time_ms", "cycle time", "ms", 0, 1e-3, cycle_time, optional},
      {"programmed_time_s", "programmed time", "s", 3, 1, programmed_time},
      {"against_cam", "cycle time over programmed time", "", 2, 1, against_cam},
      {"mean_feed_mm_min", "mean feed", "mm/min", 0, mm_min, mean_feed, optional},
      {"mean_feed_m_min", "mean feed", "m/min", 2, m_min, mean_feed, optional},
      {"peak_feed_mm_min", "largest feed", "mm/min", 0, mm_min, peak_feed, optional},
      {"peak_feed_m_min", "largest feed", "m/min", 2, m_min, peak_feed, optional},
      {"least_feed_mm_min", "least feed", "mm/min", 0, mm_min, min_feed, needed},
      {"least_feed_m_min", "least feed", "m/min", 2, m_min, min_feed, needed},
      {"corner_feed_mm_min", "feed in the corner at the end", "mm/min", 0, mm_min, corner_feed, needed},
      {"corner_feed_m_min", "feed in the corner at the end", "m/min", 2, m_min, corner_feed, needed},
      {"max_contour_error_mm", "contour error", "mm", 4, 1, contour_error, optional},
      {"max_contour_error_um", "contour error", "µm", 1, 1e-3, contour_error, optional},
      {"path_length_mm", "path length", "mm", 2, 1, path_length, optional},
      {"blends", "corner blends", "", 0, 1, blends},
      {"peak_velocity_m_min", "largest velocity", "m/min", 2, m_min, peak_velocity, none, true},
      {"peak_acceleration_m_s2", "largest acceleration", "m/s²", 2, units::from_m(1), peak_acceleration, none,
       true},
      {"peak_jerk_m_s3", "largest jerk", "m/s³", 1, units::from_m(1), peak_jerk, none, true},
      {"time_by_cause_s", "time", "s", 3, 1, time_by_cause, none, false, true},
      {"share_by_cause_percent", "share of the cycle time", "%", 0, 0.01, share_by_cause, none, false, true},
  };
  add_peaks(measures);
  measures.push_back({"peak_cutting_force_n", "largest peak cutting force", "N", 0, 1, peak_of_quantity,
                      optional, false, false, QuantityId::peak_force});
  measures.push_back({"least_chip_thickness_um", "least chip thickness", "µm", 1, units::from_um(1),
                      least_chip, optional, false, false, QuantityId::chip_thickness});
  measures.push_back({"rubbing_time_s", "time below the least chip", "s", 3, 1, rubbing_time});
  measures.push_back({"rubbing_share_percent", "share of the cutting time below the least chip", "%", 1, 0.01,
                      rubbing_share});
  return measures;
}

std::string lines_text(const Measure& measure) {
  return measure.first_line == measure.last_line
             ? fmt::format("line {}", measure.first_line)
             : fmt::format("lines {} to {}", measure.first_line, measure.last_line);
}

std::string cause_in(Cause cause, const std::string& language) {
  const CauseInfo& info = info_of(cause.kind);
  if (cause.axis < 0 || !info.by_axis()) {
    return lesson_word(std::string(info.title), language);
  }
  std::string title = lesson_word(std::string(info.axis_title), language);
  return title.replace(title.find("%1"), 2, 1, axis_name(cause));
}

[[noreturn]] void fail_without_motion(const Measure& measure) {
  throw InputError(message(NC_("core", "nothing moves on {} of the program: no {} there"),
                           lines_text(measure), measure.spec->title));
}

struct Range {
  double least = std::numeric_limits<double>::infinity();
  double largest = -std::numeric_limits<double>::infinity();
};

/// Calls `use(walk)` for every part on the lines of `measure`, or of all lines if it has none, except dwells.
template <typename Use>
void for_parts_on_lines(const Measure& measure, const Trajectory& trajectory, Use use) {
  for (PartWalk walk(trajectory); !walk.done(); walk.next()) {
    const Part& part = walk.part();
    const std::uint32_t line = trajectory.line_of(part.element);
    const bool elsewhere = measure.first_line > 0 && (line < measure.first_line || line > measure.last_line);
    if (!elsewhere && trajectory.path().kind(part.element) != ElementKind::dwell) {
      use(walk);
    }
  }
}

constexpr int looks_a_part = 17;

/// Minimum of `value(tau)` between the neighbours of the smallest sample. `before`: minimum elsewhere; parts
/// whose samples cannot be below it are not searched.
template <typename Value>
double least_near_looks(const std::array<double, looks_a_part>& looks, double duration, double before,
                        Value value) {
  constexpr double width = 1e-6;  // of the distance between samples
  constexpr int most_steps = 40;
  const auto at = static_cast<int>(std::ranges::min_element(looks) - looks.begin());
  const int low = std::max(at - 1, 0);
  const int high = std::min(at + 1, looks_a_part - 1);
  const auto look = [&](int i) { return looks[static_cast<std::size_t>(i)]; };
  const double reach = std::max(look(low), look(high)) - look(at);
  if (look(at) - reach >= before) {
    return std::min(look(at), before);
  }
  const double step = duration / (looks_a_part - 1);
  const double found = least_place({step * low, step * high}, width * step, most_steps, value).value;
  return std::min({look(at), found, before});
}

/// Range of `value(motion, tau)` on the lines of `measure`, narrowed down between equally spaced samples.
template <typename Value>
Range range_of(const Measure& measure, const Trajectory& trajectory, Value value) {
  Range range;
  for_parts_on_lines(measure, trajectory, [&](PartWalk& walk) {
    const double duration = walk.part().duration;
    const PartMotion motion = walk.motion();
    std::array<double, looks_a_part> looks;
    for (int i = 0; i < looks_a_part; ++i) {
      looks[static_cast<std::size_t>(i)] = value(motion, duration * i / (looks_a_part - 1));
    }
    range.least =
        least_near_looks(looks, duration, range.least, [&](double tau) { return value(motion, tau); });
    for (double& look : looks) {
      look = -look;
    }
    range.largest =
        -least_near_looks(looks, duration, -range.largest, [&](double tau) { return -value(motion, tau); });
  });
  return range;
}

double least_feed_on_lines(const Measure& measure, const Trajectory& trajectory) {
  const Range range = range_of(measure, trajectory, [](const PartMotion& motion, double tau) {
    return motion.kinematics(tau).velocity.norm();
  });
  if (range.least > range.largest) {
    fail_without_motion(measure);
  }
  return range.least;
}

double largest_feed_on_lines(const Measure& measure, const Trajectory& trajectory) {
  PeakSearch search;
  bool moves = false;
  for_parts_on_lines(measure, trajectory, [&](PartWalk& walk) {
    search.add(trajectory, walk.part());
    moves = true;
  });
  if (!moves) {
    fail_without_motion(measure);
  }
  return search.speed();
}

/// Largest absolute value; 0 without motion.
double peak(const Measure& measure, const Trajectory& trajectory) {
  const auto of = info_of(*measure.spec->quantity).of;
  const Range range = range_of(measure, trajectory, [of](const PartMotion& motion, double tau) {
    return std::abs(of(motion.state_without_length(tau)));
  });
  return std::max(0.0, range.largest);
}

/// Peak of the drives, at the borders of SpanLooks; contour errors of cuts only, as in the summary.
double peak_of_drives(const Measure& measure, const Run& run) {
  if (run.sources.actual == nullptr) {
    throw InputError(
        message(NC_("core", "the machine {} has no drives, so that there is no {}; give its axes kv_1_s"),
                run.setup.machine.id, measure.spec->title));
  }
  const auto of = info_of(*measure.spec->quantity).of;
  const bool of_cuts = measure.spec->quantity == QuantityId::actual_contour_error;
  const Trajectory& trajectory = *run.trajectory;
  StateWalk set(trajectory);
  ActualErrors errors(*run.sources.actual);
  const bool rigid = run.sources.actual->response().is_rigid();
  double largest = 0;
  for (ActualWalk walk(run.sources.actual->response()); !walk.done(); walk.next_span()) {
    const SpanLooks looks(walk.span(), rigid);
    for (int i = 0; i <= looks.count(); ++i) {
      const double time = looks.at(i);
      const State state = set.at_without_length(time);
      const bool elsewhere =
          measure.first_line > 0 && (state.line < measure.first_line || state.line > measure.last_line);
      if (elsewhere || (of_cuts && !errors.is_cut(state.element))) {
        continue;
      }
      const ActualMotion motion = walk.within_span(time);
      const PathDeviation::Foot foot = errors.foot(motion.position, state.element);
      if (of_cuts && !errors.is_of_cut(foot, state.element)) {
        continue;
      }
      const ActualSample sample{motion, std::sqrt(foot.squared)};
      largest = std::max(largest, of(Instant(state, &sample)));
    }
  }
  return largest;
}

const RunLoad& load_of(const Measure& measure, const Run& run) {
  if (run.sources.load == nullptr) {
    throw InputError(
        fmt::format("it is not known how the tools are engaged, so that there is no {}; give a "
                    "load file",
                    measure.spec->title));
  }
  return *run.sources.load;
}

/// Range of the cutting load where there is one.
Range load_on_lines(const Measure& measure, const Run& run) {
  LoadSampler sampler(load_of(measure, run));
  const auto of = info_of(*measure.spec->quantity).of;
  Range range;
  range_of(measure, *run.trajectory, [&](const PartMotion& motion, double tau) {
    const State state = motion.state_without_length(tau);
    const LoadSample sample = sampler.at(state);
    if (sample.has_load()) {
      const double value = of(Instant(state, nullptr, &sample));
      range = {std::min(range.least, value), std::max(range.largest, value)};
    }
    return 0.0;
  });
  if (range.least > range.largest) {
    fail_without_motion(measure);
  }
  return range;
}

/// Time below the least chip thickness of the operation [s].
double time_of_rubbing(const Measure& measure, const Run& run) {
  load_of(measure, run);
  for (const LimitFigures& limit : run.summary.load->limits) {
    if (limit.limit == LoadLimit::least_chip) {
      return limit.time;
    }
  }
  throw InputError(
      fmt::format("no operation has a least chip thickness, so that there is no {}; give "
                  "min_chip_um",
                  measure.spec->title));
}

/// Stretch of the executed path on one line.
struct LineStretch {
  double from = 0;       ///< [mm]
  double to = 0;         ///< [mm]
  std::size_t next = 0;  ///< first element after it
};

/// First consecutive elements from `begin` on with one line.
LineStretch stretch_from(const Trajectory& trajectory, std::size_t begin) {
  const BlendedPath& path = trajectory.path();
  LineStretch stretch{path.s(begin), path.s(begin), begin};
  const std::uint32_t line = trajectory.line_of(begin);
  while (stretch.next < path.size() && trajectory.line_of(stretch.next) == line) {
    stretch.to = path.s(++stretch.next);
  }
  return stretch;
}

/// Feed where the executed path is nearest to the programmed end of a line, at its first run.
double feed_in_corner(const Measure& measure, const Trajectory& trajectory) {
  const BlendedPath& path = trajectory.path();
  const Toolpath& toolpath = *path.programmed();
  std::size_t begin = 0;
  while (begin < path.size() && trajectory.line_of(begin) != measure.first_line) {
    ++begin;
  }
  if (begin == path.size()) {
    fail_without_motion(measure);
  }
  const LineStretch line = stretch_from(trajectory, begin);
  const Vec3 corner = toolpath.segments[path.segment(line.next - 1)].end;
  double low = (line.from + line.to) / 2;
  double high = line.to;
  if (line.next < path.size()) {
    const LineStretch after = stretch_from(trajectory, line.next);
    high = (after.from + after.to) / 2;
  }
  const auto distance = [&](double s) { return (trajectory.state_at_path(s).position - corner).norm(); };
  constexpr double fine = 1e-7;  // mm
  constexpr int max_steps = 200;
  return trajectory.state_at_path(least_place({low, high}, fine, max_steps, distance).place.middle()).speed;
}

double of_axes(const Measure& measure, const Summary& summary, double AxisPeaks::*value) {
  double largest = 0;
  for (std::size_t axis = 0; axis < summary.axes.size(); ++axis) {
    if (measure.axis == 0 || measure.axis == summary.axes.name(axis)) {
      if (std::isnan(summary.axes[axis].*value)) {
        throw InputError(
            message(NC_("core", "the model limits no jerk, so that the acceleration jumps: no {}"),
                    measure.spec->title));
      }
      largest = std::max(largest, summary.axes[axis].*value);
    }
  }
  return largest;
}

double cause_seconds(const Measure& measure, const Summary& summary) {
  double time = 0;
  for (const std::size_t cause : causes_named(measure.cause)) {
    time += summary.time_by_cause[cause];
  }
  return time;
}

LineTime line_time(const Measure& measure, const Run& run) {
  const LineTime time = LineTimes(*run.trajectory).of(measure.first_line, measure.last_line);
  if (time.time <= 0) {
    fail_without_motion(measure);
  }
  return time;
}

double contour_error_on_lines(const Measure& measure, const Trajectory& trajectory) {
  const auto counts = [&](std::size_t element) {
    const std::uint32_t line = trajectory.line_of(element);
    return line >= measure.first_line && line <= measure.last_line;
  };
  double largest = -1;
  for (std::size_t begin = 0; begin < trajectory.path().size(); ++begin) {
    std::size_t end = begin;
    while (end < trajectory.path().size() && counts(end)) {
      ++end;
    }
    if (end > begin) {
      ContourRequest request;
      request.first_element = static_cast<std::uint32_t>(begin);
      request.last_element = static_cast<std::uint32_t>(end);
      largest = std::max(largest, contour_errors(trajectory, request).largest);
      begin = end;
    }
  }
  if (largest < 0) {
    fail_without_motion(measure);
  }
  return largest;
}

double on_lines(const Measure& measure, const Run& run) {
  switch (measure.spec->what) {
    case cycle_time:
      return line_time(measure, run).time;
    case mean_feed:
      return line_time(measure, run).mean_feed();
    case path_length:
      return line_time(measure, run).length;
    case contour_error:
      return contour_error_on_lines(measure, *run.trajectory);
    case corner_feed:
      return feed_in_corner(measure, *run.trajectory);
    case min_feed:
      return least_feed_on_lines(measure, *run.trajectory);
    default:
      return largest_feed_on_lines(measure, *run.trajectory);
  }
}

double on_run(const Measure& measure, const Run& run) {
  const Summary& summary = run.summary;
  switch (measure.spec->what) {
    case cycle_time:
      return summary.cycle_time;
    case programmed_time:
      return summary.programmed_time;
    case against_cam:
      return summary.programmed_time > 0 ? summary.cycle_time / summary.programmed_time : 1;
    case mean_feed:
      return summary.mean_feed;
    case peak_feed:
      return summary.peak_feed;
    case contour_error:
      return summary.max_contour_error;
    case path_length:
      return run.trajectory->path_length();
    case blends:
      return static_cast<double>(run.trajectory->blend_count());
    case peak_velocity:
      return of_axes(measure, summary, &AxisPeaks::velocity);
    case peak_acceleration:
      return of_axes(measure, summary, &AxisPeaks::acceleration);
    case peak_jerk:
      return of_axes(measure, summary, &AxisPeaks::jerk);
    case time_by_cause:
      return cause_seconds(measure, summary);
    case rubbing_time:
      return time_of_rubbing(measure, run);
    case rubbing_share:
      return time_of_rubbing(measure, run) / summary.load->all.cutting_time;
    default:
      return summary.cycle_time > 0 ? cause_seconds(measure, summary) / summary.cycle_time : 0;
  }
}

Message known_or_nearest(const std::vector<std::string>& known, const std::string& nearest) {
  return nearest.empty() ? message(NC_("core", "known: {}"), fmt::format("{}", fmt::join(known, ", ")))
                         : message(NC_("core", "did you mean '{}'?"), nearest);
}

}  // namespace

const std::vector<MeasureSpec>& all_measures() {
  static const std::vector<MeasureSpec> measures = make_measures();
  return measures;
}

const MeasureSpec& find_measure(const std::string& key) {
  std::vector<std::string> keys;
  for (const MeasureSpec& spec : all_measures()) {
    if (spec.key == key) {
      return spec;
    }
    keys.push_back(spec.key);
  }
  const std::string nearest = nearest_name(key, keys);
  throw InputError(message(NC_("core", "unknown measure '{}'; {}"), key, known_or_nearest(keys, nearest)));
}

std::vector<std::size_t> causes_named(const std::string& key) {
  std::vector<std::size_t> found;
  for (const Cause& cause : all_causes()) {
    if (cause_key(cause) == key || cause_key({cause.kind, -1}) == key) {
      found.push_back(cause_index(cause));
    }
  }
  if (found.empty()) {
    std::vector<std::string> names;
    for (const Cause& cause : all_causes()) {
      names.push_back(cause_key(cause));
    }
    const std::string nearest = nearest_name(key, names);
    throw InputError(message(NC_("core", "unknown cause '{}'; {}"), key, known_or_nearest(names, nearest)));
  }
  return found;
}

std::string title_of(const Measure& measure, const std::string& language) {
  const auto pattern = [&](const char* english) { return lesson_word(english, language); };
  std::string title = lesson_word(measure.spec->title, language);
  if (!measure.cause.empty()) {
    const std::vector<std::size_t> causes = causes_named(measure.cause);
    const Cause cause = all_causes()[causes.front()];
    title = fmt::format(fmt::runtime(pattern("{} limited by {}")), title,
                        cause_in(causes.size() == 1 ? cause : Cause{cause.kind, -1}, language));
  }
  if (measure.spec->of_axis) {
    title = measure.axis == 0 ? fmt::format(fmt::runtime(pattern("{} of an axis")), title)
                              : fmt::format(fmt::runtime(pattern("{} of axis {}")), title, measure.axis);
  }
  if (measure.first_line == 0) {
    return title;
  }
  return measure.first_line == measure.last_line
             ? fmt::format(fmt::runtime(pattern("{}, line {}")), title, measure.first_line)
             : fmt::format(fmt::runtime(pattern("{}, lines {} to {}")), title, measure.first_line,
                           measure.last_line);
}

double measured(const Measure& measure, const Run& run) {
  if (measure.spec->quantity && info_of(*measure.spec->quantity).source == QuantitySource::drives) {
    return peak_of_drives(measure, run) / measure.spec->per_unit;
  }
  if (measure.spec->quantity && info_of(*measure.spec->quantity).source == QuantitySource::load) {
    const Range range = load_on_lines(measure, run);
    return (measure.spec->what == least_chip ? range.least : range.largest) / measure.spec->per_unit;
  }
  if (measure.spec->quantity) {
    return peak(measure, *run.trajectory) / measure.spec->per_unit;
  }
  return (measure.first_line == 0 ? on_run(measure, run) : on_lines(measure, run)) / measure.spec->per_unit;
}

}  // namespace feedscope
