#include "core/identification/recordings.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <functional>
#include <string_view>
#include <utility>
#include <variant>

#include "core/base/error.h"
#include "core/base/translatable.h"
#include "core/identification/section_case.h"
#include "core/identification/trace_case.h"
#include "core/machine/file_text.h"

namespace feedscope {

namespace {

AxisDrive drive_of(const Machine& machine, char axis) {
  const AxisDrive* held = machine.drives.find(axis);
  return held == nullptr ? AxisDrive() : *held;
}

/// Adds the tolerance of zero that the result is based on. `before`: its start value.
void add_zero(Identification& found, const FitParameter& tolerance, double before, const std::string& date) {
  IdentifiedParameter one;
  one.parameter = tolerance;
  one.start = before;
  one.reason = QT_TRANSLATE_NOOP("core", "Only zero, which stands for no limit, explains these traces.");
  found.setup.machine.provenance.insert_or_assign(
      tolerance.key,
      Provenance{date.empty() ? "traces that only zero explains" : "traces that only zero explains, " + date,
                 true});
  found.parameters.push_back(std::move(one));
}

/// Adds the feed override of the traces that the result is based on, and removes it from the machine.
void add_override(Identification& found, const Setup& start, double before) {
  IdentifiedParameter one;
  one.parameter = {feed_override_key, "%", 0, 0};
  one.start = before;
  one.value = found.setup.settings.number(feed_override_key);
  one.reason = QT_TRANSLATE_NOOP(
      "core",
      "The traces run at this share of the programmed feed. It is taken as the feed override, and is not "
      "written "
      "into the machine file. If the recorded times have a wrong rate instead, the other values are wrong.");
  found.parameters.push_back(std::move(one));
  Settings kept;
  for (const auto& [key, value] : found.setup.machine.settings.values()) {
    if (key != feed_override_key || start.machine.settings.has(key)) {
      kept.set(key, key == feed_override_key ? start.machine.settings.value(key) : value);
    }
  }
  found.setup.machine.settings = std::move(kept);
  found.setup.machine.provenance.erase(feed_override_key);
  if (const auto source = start.machine.provenance.find(feed_override_key);
      source != start.machine.provenance.end()) {
    found.setup.machine.provenance.insert(*source);
  }
}

constexpr std::string_view steps_key = "steps_per_mm";

/// Whether the model counts motor steps while the steps per millimetre are assumed.
bool assumes_steps(const Setup& start) {
  const std::string timing = "step_timing";
  if (!start.settings.has(timing) || start.settings.text(timing) != "on") {
    return false;
  }
  return std::ranges::any_of(start.machine.provenance, [](const auto& source) {
    return source.first.ends_with(steps_key) && source.second.assumed;
  });
}

Setup with_steps(Setup setup, double factor) {
  for (const auto& [axis, kind] : setup.machine.axes.axes()) {
    const SettingValue value = axis_value(setup.machine, axis, steps_key);
    if (const double* steps = std::get_if<double>(&value)) {
      set_axis_value(setup.machine, axis, std::string(steps_key), *steps * factor);
    }
  }
  return setup;
}

/// Assumed steps affect the result: tries half and double as many and uses them if they explain the
/// recordings much better; increases the uncertainty of the numbers by their change to the next best. `from`:
/// names of the recordings and the date, for sources; `fit`: fits a start setup.
void doubt_steps(Identification& found, const Setup& start, const std::string& from,
                 const std::function<Identification(const Setup&)>& fit) {
  constexpr double better = 0.8;
  constexpr double coarsest = 0.2;
  double taken = 1;
  std::vector<Identification> others;
  for (const double factor : {2.0, 0.5}) {
    Identification other = fit(with_steps(start, factor));
    if (other.explains && other.residual < better * found.residual) {
      std::swap(found, other);
      taken = factor;
    }
    others.push_back(std::move(other));
  }
  const Identification& other = *std::ranges::min_element(others, {}, &Identification::residual);
  for (std::size_t p = 0; p < found.parameters.size() && other.explains; ++p) {
    IdentifiedParameter& one = found.parameters[p];
    if (!one.told || is_drive_parameter(one.parameter)) {
      continue;
    }
    one.uncertainty = std::max(one.uncertainty, std::abs(other.parameters[p].value - one.value));
    if (one.uncertainty > coarsest * one.value) {
      one.told = false;
      one.uncertainty = 0;
      one.reason = QT_TRANSLATE_NOOP(
          "core", "It changes with the steps a millimetre, which are assumed: give those of the machine.");
    }
    Provenance& source = found.setup.machine.provenance[one.parameter.key];
    source = one.told ? identified_source(one, from) : undetermined_source(one, from, source);
  }
  if (taken != 1) {
    for (const auto& [name, kind] : start.machine.axes.axes()) {
      const char axis = name;
      IdentifiedParameter one;
      one.parameter = {fmt::format("{}.{}", axis, steps_key), "1/mm", 0, 0};
      const auto number = [&](const Setup& setup) {
        const SettingValue value = axis_value(setup.machine, axis, steps_key);
        const double* steps = std::get_if<double>(&value);
        return steps != nullptr ? *steps : 0;
      };
      one.start = number(start);
      one.value = number(found.setup);
      one.reason = QT_TRANSLATE_NOOP(
          "core", "Assumed, but it explains the recordings much better than what was assumed before.");
      found.setup.machine.provenance.insert_or_assign(
          one.parameter.key, Provenance{"explains recordings better than what was assumed before", true});
      found.parameters.push_back(std::move(one));
    }
  }
}

/// Tolerance among `parameters` for which zero means no limit, unreachable for a search of logarithms; null
/// if none.
const FitParameter* that_may_be_zero(const Setup& start, const std::vector<FitParameter>& parameters) {
  for (const SettingSpec& spec : settings_of(*start.model)) {
    const auto one = std::ranges::find(parameters, spec.key, &FitParameter::key);
    if (one != parameters.end() && spec.minimum == 0 && spec.least_above_zero == 0 &&
        spec.key.find("tolerance") != std::string::npos) {
      return &*one;
    }
  }
  return nullptr;
}

}  // namespace

void Recordings::add(std::shared_ptr<const Trace> trace, const LoadedProgram& program) {
  items_.push_back({std::move(trace), {}, {}, program});
  drives_.clear();
}

void Recordings::add(std::vector<SectionTime> times, const std::string& name, const LoadedProgram& program) {
  items_.push_back({nullptr, std::move(times), name, program});
}

std::vector<const Trace*> Recordings::traces() const {
  std::vector<const Trace*> traces;
  for (const Item& item : items_) {
    if (item.trace != nullptr) {
      traces.push_back(item.trace.get());
    }
  }
  return traces;
}

std::vector<FitParameter> Recordings::usual_parameters(const Setup& start) const {
  std::vector<FitParameter> usual = usual_fit_parameters(start);
  for (const char axis : axes_with_drives(traces())) {
    for (std::size_t i = 0; i < drive_parameter_count && start.machine.axes.axes().find(axis); ++i) {
      usual.push_back(drive_parameter(axis, i));
    }
  }
  return usual;
}

/// Identifies the drives of the axes with a drive parameter and stores them in the machine of `setup`.
std::vector<DriveFit> Recordings::fit_drives(const std::vector<FitParameter>& parameters, Setup& setup,
                                             Progress* progress) {
  std::vector<DriveFit> drives;
  const std::string recorded = axes_with_drives(traces());
  for (const FitParameter& parameter : parameters) {
    const char axis = parameter.key.front();
    if (!is_drive_parameter(parameter) || std::ranges::find(drives, axis, &DriveFit::axis) != drives.end()) {
      continue;
    }
    if (recorded.empty()) {
      throw InputError(
          message(NC_("core",
                      "{} is found from set and actual positions of {}; no trace has both: record the actual "
                      "position too, and name it if need be, as --columns actual_{}=5:mm"),
                  parameter.key, axis, static_cast<char>(axis - 'X' + 'x')));
    }
    FreeDriveNumbers free{};
    for (std::size_t i = 0; i < drive_parameter_count; ++i) {
      const std::string key = drive_parameter(axis, i).key;
      free[i] = std::ranges::find(parameters, key, &FitParameter::key) != parameters.end();
    }
    drives.push_back(drive_of_axis(axis, drive_of(setup.machine, axis), free, progress));
  }
  distrust_delayed(drives);
  for (const DriveFit& drive : drives) {
    const AxisDrive found = found_drive(drive, drive_of(setup.machine, drive.axis));
    for (std::size_t i = 0; i < drive_parameter_count; ++i) {
      set_axis_value(setup.machine, drive.axis, axis_drive_specs()[i].key, drive_value(found, i));
    }
  }
  return drives;
}

/// Cached for all models.
const DriveFit& Recordings::drive_of_axis(char axis, const AxisDrive& start, const FreeDriveNumbers& free,
                                          Progress* progress) {
  const auto known = std::ranges::find_if(drives_, [&](const FoundDrive& drive) {
    return drive.fit.axis == axis && drive.start == start && drive.free == free;
  });
  if (known != drives_.end()) {
    return known->fit;
  }
  drives_.push_back({start, free, fit_drive(traces(), axis, start, free, progress)});
  return drives_.back().fit;
}

/// Adds a drive with the sources of its values.
void Recordings::add_drive(Identification& found, const DriveFit& drive, const std::string& date) const {
  std::string from;
  for (const Trace* trace : traces()) {
    if (trace->has_drive(static_cast<std::size_t>(drive.axis - 'X'))) {
      from += (from.empty() ? "" : ", ") + trace->name;
    }
  }
  from += date.empty() ? "" : ", " + date;
  auto& sources = found.setup.machine.provenance;
  for (std::size_t i = 0; i < drive_parameter_count; ++i) {
    const IdentifiedParameter& one = drive.parameters[i];
    if (!drive.free[i]) {
      continue;
    }
    if (one.told) {
      sources.insert_or_assign(one.parameter.key, identified_source(one, from));
    } else if (drive.explains && one.value > 0) {
      sources.insert_or_assign(one.parameter.key, undetermined_source(one, from, sources[one.parameter.key]));
    }
    found.parameters.push_back(one);
    if (!one.told && !drive.of_first_order) {
      found.parameters.back().told_by = fmt::format("SINGLE MOVES OF {}", drive.axis);
    }
  }
  found.drives.push_back(drive);
}

/// Share of the programmed feed common to all recordings; none if one differs or has none.
std::optional<double> Recordings::feed_share() const {
  constexpr double same = 0.01;
  constexpr double least = 0.02;  // smaller and larger ones come from times in another unit
  constexpr double most = 5;
  if (feed_shares_.empty() || !std::ranges::all_of(feed_shares_, &std::optional<double>::has_value)) {
    return std::nullopt;
  }
  const double share = *feed_shares_.front();
  const bool agree = std::ranges::all_of(
      feed_shares_, [&](const std::optional<double>& one) { return std::abs(*one / share - 1) <= same; });
  return agree && share > least && share < most ? std::optional(share) : std::nullopt;
}

Identification Recordings::fit(const Setup& start, const std::vector<FitParameter>& parameters,
                               const IdentifyOptions& options, const Stage& stage) {
  Progress* fitting = nullptr;
  Identification found = fit_as_begun(start, parameters, options, [&](const char* title) {
    return fitting = stage ? stage(title) : nullptr;
  });
  std::size_t simulations = found.simulations;
  const auto again = [&](const Setup& other, const std::vector<FitParameter>& some) {
    std::vector<std::vector<Diagnostic>> remarks = remarks_;
    Identification fitted = fit_as_begun(other, some, options, [&](const char*) { return fitting; });
    remarks_ = std::move(remarks);
    simulations += fitted.simulations;
    return fitted;
  };
  if (const FitParameter* tolerance = found.explains ? nullptr : that_may_be_zero(start, parameters)) {
    Setup without = start;
    without.settings.set(tolerance->key, 0.0);
    std::vector<FitParameter> others = parameters;
    std::erase_if(others, [&](const FitParameter& one) { return one.key == tolerance->key; });
    Identification other = again(without, others);
    if (other.explains) {
      other.simulations = simulations;
      add_zero(other, *tolerance, fit_value(start, *tolerance), options.date);
      return other;
    }
  }
  Setup begun = start;
  constexpr double whole = 100;
  const double override_before = feed_override(start).value_or(whole);
  if (const std::optional<double> share = feed_share()) {
    constexpr double as_well = 1.2;  // a limit in place of the override also explains the traces
    Setup slowed = start;
    slowed.settings.set(feed_override_key, override_before * *share);
    Identification other = again(slowed, parameters);
    if (other.explains && (!found.explains || other.residual <= as_well * found.residual)) {
      found = std::move(other);
      found.simulations = simulations;
      begun = slowed;
    }
  }
  if (found.explains && assumes_steps(begun)) {
    std::string from;
    for (const Item& item : items_) {
      from += (from.empty() ? "" : ", ") + (item.trace != nullptr ? item.trace->name : item.name);
    }
    from += options.date.empty() ? "" : ", " + options.date;
    doubt_steps(found, begun, from, [&](const Setup& other) { return again(other, parameters); });
    found.simulations = simulations;
  }
  if (feed_override(begun) != feed_override(start)) {
    add_override(found, start, override_before);
  }
  return found;
}

Identification Recordings::fit_as_begun(const Setup& start, const std::vector<FitParameter>& parameters,
                                        const IdentifyOptions& options, const Stage& stage) {
  const auto begin = [&](const char* title) { return stage ? stage(title) : nullptr; };
  remarks_.assign(items_.size(), {});
  feed_shares_.assign(items_.size(), {});
  FitCases cases;
  for (std::size_t i = 0; i < items_.size(); ++i) {
    const Item& item = items_[i];
    if (item.trace == nullptr) {
      const auto table = std::make_shared<const SectionCase>(item.times, item.name, item.program);
      table->check_times(start);
      cases.push_back(table);
      continue;
    }
    const auto found = std::make_shared<const TraceCase>(item.trace, item.program, start, begin("matching"));
    remarks_[i] = found->found().remarks;
    feed_shares_[i] = found->feed_share();
    cases.push_back(found);
  }
  Setup begun = start;
  Progress* fitting = begin("fitting");
  const std::vector<DriveFit> drives = fit_drives(parameters, begun, fitting);
  std::vector<FitParameter> simulated = parameters;
  std::erase_if(simulated, is_drive_parameter);
  Identification found = identify(cases, begun, simulated, options, fitting);
  for (const DriveFit& drive : drives) {
    add_drive(found, drive, options.date);
  }
  return found;
}

std::vector<std::string> held_parameters(const Identification& found) {
  std::vector<std::string> held;
  for (const FitParameter& usual : usual_fit_parameters(found.setup)) {
    const bool looked_for = std::ranges::any_of(
        found.parameters, [&](const IdentifiedParameter& one) { return one.parameter.key == usual.key; });
    if (!looked_for) {
      held.push_back(usual.key);
    }
  }
  return held;
}

bool is_section_times_file(const std::filesystem::path& file) {
  constexpr std::size_t enough = 4096;
  std::string head(enough, '\0');
  std::ifstream in(file, std::ios::binary);
  in.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(in.gcount()));
  return is_section_times(head);
}

