#include "core/analysis/run_notes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/analysis/control_dialect.h"
#include "core/analysis/ignored_path_control.h"

namespace feedscope {

std::string unused_work_offsets(const Program& program, const Machine& machine) {
  std::vector<std::string> names;
  const auto& read_with = program.given_offsets.all();
  for (const OffsetUse& use : program.work_offsets) {
    const auto of_machine = machine.work_offsets.all().find(use.name);
    const auto given = read_with.find(use.name);
    if (of_machine != machine.work_offsets.all().end() &&
        (given == read_with.end() || given->second != of_machine->second)) {
      names.push_back(use.name);
    }
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

std::vector<std::string> run_notes(const LoadedProgram& program, const Setup& setup) {
  std::vector<std::string> notes = ignored_path_control(program, setup);
  if (const auto mismatch = control_mismatch(setup.machine, program.program->dialect)) {
    notes.insert(notes.begin(), describe(*mismatch));
  }
  const std::string offsets = unused_work_offsets(*program.program, setup.machine);
  if (!offsets.empty()) {
    notes.insert(
        notes.begin(),
        fmt::format("The program was read with work offsets other than those of the machine ({}).", offsets));
  }
  return notes;
}

}  // namespace feedscope
