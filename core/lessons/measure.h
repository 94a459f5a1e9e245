#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/analysis/quantity.h"
#include "core/analysis/run.h"

namespace feedscope {

/// Whether a measure is taken of single source lines.
enum class LineUse : std::uint8_t { none, optional, needed };

/// Something that can be measured of a run, as lessons name it. The key carries the unit: "cycle_time_s".
struct MeasureSpec {
  std::string key;
  std::string title;      ///< for people, without unit: "cycle time"
  std::string unit;       ///< "s"; "" for plain numbers
  int decimals = 0;       ///< that people want to read
  double per_unit = 1;    ///< internal units in one `unit`
  std::uint8_t what = 0;  ///< which measurement; several specs may share one, in different units
  LineUse lines = LineUse::none;
  bool of_axis = false;                               ///< may be of one axis, else the largest of all
  bool of_cause = false;                              ///< needs a cause
  std::optional<QuantityId> quantity = std::nullopt;  ///< of a peak
};

/// What to measure, and of which part of the run.
struct Measure {
  const MeasureSpec* spec = nullptr;  ///< one of all_measures()
  std::string cause;                  ///< a cause key, or its beginning for several: "axis_jerk"
  char axis = 0;                      ///< 'X', 'Y', 'Z'; 0: the largest of all
  std::uint32_t first_line = 0;       ///< 1-based, both included; 0: the whole run
  std::uint32_t last_line = 0;
};

/// Every measure in every unit it comes in.
const std::vector<MeasureSpec>& all_measures();
/// Throws InputError with the nearest valid name.
const MeasureSpec& find_measure(const std::string& key);
/// Positions in all_causes() that a cause key or the beginning of several stands for. Throws InputError with
/// the nearest valid name if there is none.
std::vector<std::size_t> causes_named(const std::string& key);

/// "peak acceleration of axis X, lines 3 to 5".
std::string title_of(const Measure& measure, const std::string& language = "en");
/// In the unit of the measure. Throws InputError if the run holds no motion on the lines asked for.
double measured(const Measure& measure, const Run& run);

}  // namespace feedscope
