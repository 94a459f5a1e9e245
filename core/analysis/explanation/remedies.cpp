#include "core/analysis/explanation/remedies.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/analysis/run/setup_options.h"
#include "core/analysis/run/tolerance_in_force.h"
#include "core/machine/contour_tolerance.h"
#include "core/toolpath/turn_limiter.h"

namespace feedscope {
namespace {

constexpr double more = 1.5;       // of limits and shares
constexpr double more_feed = 1.2;  // usual range of a control's feed override

/// Rounds to four digits, short enough to type.
double rounded(double value) {
  if (value == 0) {
    return 0;
  }
  const int decimals = 3 - static_cast<int>(std::floor(std::log10(std::abs(value))));
  const double power = std::pow(10.0, std::abs(decimals));
  return decimals >= 0 ? std::round(value * power) / power : std::round(value / power) * power;
}

/// Largest blend tolerance in force.
struct BlendTolerance {
  double value = 0;  ///< [mm]; 0: blends extend as far as the blocks allow
  bool by_program = false;
};

/// None if the model has no such setting.
std::optional<BlendTolerance> blend_tolerance(std::span<const PathControl> feed_controls,
                                              const Setup& setup) {
  if (!setup.settings.has(blend_tolerance_key)) {
    return std::nullopt;
  }
  const PathControl machine;
  const std::span<const PathControl> controls =
      feed_controls.empty() ? std::span<const PathControl>(&machine, 1) : feed_controls;
  std::optional<BlendTolerance> largest;
  for (const PathControl& control : controls) {
    if (control.mode == PathMode::exact_stop) {
      continue;
    }
    const bool by_program = control.mode == PathMode::continuous && follows_program_tolerance(setup.settings);
    const BlendTolerance one{
        by_program ? control.contour_tolerance.value_or(0) : setup.settings.number(blend_tolerance_key),
        by_program};
    if (one.value == 0) {
      return one;
    }
    if (!largest || one.value > largest->value) {
      largest = one;
    }
  }
  return largest;
}

/// Collects changes that take effect, each once.
class Candidates {
 public:
  Candidates(const Setup& setup, std::span<const PathControl> feed_controls)
      : setup_(setup),
        specs_(settings_of(*setup.model)),
        tolerance_(tolerance_in_force(feed_controls, setup)),
        blend_tolerance_(feedscope::blend_tolerance(feed_controls, setup)) {}

  /// Adds nothing if the machine lacks the axis or the axis lacks the limit.
  void axis(int axis, const std::string& limit) {
    const char name = cause_axes[static_cast<std::size_t>(axis)].name;
    const bool is_there = axis_names(setup_.machine).find(name) != std::string::npos;
    const std::vector<SettingSpec>& specs = axis_specs_of(name);
    if (is_there && std::ranges::find(specs, limit, &SettingSpec::key) != specs.end()) {
      add(axis_changes(name, limit));
    }
  }

  void all_axes(const std::string& limit) {
    Remedy remedy;
    for (const AxisInfo& axis : setup_.machine.axes.axes()) {
      const Remedy one = axis_changes(axis.name, limit);
      remedy.changes.insert(remedy.changes.end(), one.changes.begin(), one.changes.end());
    }
    add(std::move(remedy));
  }

  /// Multiplies a number of the settings by `factor`, within its bounds.
  void setting(const std::string& key, double factor) {
    const auto spec = std::ranges::find(specs_, key, &SettingSpec::key);
    if (spec != specs_.end()) {
      set(key, rounded(number_in_force(setup_.settings, *spec) * factor));
    }
  }

  void set(const std::string& key, SettingValue value,
           std::vector<std::pair<std::string, SettingValue>> besides = {}) {
    const auto spec = std::ranges::find(specs_, key, &SettingSpec::key);
    if (spec == specs_.end()) {
      return;
    }
    if (double* number = std::get_if<double>(&value)) {
      const double step = spec->whole ? std::round(*number) : *number;
      *number = nearest_within(*spec, step);
    }
    Remedy remedy{{{key, std::move(value)}}};
    for (auto& other : besides) {
      if (has(other.first)) {
        remedy.changes.push_back(std::move(other));
      }
    }
    if (std::ranges::all_of(remedy.changes, [&](const auto& change) {
          return change.second == setup_.settings.value(change.first);
        })) {
      return;
    }
    if (key == contour_tolerance_key) {
      remedy.before = tolerance();
    } else if (key == blend_tolerance_key) {
      remedy.before = blend_tolerance_->value;
    }
    add(std::move(remedy));
  }

