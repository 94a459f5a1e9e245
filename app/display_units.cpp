#include "app/display_units.h"

#include <string>
#include <vector>

#include "ui/units/unit_system.h"

namespace feedscope {

void add_display_units_option(CLI::App& command) {
  const std::vector<std::string> systems{"metric", "inch"};
  command
      .add_option_function<std::string>(
          "--display-units",
          [](const std::string& system) {
            ui::use_unit_system(system == "inch" ? UnitSystem::inch : UnitSystem::metric);
          },
          "Units of the numbers shown: metric, inch; values of other options stay metric [metric]")
      ->check(CLI::IsMember(systems))
      ->type_name("UNITS");
}

std::string asked_display_units() {
  return ui::unit_system() == UnitSystem::inch ? "inch" : "";
}

}  // namespace feedscope
