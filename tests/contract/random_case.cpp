#include "tests/contract/random_case.h"

#include <algorithm>
#include <cmath>

#include "core/analysis/run/run.h"
#include "tests/contract/random_program.h"

namespace feedscope::contract {
namespace {

void set_limit(Machine& machine, std::size_t axis, const char* limit, double value) {
  set_axis_limit(machine, coordinate_names[axis], limit, value);
}

Machine made_up_machine(Random& random) {
  Machine machine;
  machine.id = machine.name = machine.control = machine.reference = "random";
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double jerk = random.spread(1, 500);
    set_limit(machine, axis, "velocity", random.spread(2, 100));
    set_limit(machine, axis, "acceleration", random.spread(0.3, 20));
    set_limit(machine, axis, "jerk", jerk);
    set_limit(machine, axis, "blend_jerk", jerk * random.between(0.3, 1));
  }
  return machine;
}

Machine random_machine(Random& random) {
  static const std::vector<Machine> shipped = [] {
    std::vector<Machine> machines;
    const MachineLibrary library = shipped_machines();
    for (const std::string& id : library.ids()) {
      machines.push_back(library.load(id));
    }
    return machines;
  }();
  if (random.chance(0.3)) {
    return made_up_machine(random);
  }
  Machine machine = shipped[random.below(shipped.size())];
  if (random.chance(0.4)) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const SettingSpec& limit : axis_limit_specs()) {
        set_limit(machine, axis, limit.key.c_str(),
                  axis_limit(machine, coordinate_names[axis], limit.key) * random.between(0.3, 1.5));
      }
    }
  }
  return machine;
}

/// Within the bounds of `spec`, mostly of the size of `usual`.
double random_number(Random& random, const SettingSpec& spec, double usual) {
  constexpr double orders = 30;
  double value = usual;
  if (usual > 0) {
    value = random.spread(usual / orders, usual * orders);
  } else if (std::isfinite(spec.maximum)) {
    value = random.spread(spec.maximum * 1e-4, spec.maximum);
  }
  value = std::clamp(spec.whole ? std::round(value) : value, spec.minimum, spec.maximum);
  return !spec.minimum_allowed && value == spec.minimum ? usual : value;
}

void choose_settings(Random& random, Machine& machine, const ControlModel& model) {
  const Settings usual = complete_settings(model, machine);
  for (const SettingSpec& spec : settings_of(model)) {
    if (spec.optional) {
      continue;
    }
    SettingValue value = usual.values().find(spec.key)->second;
    if (!spec.choices.empty()) {
      value = spec.choices[random.below(spec.choices.size())];
    } else if (random.chance(0.35)) {
      value = random_number(random, spec, std::get<double>(value));
    }
    machine.settings.set(spec.key, value);
  }
}

}  // namespace

Case random_case(const std::string& model, std::uint64_t seed, std::uint64_t number) {
  Random random(seed, number);
  Case made;
  made.model = model;
  made.machine = random_machine(random);
  made.machine.model = model;
  choose_settings(random, made.machine, find_model(model));
  made.lines = RandomProgram(random).lines();
  return made;
}

}  // namespace feedscope::contract
