#include "core/analysis/run_notes.h"

#include "core/analysis/control_dialect.h"
#include "core/analysis/unfollowed.h"

namespace feedscope {

std::vector<std::string> run_notes(const LoadedProgram& program, const Setup& setup) {
  std::vector<std::string> notes = unfollowed(program, setup);
  if (const auto mismatch = control_mismatch(setup.machine, program.program->dialect)) {
    notes.insert(notes.begin(), describe(*mismatch));
  }
  return notes;
}

}  // namespace feedscope
