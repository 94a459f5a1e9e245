#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/analysis/load/load_sample.h"
#include "core/analysis/load/run_load.h"
#include "core/analysis/run/quantity.h"

namespace feedscope {

/// A number of CuttingLoad, with its quantity at the predicted feed.
struct LoadQuantity {
  double CuttingLoad::*member = nullptr;
  QuantityId id = QuantityId::chip_thickness;  ///< at the predicted feed
};
inline constexpr std::size_t load_quantity_count = 6;
const std::array<LoadQuantity, load_quantity_count>& load_quantities();
/// Converts to the unit of CSV columns.
double in_file_unit(const LoadQuantity& quantity, double value);

/// Figures of one number of CuttingLoad over a time of cutting, in its unit.
struct LoadFigure {
  double largest = 0;
  double time = 0;         ///< of the largest value [s]
  std::uint32_t line = 0;  ///< of the largest value
  double mean = 0;         ///< over the time
};
/// In the order of load_quantities().
using LoadFigureList = std::array<LoadFigure, load_quantity_count>;

/// Figure of a quantity at the predicted feed. `id`: in load_quantities().
const LoadFigure& figure_of(const LoadFigureList& figures, QuantityId id);

/// Totals of all operations, or of one.
struct LoadTotals {
  double cutting_time = 0;     ///< [s]
  LoadFigureList predicted{};  ///< means over the time of the run
  /// With the programmed feed everywhere: means over the time that this would take; `time` is that of the
  /// run.
  LoadFigureList programmed{};
};

/// A bound of an operation.
enum class LoadLimit : std::uint8_t { least_chip, max_chip, max_force, max_torque, max_power };
inline constexpr std::size_t load_limit_count = 5;
/// Key in load files: "min_chip_um" ...
std::string_view key_of(LoadLimit limit);
/// Title such as "chip below its least thickness (rubbing)".
std::string_view title_of(LoadLimit limit);
/// Quantity with this bound, an index of load_quantities().
std::size_t quantity_of(LoadLimit limit);

/// Stretch in which the predicted load is continuously beyond a bound.
struct LoadPlace {
  int operation = -1;
  double from = 0;               ///< [s]
  double to = 0;                 ///< [s]
  std::uint32_t first_line = 0;  ///< smallest
  std::uint32_t last_line = 0;   ///< largest
  double worst = 0;              ///< farthest beyond the bound, in the unit of its quantity
};

/// Excess over one of the bounds.
struct LimitFigures {
  static constexpr std::size_t most_places = 100;

  LoadLimit limit = LoadLimit::least_chip;
  double time = 0;                     ///< predicted load beyond the bound [s]
  double programmed_time = 0;          ///< the part of it with the load at the programmed feed beyond it [s]
  std::size_t count = 0;               ///< of places
  std::vector<LoadPlace> places = {};  ///< the longest ones, in order of time
};

struct LoadFigures {
  LoadTotals all;
  std::vector<LoadTotals> operations;           ///< in the order of LoadModel::operations()
  std::array<double, load_state_count> time{};  ///< by LoadState; adds up to the cycle time [s]
  std::vector<LimitFigures> limits;             ///< set by any operation
};

/// Samples ends and middles of steps of at most 2 ms, fewer at constant feed; means by Simpson's rule. Linear
/// in the pieces of the run. Throws Cancelled.
LoadFigures load_figures(const RunLoad& load, Progress* progress = nullptr);

/// Assumptions about the engagement and what is not modelled, in one sentence to show with every load.
std::string_view load_assumptions();

}  // namespace feedscope
