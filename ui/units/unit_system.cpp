#include "ui/units/unit_system.h"

#include <atomic>

namespace feedscope::ui {

namespace {

/// Other threads also make reports and pictures.
std::atomic<UnitSystem> in_use = UnitSystem::metric;

}  // namespace

UnitSystem unit_system() {
  return in_use;
}

void use_unit_system(UnitSystem system) {
  in_use = system;
}

const ShownUnit& shown(Dimension dimension) {
  return shown_unit(dimension, unit_system());
}

}  // namespace feedscope::ui
