#include "tests/contract/rotary_case.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "core/analysis/run/run.h"
#include "core/base/units.h"
#include "tests/contract/random.h"

namespace feedscope::contract {
namespace {

const std::vector<Machine>& rotary_machines() {
  static const std::vector<Machine> machines = [] {
    std::vector<Machine> found;
    const MachineLibrary library = shipped_machines();
    for (const std::string& id : library.ids()) {
      Machine machine = library.load(id);
      if (!machine.kinematics.empty()) {
        found.push_back(std::move(machine));
      }
    }
    return found;
  }();
  return machines;
}

/// Turns the axes of one machine, each within its travel.
class Turns {
 public:
  Turns(Random& random, const MachineKinematics& kinematics)
      : random_(random), kinematics_(kinematics), size_(random.spread(1e-4, 100)) {}

  Turns(Random& random, const MachineKinematics& kinematics, double size)
      : random_(random), kinematics_(kinematics), size_(size) {}

  std::string words() {
    std::string words;
    for (const RotaryAxis& axis : kinematics_.rotary) {
      if (random_.chance(0.3)) {
        continue;
      }
      constexpr double endless = 1e5;  // [deg]
      const double least = axis.minimum ? units::to_deg(*axis.minimum) : -endless;
      const double most = axis.maximum ? units::to_deg(*axis.maximum) : endless;
      double& at = at_[axis.name];
      at = std::clamp(at + random_.sign() * size_ * random_.between(0.2, 1), least, most);
      words += fmt::format(" {}{:.4f}", axis.name, at);
    }
    return words;
  }

 private:
  Random& random_;
  const MachineKinematics& kinematics_;
  double size_;  ///< of a turn [deg]
  std::map<char, double> at_;
};

}  // namespace

Case far_turn_case(const std::string& model, std::uint64_t seed, std::uint64_t number) {
  Random random(seed + 2, number);
  Case made;
  made.model = model;
  made.machine = rotary_machines()[random.below(rotary_machines().size())];
  made.machine.model = model;
  made.machine.kinematics.tool_length = random.between(20, 300);
  for (const char axis : {'x', 'y', 'z'}) {
    made.machine.settings.set(fmt::format("part_zero_{}_mm", axis), random.between(-600, 600));
  }
  made.machine.settings.set("contour_tolerance_mm", random.chance(0.3) ? 0 : random.spread(1e-3, 1));
  made.machine.settings.set("orientation_tolerance_deg", random.spread(1e-3, 5));
  for (RotaryAxis& axis : made.machine.kinematics.rotary) {
    axis.velocity *= random.between(0.3, 2);
  }
  Turns turns(random, made.machine.kinematics, random.spread(1, 5000));
  made.lines = {"G43.4 H1", "G0 X0 Y0 Z0"};
  const std::size_t blocks = 1 + random.below(8);
  const double length = random.spread(2, 300);
  for (std::size_t i = 0; i < blocks; ++i) {
    const auto place = [&] { return random.between(-1, 1) * length; };
    made.lines.push_back(fmt::format("{} X{:.3f} Y{:.3f} Z{:.3f}{} F{:.0f}",
                                     random.chance(0.15) ? "G0" : "G1", place(), place(), place(),
                                     random.chance(0.8) ? turns.words() : "", random.spread(500, 30000)));
  }
  return made;
}

Case rotary_case(const std::string& model, std::uint64_t seed, std::uint64_t number) {
  Case made = random_case(model, seed, number);
  Random random(seed + 1, number);
  const Settings settings = made.machine.settings;
  made.machine = rotary_machines()[random.below(rotary_machines().size())];
  made.machine.model = model;
  made.machine.settings = settings;
  for (const char axis : {'x', 'y', 'z'}) {
    made.machine.settings.set(fmt::format("part_zero_{}_mm", axis), random.between(-200, 200));
  }
  if (random.chance(0.5)) {
    made.machine.settings.set("orientation_tolerance_deg", random.spread(1e-3, 1));
  }
  for (RotaryAxis& axis : made.machine.kinematics.rotary) {
    axis.velocity *= random.between(0.3, 1.5);
    axis.acceleration *= random.between(0.3, 1.5);
    axis.jerk *= random.between(0.3, 1.5);
  }
  if (random.chance(0.5)) {
    made.machine.kinematics.tool_length = random.between(20, 200);
  }
  Turns turns(random, made.machine.kinematics);
  for (std::string& line : made.lines) {
    const bool moves = line.starts_with("G1 X") || line.starts_with("G1 Y") || line.starts_with("G1 Z");
    const bool places = line.starts_with("G0");
    if ((moves && random.chance(0.8)) || (places && random.chance(0.3))) {
      line += turns.words();
    }
  }
  made.lines.insert(made.lines.begin(), "G43.4 H1");
  return made;
}

}  // namespace feedscope::contract