  /// Largest contour tolerance in force [mm]; none if the model follows none.
  std::optional<double> tolerance() const {
    return tolerance_ ? std::optional(tolerance_->max) : std::nullopt;
  }
  const std::optional<BlendTolerance>& blend_tolerance() const { return blend_tolerance_; }
  bool has(const std::string& key) const { return setup_.settings.has(key); }
  std::string text(const std::string& key) const { return setup_.settings.text(key); }
  /// Whether the compressor is on and replaces dense blocks by smooth curves; turning it on gains nothing
  /// then.
  bool lays_curves() const { return setup_.model->guarantees(setup_.settings).lays_curves; }
  std::vector<Remedy> take() { return std::move(found_); }

 private:
  Remedy axis_changes(char name, const std::string& limit) const {
    const SettingSpec& spec = *std::ranges::find(axis_specs_of(name), limit, &SettingSpec::key);
    const double value = axis_limit(setup_.machine, name, limit);
    const double changed = nearest_within(spec, rounded(value * more));
    return changed == value ? Remedy() : Remedy{{{fmt::format("{}.{}", name, limit), changed}}};
  }

  void add(Remedy remedy) {
    if (remedy != Remedy() && std::ranges::find(found_, remedy) == found_.end()) {
      found_.push_back(std::move(remedy));
    }
  }

