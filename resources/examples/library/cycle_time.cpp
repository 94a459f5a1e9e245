// Cycle time of an NC program on a machine, and the three causes that limit the feed most of the time:
//   cycle_time PROGRAM [MACHINE]
#include <cstdlib>
#include <exception>
#include <iomanip>
#include <iostream>

#include "core/analysis/run/run.h"
#include "core/analysis/study/operations.h"

int main(int argc, char** argv) {
  using namespace feedscope;
  if (argc < 2) {
    std::cerr << "cycle_time: no program; write cycle_time PROGRAM [MACHINE]\n";
    return 2;
  }
  setenv("FEEDSCOPE_DATA", FEEDSCOPE_DATA, 0);  // where the shipped machines are
  try {
    const LoadedProgram program = load_program(argv[1]);
    SetupRequest request;
    request.machine = argc > 2 ? argv[2] : "";
    request.dialect = program.program->dialect;
    const Run run = simulate_run(program, make_setup(request));
    std::cout << run.setup.machine.name << ", " << run.setup.model->info().id << ": " << std::fixed
              << std::setprecision(3) << run.summary.cycle_time << " s\n";
    std::size_t shown = 0;
    for (const CauseShare& share : limiting_causes(run.summary)) {
      if (shown++ == 3) {
        break;
      }
      std::cout << std::setprecision(1) << 100 * share.share << " % " << cause_title(share.cause) << '\n';
    }
  } catch (const std::exception& error) {
    std::cerr << "cycle_time: " << error.what() << '\n';
    return 1;
  }
}
