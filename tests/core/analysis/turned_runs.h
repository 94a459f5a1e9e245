#pragma once

#include <fmt/format.h>

#include <random>
#include <string>
#include <vector>

#include "core/analysis/rotary/rotary_course.h"
#include "core/analysis/run/run.h"
#include "core/base/units.h"
#include "tests/support/folders.h"

/// Runs on a shipped five-axis machine, for tests of what its rotary axes do.
namespace feedscope::test {

using TurnedRun = feedscope::Run;  // in tests Run is a member of testing::Test

/// Of a program in Sinumerik code.
inline TurnedRun turned(const std::string& text, const std::string& model = "essid",
                        const std::vector<std::string>& assignments = {}) {
  SetupRequest request;
  request.machine = "five-axis-table-ac";
  request.model = model;
  request.assignments = assignments;
  Setup setup = make_setup(request);
  ReadOptions options;
  options.dialect = Dialect::sinumerik;
  options.unit = LengthUnit::mm;
  const auto source = std::make_shared<const SourceText>("test.mpf", text);
  return simulate_run(load_program(source, nullptr, reading_on(options, setup.machine)), setup);
}

inline RotarySample at(const TurnedRun& run, double time) {
  return run.sources.rotary->at(run.trajectory->state(time));
}

/// A shipped program on the machine with a table that tilts.
inline TurnedRun run_of(const char* file, const std::vector<std::string>& assignments = {},
                        const char* model = "essid") {
  SetupRequest request;
  request.machine = "five-axis-table-ac";
  request.model = model;
  request.assignments = assignments;
  const feedscope::Setup setup = make_setup(request);
  const std::string path = std::string(FEEDSCOPE_SOURCE_DIR "/resources/programs/") + file;
  return simulate_run(load_program(path, nullptr, reading_on({}, setup.machine)), setup);
}

inline std::string random_turns(unsigned seed) {
  std::mt19937 random(seed);
  const auto any = [&](double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(random);
  };
  std::string text = "G17 G90 F3000\nTRAORI\n";
  for (int i = 0; i < 60; ++i) {
    const double which = any(0, 1);
    if (which < 0.1) {
      text += fmt::format("G0 A{:.3f} C{:.3f}\n", any(-60, 45), any(-170, 170));
    } else if (which < 0.2) {
      text += fmt::format("G0 X{:.3f} Y{:.3f} C{:.3f}\n", any(-50, 50), any(-50, 50), any(-90, 90));
    } else if (which < 0.3) {
      text += fmt::format("G1 X{:.3f} Y{:.3f}\n", any(-50, 50), any(-50, 50));
    } else {
      text += fmt::format("G1 X{:.3f} Y{:.3f} Z{:.3f} A{:.3f} C{:.3f}\n", any(-50, 50), any(-50, 50),
                          any(-10, 10), any(-60, 45), any(-170, 170));
    }
  }
  return text;
}

}  // namespace feedscope::test