  const Setup& setup_;
  std::vector<SettingSpec> specs_;
  std::optional<ToleranceInForce> tolerance_;
  std::optional<BlendTolerance> blend_tolerance_;
  std::vector<Remedy> found_;
};

void larger_tolerance(Candidates& candidates) {
  if (const std::optional<double> now = candidates.tolerance()) {
    auto [tolerance, program] = settings_for_tolerance(2 * *now);
    candidates.set(tolerance.first, std::move(tolerance.second), {std::move(program)});
  }
  if (const std::optional<BlendTolerance>& now = candidates.blend_tolerance(); now && now->value > 0) {
    std::vector<std::pair<std::string, SettingValue>> besides;
    if (now->by_program) {
      besides.emplace_back(program_tolerance_key, std::string("off"));
    }
    candidates.set(blend_tolerance_key, 2 * now->value, std::move(besides));
  }
}

/// Smooth curves through dense short blocks, unless the program requests them for all feed motions.
void compressor(Candidates& candidates, std::span<const PathControl> feed_controls) {
  const bool asked_for =
      !feed_controls.empty() && std::ranges::all_of(feed_controls, [](const PathControl& control) {
        return control.compressor == Switch::on;
      });
  if (candidates.has("compressor") && candidates.lays_curves() &&
      (!asked_for || candidates.text("compressor") == "off")) {
    candidates.set("compressor", std::string("on"));
  }
}

/// Settings that determine the jerk of smoothing filters.
void faster_filters(Candidates& candidates, const Setup& setup) {
  if (!candidates.has("filter_jerk_m_s3")) {
    return;
  }
  if (setup.settings.number("filter_time_s") > 0) {
    candidates.setting("filter_time_s", 1 / std::sqrt(more));
    return;
  }
  double jerk = setup.settings.number("filter_jerk_m_s3");
  for (std::size_t axis = 0;
       axis < setup.machine.axes.size() && !(setup.settings.number("filter_jerk_m_s3") > 0); ++axis) {
    const double own = axis_limit(setup.machine, setup.machine.axes.name(axis), "jerk");
    jerk = jerk > 0 ? std::min(jerk, own) : own;
  }
  candidates.set("filter_jerk_m_s3", rounded(jerk * more));
}

void add_for_blend(Candidates& candidates, Cause cause) {
  larger_tolerance(candidates);
  switch (cause.kind) {
    case CauseKind::blend_velocity:
      candidates.axis(cause.axis, "velocity");
      break;
    case CauseKind::blend_radial_acceleration:
      candidates.setting("radial_acceleration_share", more);
      candidates.axis(cause.axis, "acceleration");
      break;
    case CauseKind::blend_radial_jerk:
      candidates.setting("radial_jerk_share", more);
      candidates.axis(cause.axis, "blend_jerk");
      break;
    case CauseKind::blend_tangential_acceleration:
      candidates.setting("radial_acceleration_share", 1 / more);
      candidates.axis(cause.axis, "acceleration");
      break;
    default:
      candidates.setting("radial_jerk_share", 1 / more);
      candidates.axis(cause.axis, "blend_jerk");
  }
}

bool is_rotary(Cause cause) {
  return cause.axis >= static_cast<std::int8_t>(known_axes.size());
}

void add_for(Candidates& candidates, Cause cause, const Setup& setup) {
  if (cause.kind >= CauseKind::blend_velocity && cause.kind <= CauseKind::blend_tangential_jerk &&
      cause.axis >= 0) {
    add_for_blend(candidates, cause);
    return;
  }
  switch (cause.kind) {
    case CauseKind::programmed_feed:
      candidates.setting(feed_override_key, more_feed);
      break;
    case CauseKind::curvilinear_jerk:
      candidates.setting("curvilinear_jerk_m_s3", more);
      candidates.setting("tangential_share", more);
      break;
    case CauseKind::interpolation_period:
      candidates.setting("interpolation_period_s", 0.5);
      if (candidates.has("compaction_mm")) {
        constexpr double usual_length = 5;  // Msaddek 2011, table 1 [mm]
        candidates.set("compaction_mm", std::max(usual_length, 2 * setup.settings.number("compaction_mm")));
      }
      break;
    case CauseKind::block_time:
      candidates.setting(block_time_key, 0.5);
      break;
    case CauseKind::curvature_crossing:
      candidates.setting("interpolation_period_s", 2);
      break;
    case CauseKind::contour_tolerance:
      larger_tolerance(candidates);
      faster_filters(candidates, setup);
      break;
    case CauseKind::lookahead_horizon:
      candidates.setting("lookahead_blocks", 2);
      candidates.setting("buffer_blocks", 2);
      break;
    case CauseKind::junction_deviation:
      candidates.setting("junction_deviation_mm", 2);
      break;
    case CauseKind::square_corner_velocity:
      candidates.setting("square_corner_velocity_mm_s", more);
      break;
    case CauseKind::cruise_ratio:
      candidates.setting("minimum_cruise_ratio", 0.5);
      break;
    case CauseKind::path_velocity:
      candidates.setting("max_velocity_m_min", more);
      break;
    case CauseKind::path_acceleration:
      candidates.setting("max_acceleration_m_s2", more);
      break;
    case CauseKind::exact_stop:
      larger_tolerance(candidates);
      break;
    default:
      break;
  }
  if (cause.axis < 0) {
    return;
  }
  if (is_rotary(cause) &&
      (cause.kind == CauseKind::axis_acceleration || cause.kind == CauseKind::axis_jerk)) {
    candidates.setting(orientation_tolerance_key, 2);
  }
  switch (cause.kind) {
    case CauseKind::axis_velocity:
      if (!is_rotary(cause) && setup.settings.has(cutting_feed_key(cause.axis))) {
        candidates.setting(cutting_feed_key(cause.axis), more);
      }
      [[fallthrough]];
    case CauseKind::rapid:
      candidates.axis(cause.axis, "velocity");
      break;
    case CauseKind::axis_acceleration:
    case CauseKind::radial_acceleration:
      candidates.axis(cause.axis, "acceleration");
      break;
    case CauseKind::axis_jerk:
    case CauseKind::radial_jerk:
    case CauseKind::curvature_crossing:
      candidates.axis(cause.axis, "jerk");
      break;
    default:
      break;
  }
}

/// Setup on another machine with its limits and settings; everything else in the comparison stays the same.
Setup on_other_machine(const Setup& setup, const std::string& machine) {
  SetupRequest request;
  request.machine = machine;
  request.model = setup.model->info().id;
  Setup other = make_setup(request);
  const auto keep = [&](const std::string& key) {
    if (setup.settings.has(key) || other.settings.has(key)) {
      other.settings.set(key, setup.settings.value(key));
    }
  };
  keep(contour_tolerance_key);
  keep(program_tolerance_key);
  for (const SettingSpec& spec : machine_settings()) {
    keep(spec.key);
  }
  other.load = setup.load;
  return other;
}

}  // namespace

std::vector<Remedy> remedies(const Setup& setup, const Explanation& why,
                             std::span<const PathControl> feed_controls) {
  const Cause cause = why.ahead ? why.ahead->reason.cause : why.reason.cause;
  return remedies(setup, std::span(&cause, 1), feed_controls);
}

std::vector<Remedy> remedies(const Setup& setup, std::span<const Cause> causes,
                             std::span<const PathControl> feed_controls) {
  Candidates candidates(setup, feed_controls);
  for (const Cause cause : causes) {
    add_for(candidates, cause, setup);
  }
  compressor(candidates, feed_controls);
  faster_filters(candidates, setup);
  if (setup.model->guarantees(setup.settings).limits_jerk) {
    candidates.all_axes("jerk");
  }
  candidates.all_axes("acceleration");
  larger_tolerance(candidates);
  candidates.setting("lookahead_blocks", 2);
  candidates.setting("interpolation_period_s", 0.5);
  candidates.setting(feed_override_key, more_feed);
  return candidates.take();
}

Setup with_remedy(Setup setup, const Remedy& remedy) {
  if (!remedy.machine.empty()) {
    setup = on_other_machine(setup, remedy.machine);
  }
  for (const auto& change : remedy.changes) {
    apply_setting(assignment_text(change.first, change.second), *setup.model, setup.machine, setup.settings);
  }
  return setup;
}

std::string as_options(const Remedy& remedy, const Setup& setup) {
  if (!remedy.machine.empty()) {
    return setup_options(with_remedy(setup, remedy));
  }
  std::vector<std::string> options;
  const bool sets_tolerance = std::ranges::any_of(
      remedy.changes, [](const auto& change) { return change.first == contour_tolerance_key; });
  for (const auto& change : remedy.changes) {
    if (change.first == contour_tolerance_key) {
      options.push_back(fmt::format("--tolerance {}", std::get<double>(change.second)));
    } else if (!sets_tolerance || change.first != program_tolerance_key) {  // --tolerance implies it
      options.push_back("--set " + assignment_text(change.first, change.second));
    }
  }
  return fmt::format("{}", fmt::join(options, " "));
}

double feed_factor(const Remedy& remedy, const Setup& setup) {
  const auto changed =
      std::ranges::find(remedy.changes, feed_override_key, &std::pair<std::string, SettingValue>::first);
  if (changed == remedy.changes.end()) {
    return 1;
  }
  const std::vector<SettingSpec>& specs = machine_settings();
  const SettingSpec& spec = *std::ranges::find(specs, feed_override_key, &SettingSpec::key);
  return std::get<double>(changed->second) / number_in_force(setup.settings, spec);
}

Trajectory try_remedy(const LoadedProgram& program, const Setup& setup, const Remedy& remedy,
                      Progress* progress) {
  const Setup changed = with_remedy(setup, remedy);
  return changed.model->simulate(program.toolpath, changed.machine, changed.settings, progress);
}

SegmentRange segments_between(const Trajectory& trajectory, double from, double to) {
  const BlendedPath& path = trajectory.path();
  if (path.empty()) {
    return {};
  }
  return {path.segment(trajectory.state(from).element), path.segment(trajectory.state(to).element)};
}

double passage_time(const Trajectory& trajectory, const SegmentRange& segments) {
  const BlendedPath& path = trajectory.path();
  const auto& pieces = trajectory.pieces();
  /// Time on curve `element` at the start of `segment`, which it passes between its ends.
  const auto on_curve = [&](std::uint32_t element, std::uint32_t segment) {
    const ElementCurve curve = path.curve(element);
    double s = curve.length / 2;
    curve.span->distance(path.programmed()->start_of(segment), s);
    return trajectory.state_at_path(path.s(element) + s).time;
  };
  /// Start time of the first element of `segment` or a later one.
  const auto begin = [&](std::uint32_t segment) {
    std::uint32_t low = 0;
    auto high = static_cast<std::uint32_t>(path.size());
    while (low < high) {
      const std::uint32_t middle = low + (high - low) / 2;
      if (path.segment(middle) < segment) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    if (low > 0 && path.kind(low - 1) == ElementKind::curve && segment < path.programmed()->segments.size()) {
      return on_curve(low - 1, segment);
    }
    if (low >= path.size()) {
      return trajectory.duration();
    }
    const auto own = std::ranges::lower_bound(pieces, low, {}, &Piece::element);
    const bool begins_with_it = own != pieces.end() && own->element == low && own->q <= 0;
    return begins_with_it ? own->time : trajectory.state_at_path(path.s(low)).time;
  };
  return pieces.empty() ? 0 : begin(segments.last + 1) - begin(segments.first);
}

}  // namespace feedscope
