// Any bytes as a machine file: it is written back as it was read, and a program runs on what could be built.
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/analysis/run/run.h"
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

/// Zero, or nothing at all, or from `least` to `largest`.
bool is_off_or_within(const Machine& machine, const char* setting, double least, double largest) {
  const double value = machine.settings.has(setting) ? machine.settings.number(setting) : 0;
  return value == 0 || (value >= least && value <= largest);
}

/// A motion that lasts long against the time of its filters takes millions of steps; the time-optimal bound
/// may run on the path of filters.
bool would_take_long(const Machine& machine) {
  if (machine.model != "ward" && machine.model != "optimal") {
    return false;
  }
  for (const AxisLimits& axis : machine.axes) {
    if (axis.velocity < 10 || axis.acceleration < 100 || axis.jerk < 1e3 || axis.jerk > 1e8 ||
        axis.blend_jerk < 1e3) {
      return true;
    }
  }
  return !is_off_or_within(machine, "contour_tolerance_mm", 1e-4, 10) ||
         !is_off_or_within(machine, "filter_time_s", 1e-3, 1) ||
         !is_off_or_within(machine, "filter_jerk_m_s3", 1, 1e5);
}

/// A model may refuse extreme settings, with a message.
void simulate(const Machine& machine) {
  const LoadedProgram loaded = load_program(program(), nullptr, reading_on({}, machine));
  const ControlModel& model = find_model(machine.model);
  try {
    const Run run = simulate_run(loaded, {machine, &model, complete_settings(model, machine)});
    fuzz::must(std::isfinite(run.summary.cycle_time) && run.summary.cycle_time > 0, "cycle time");
  } catch (const InputError&) {
    return;
  }
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
  if (!would_take_long(machine)) {
    simulate(machine);
  }
  return 0;
}
