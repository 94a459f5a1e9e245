#include "core/identification/recordings.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <fstream>

#include "core/base/error.h"
#include "core/identification/section_case.h"
#include "core/identification/trace_case.h"
#include "core/machine/file_text.h"

namespace feedscope {

namespace {

AxisDrive drive_of(const Machine& machine, char axis) {
  const AxisDrive* held = machine.drives.find(axis);
  return held == nullptr ? AxisDrive() : *held;
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

/// Of the axes that a drive parameter is of, put into the machine of `setup`.
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
      throw InputError(fmt::format(
          "{} is told by set and actual positions of {}; no trace has both: record the actual position too, "
          "and name it if need be, as --columns actual_{}=5:mm",
          parameter.key, axis, static_cast<char>(axis - 'X' + 'x')));
    }
    drives.push_back(drive_of_axis(axis, drive_of(setup.machine, axis), progress));
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

/// Found once for all models.
const DriveFit& Recordings::drive_of_axis(char axis, const AxisDrive& start, Progress* progress) {
  const auto known = std::ranges::find_if(
      drives_, [&](const FoundDrive& drive) { return drive.fit.axis == axis && drive.start == start; });
  if (known != drives_.end()) {
    return known->fit;
  }
  drives_.push_back({start, fit_drive(traces(), axis, start, progress)});
  return drives_.back().fit;
}

/// With the sources of its values.
void Recordings::add_drive(Identification& found, const DriveFit& drive, const std::string& date) const {
  std::string from;
  for (const Trace* trace : traces()) {
    if (trace->has_drive(static_cast<std::size_t>(drive.axis - 'X'))) {
      from += (from.empty() ? "" : ", ") + trace->name;
    }
  }
  from += date.empty() ? "" : ", " + date;
  auto& sources = found.setup.machine.provenance;
  for (const IdentifiedParameter& one : drive.parameters) {
    if (one.told) {
      sources.insert_or_assign(one.parameter.key, identified_source(one, from));
    } else if (drive.explains && one.value > 0) {
      sources.insert_or_assign(one.parameter.key, untold_source(one, from));
    }
    found.parameters.push_back(one);
    if (!one.told) {
      found.parameters.back().told_by = fmt::format("SINGLE MOVES OF {}", drive.axis);
    }
  }
  found.drives.push_back(drive);
}

Identification Recordings::fit(const Setup& start, const std::vector<FitParameter>& parameters,
                               const IdentifyOptions& options, const Stage& stage) {
  const auto begin = [&](const char* title) { return stage ? stage(title) : nullptr; };
  remarks_.assign(items_.size(), {});
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

bool is_section_times_file(const std::filesystem::path& file) {
  constexpr std::size_t enough = 4096;
  std::string head(enough, '\0');
  std::ifstream in(file, std::ios::binary);
  in.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(in.gcount()));
  return is_section_times(head);
}

std::vector<SectionTime> read_section_times(const std::filesystem::path& file) {
  return parse_section_times(file_text(file, "table of section times", 1), file.string());
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

Machine identified_machine(const Identification& found, const std::filesystem::path& file) {
  Machine machine = found.setup.machine;
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