std::vector<SectionTime> read_section_times(const std::filesystem::path& file) {
  return parse_section_times(file_text(file, NC_("core", "table of section times"), 1), file.string());
}

std::string usual_machine_of(const std::string& model) {
  const MachineLibrary library = shipped_machines();
  for (const std::string& id : library.ids()) {
    const Machine machine = library.load(id);
    if (machine.model == model && machine.kinematics.empty()) {
      return id;
    }
  }
  return default_machine;
}

void sort_by_explanation(std::vector<Identification>& models) {
  std::ranges::stable_sort(models, {}, &Identification::residual);
}

bool explains_roughly(const Identification& found, const Identification& best) {
  constexpr double much_better = 2;
  return found.explains && found.residual > much_better * best.residual;
}

Machine identified_machine(const Identification& found, const std::filesystem::path& file) {
  Setup setup = found.setup;
  for (const IdentifiedParameter& one : found.parameters) {
    if (!found.explains && !one.told && one.value != one.start) {  // no information about the machine
      set_fit_value(setup, one.parameter, one.start);
      if (one.parameter.key.find('.') == std::string::npos) {
        setup.machine.settings.set(one.parameter.key, setup.settings.value(one.parameter.key));
      }
    }
  }
  Machine machine = std::move(setup.machine);
  if (file != "-") {
    machine.id = file.stem().string();
  }
  machine.name = machine.id;
  return machine;
}

std::string date_of_today() {
  const std::chrono::year_month_day date(
      std::chrono::floor<std::chrono::days>(std::chrono::system_clock::now()));
  return fmt::format("{:04}-{:02}-{:02}", static_cast<int>(date.year()), static_cast<unsigned>(date.month()),
                     static_cast<unsigned>(date.day()));
}

}  // namespace feedscope
