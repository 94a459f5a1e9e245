// Any bytes as a machine file: it is written back as it was read, and a program runs on what could be built.
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/analysis/run.h"
#include "core/base/error.h"
#include "core/models/control_model.h"
#include "tests/fuzz/must.h"

using namespace feedscope;

namespace {

/// Corners, an arc, a smooth junction and a rapid, by the zero point of the machine if it gives one.
const std::shared_ptr<const SourceText>& program() {
  static const auto text = std::make_shared<const SourceText>(
      "fuzz.nc",
      "G21 G90 G17\nG55\nG0 X0 Y0 Z5\nG1 Z0 F3000\nX10\nY10\nG2 X20 Y20 I10 J0\nG1 X30\nX31 Y20.1\nG0 Z5\n");
  return text;
}

/// What a machine file may hold, the known models among it.
std::vector<SettingSpec> model_settings() {
  std::vector<SettingSpec> specs = all_model_settings();
  SettingSpec model;
  model.key = "model";
  for (const ControlModel* known : all_models()) {
    model.choices.push_back(known->info().id);
  }
  specs.push_back(model);
  return specs;
}

void simulate(const Machine& machine) {
  const LoadedProgram loaded = load_program(program(), nullptr, reading_on({}, machine));
  const ControlModel& model = find_model(machine.model);
  const Run run = simulate_run(loaded, {machine, &model, complete_settings(model, machine)});
  fuzz::must(std::isfinite(run.summary.cycle_time) && run.summary.cycle_time > 0, "cycle time");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::vector<SettingSpec> settings = model_settings();
  Machine machine;
  try {
    machine = parse_machine(std::string(data, data + size), "fuzz.toml", settings);
  } catch (const InputError&) {
    return 0;
  }
  const std::string written = write_machine(machine);
  fuzz::must(parse_machine(written, "written.toml", settings) == machine, "written:\n" + written);
  simulate(machine);
  return 0;
}
