#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/analysis/run/quantity.h"
#include "core/analysis/run/run.h"

namespace feedscope {

/// Whether a measure applies to single source lines.
enum class LineUse : std::uint8_t { none, optional, needed };

/// A measure of a run, as named in lessons. The key includes the unit: "cycle_time_s".
struct MeasureSpec {
  std::string key;
  std::string title;      ///< for display, without unit: "cycle time"
  std::string unit;       ///< "s"; "" for plain numbers
  int decimals = 0;       ///< for display
  double per_unit = 1;    ///< internal units in one `unit`
  std::uint8_t what = 0;  ///< kind of measurement; several specs may share one, in different units
  LineUse lines = LineUse::none;
  bool of_axis = false;                               ///< of one axis, or the largest of all
  bool of_cause = false;                              ///< needs a cause
  std::optional<QuantityId> quantity = std::nullopt;  ///< of a peak measure
};

/// Measure and the part of the run that it applies to.
struct Measure {
  const MeasureSpec* spec = nullptr;  ///< one of all_measures()
  std::string cause;                  ///< a cause key, or its beginning for several: "axis_jerk"
  char axis = 0;                      ///< 'X', 'Y', 'Z'; 0: the largest of all
  std::uint32_t first_line = 0;       ///< 1-based, inclusive; 0: the whole run
  std::uint32_t last_line = 0;
};

/// All measures, in all of their units.
const std::vector<MeasureSpec>& all_measures();
/// Throws InputError with the nearest valid name.
const MeasureSpec& find_measure(const std::string& key);
/// Indices in all_causes() for a cause key or a common beginning of several. Throws InputError with the
/// nearest valid name if there is none.
std::vector<std::size_t> causes_named(const std::string& key);

/// Title such as "peak acceleration of axis X, lines 3 to 5".
std::string title_of(const Measure& measure, const std::string& language = "en");
/// Value in the unit of the measure. Throws InputError if the run has no motion on the requested lines.
double measured(const Measure& measure, const Run& run);

}  // namespace feedscope
