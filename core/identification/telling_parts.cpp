#include "core/identification/telling_parts.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/identification/part_times.h"

namespace feedscope {
namespace {

constexpr double clear_change = 0.002;  // of the time of a part: visible with a clock of 1 ms
constexpr double clear_share = 0.25;  // of the largest change: simple parts, which come first, have priority

/// Test program with the times of its parts.
class TimedProgram {
 public:
  TimedProgram() {
    made_ = identification_program({});
    ReadOptions reading;
    reading.dialect = IdentificationProgramRequest{}.dialect;
    program_ = load_program(std::make_shared<const SourceText>(SourceText("test program", made_.text)),
                            nullptr, reading);
  }

  const std::string& title(std::size_t part) const { return made_.parts[part].title; }
  /// Times in motion [s].
  std::vector<double> times(const Setup& setup) const {
    std::vector<double> times;
    for (const LineTime& part :
         part_times(made_, setup.model->simulate(program_.toolpath, setup.machine, setup.settings))) {
      times.push_back(part.time - part.dwell);
    }
    return times;
  }

 private:
  IdentificationProgram made_;
  LoadedProgram program_;
};

}  // namespace

std::vector<std::string> telling_parts(const Setup& setup, const std::vector<FitParameter>& parameters) {
  std::vector<std::string> parts(parameters.size());
  try {
    const TimedProgram program;
    const std::vector<double> as_it_is = program.times(setup);
    for (std::size_t p = 0; p < parameters.size(); ++p) {
      Setup halved = setup;
      set_fit_value(halved, parameters[p], fit_value(setup, parameters[p]) / 2);
      std::vector<double> changes = program.times(halved);
      for (std::size_t i = 0; i < changes.size(); ++i) {
        changes[i] = std::abs(changes[i] / as_it_is[i] - 1);
      }
      const double least = std::max(clear_change, clear_share * *std::ranges::max_element(changes));
      const auto first = std::ranges::find_if(changes, [&](double change) { return change >= least; });
      parts[p] =
          first == changes.end() ? "" : program.title(static_cast<std::size_t>(first - changes.begin()));
    }
  } catch (const InputError&) {
    // A machine without a limit of an axis that the test program moves: unknown.
  }
  return parts;
}

}  // namespace feedscope
