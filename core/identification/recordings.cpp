#include "core/identification/recordings.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <fstream>

#include "core/identification/section_case.h"
#include "core/identification/trace_case.h"
#include "core/machine/file_text.h"

namespace feedscope {

void Recordings::add(std::shared_ptr<const Trace> trace, const LoadedProgram& program) {
  items_.push_back({std::move(trace), {}, {}, program});
}

void Recordings::add(std::vector<SectionTime> times, const std::string& name, const LoadedProgram& program) {
  items_.push_back({nullptr, std::move(times), name, program});
}

Identification Recordings::fit(const Setup& start, const std::vector<FitParameter>& parameters,
                               const IdentifyOptions& options, const Stage& stage) {
  const auto begin = [&](const char* title) { return stage ? stage(title) : nullptr; };
  remarks_.assign(items_.size(), {});
  FitCases cases;
  for (std::size_t i = 0; i < items_.size(); ++i) {
    const Item& item = items_[i];
    if (item.trace == nullptr) {
      cases.push_back(std::make_shared<const SectionCase>(item.times, item.name, item.program));
      continue;
    }
    const auto found = std::make_shared<const TraceCase>(item.trace, item.program, start, begin("matching"));
    remarks_[i] = found->found().remarks;
    cases.push_back(found);
  }
  return identify(cases, start, parameters, options, begin("fitting"));
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
