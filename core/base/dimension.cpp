#include "core/base/dimension.h"

#include <array>
#include <utility>

#include "core/base/translatable.h"
#include "core/base/units.h"

namespace feedscope {
namespace {

constexpr std::size_t dimension_count = static_cast<std::size_t>(Dimension::turn_change) + 1;
constexpr double inch = 1 / units::from_inch(1);
constexpr double pound_force = 4.4482216152605;                          // [N]
constexpr double horsepower = 550 * units::from_inch(12) * pound_force;  // [N mm/s]: 550 lbf ft a second

/// In the order of Dimension.
constexpr std::array<ShownUnit, dimension_count> metric{{
    {"", 1, 0},
    {"s", 1, 3},
    {"mm", 1, 3},
    {"1/mm", 1, 4},
    {"1/mm²", 1, 5},
    {"µm", 1000, 1},
    {"mm/min", units::to_mm_min(1), 0},
    {"m/min", units::to_m_min(1), 2},
    {"m/s²", units::to_m(1), 2},
    {"m/s³", units::to_m(1), 1},
    {"%", 100, 0},
    {"ms/mm", 1000, 3},
    {"°", units::to_deg(1), 2},
    {"N", 1, 0},
    {"N m", units::to_n_m(1), 2},
    {"kW", units::to_kw(1), 3},
    {QT_TRANSLATE_NOOP("core", "rev/min"), units::to_turns_min(1), 2},
    {QT_TRANSLATE_NOOP("core", "rev/s²"), units::to_turns(1), 2},
    {QT_TRANSLATE_NOOP("core", "rev/s³"), units::to_turns(1), 1},
    {"°/mm", units::to_deg(1), 3},
    {"°/mm²", units::to_deg(1), 4},
    {"°/mm³", units::to_deg(1), 5},
}};

/// In the order of Dimension; a thou is a thousandth of an inch.
constexpr std::array<ShownUnit, dimension_count> in_inches{{
    {"", 1, 0},
    {"s", 1, 3},
    {"in", inch, 4},
    {"1/in", 1 / inch, 3},
    {"1/in²", 1 / (inch * inch), 3},
    {"thou", 1000 * inch, 2},
    {"in/min", units::to_mm_min(inch), 1},
    {"in/min", units::to_mm_min(inch), 0},
    {"in/s²", inch, 1},
    {"in/s³", inch, 0},
    {"%", 100, 0},
    {"ms/in", 1000 / inch, 2},
    {"°", units::to_deg(1), 2},
    {"lbf", 1 / pound_force, 1},
    {"lbf ft", 1 / (pound_force * units::from_inch(12)), 2},
    {"hp", 1 / horsepower, 3},
    {QT_TRANSLATE_NOOP("core", "rev/min"), units::to_turns_min(1), 2},
    {QT_TRANSLATE_NOOP("core", "rev/s²"), units::to_turns(1), 2},
    {QT_TRANSLATE_NOOP("core", "rev/s³"), units::to_turns(1), 1},
    {"°/in", units::to_deg(1) / inch, 1},
    {"°/in²", units::to_deg(1) / (inch * inch), 0},
    {"°/in³", units::to_deg(1) / (inch * inch * inch), 0},
}};

}  // namespace

const ShownUnit& shown_unit(Dimension dimension, UnitSystem system) {
  const auto& shown = system == UnitSystem::metric ? metric : in_inches;
  return shown[static_cast<std::size_t>(dimension)];
}

}  // namespace feedscope
