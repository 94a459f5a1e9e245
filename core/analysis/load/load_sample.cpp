#include "core/analysis/load/load_sample.h"

#include "core/base/translatable.h"
#include "core/base/units.h"

namespace feedscope {
namespace {

constexpr std::array<std::string_view, load_state_count> state_keys{"cutting",      "rapid",  "dwell",
                                                                    "no_operation", "plunge", "no_spindle"};

constexpr std::array<LoadQuantity, load_quantity_count> quantities{{
    {"feed_per_tooth_mm", QT_TRANSLATE_NOOP("core", "feed per tooth"), "mm", &CuttingLoad::feed_per_tooth, 1},
    {"chip_thickness_um", QT_TRANSLATE_NOOP("core", "chip thickness"), "um", &CuttingLoad::chip_thickness,
     units::to_um(1)},
    {"cutting_force_mean_n", QT_TRANSLATE_NOOP("core", "mean force"), "N", &CuttingLoad::mean_force, 1},
    {"cutting_force_peak_n", QT_TRANSLATE_NOOP("core", "peak force"), "N", &CuttingLoad::peak_force, 1},
    {"torque_nm", QT_TRANSLATE_NOOP("core", "torque"), "N m", &CuttingLoad::torque, units::to_n_m(1)},
    {"power_kw", QT_TRANSLATE_NOOP("core", "power"), "kW", &CuttingLoad::power, units::to_kw(1)},
}};

template <std::size_t i, CuttingLoad LoadSample::*feed>
double value(const LoadSample& sample) {
  return (sample.*feed).*quantities[i].member * quantities[i].factor;
}

constexpr std::array<LoadColumn, 2 * load_quantity_count> columns{{
    {quantities[0].key, value<0, &LoadSample::predicted>},
    {quantities[1].key, value<1, &LoadSample::predicted>},
    {quantities[2].key, value<2, &LoadSample::predicted>},
    {quantities[3].key, value<3, &LoadSample::predicted>},
    {quantities[4].key, value<4, &LoadSample::predicted>},
    {quantities[5].key, value<5, &LoadSample::predicted>},
    {"feed_per_tooth_programmed_mm", value<0, &LoadSample::programmed>},
    {"chip_thickness_programmed_um", value<1, &LoadSample::programmed>},
    {"cutting_force_mean_programmed_n", value<2, &LoadSample::programmed>},
    {"cutting_force_peak_programmed_n", value<3, &LoadSample::programmed>},
    {"torque_programmed_nm", value<4, &LoadSample::programmed>},
    {"power_programmed_kw", value<5, &LoadSample::programmed>},
}};

}  // namespace

std::string_view key_of(LoadState state) {
  return state_keys[static_cast<std::size_t>(state)];
}

const std::array<LoadQuantity, load_quantity_count>& load_quantities() {
  return quantities;
}

std::span<const LoadColumn> load_columns() {
  return columns;
}

}  // namespace feedscope
