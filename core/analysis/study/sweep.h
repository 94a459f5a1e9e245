#pragma once

#include <string>
#include <vector>

#include "core/analysis/run/run.h"

namespace feedscope {

/// Successive values of one setting.
struct Sweep {
  std::string key;             ///< "tolerance", an axis limit ("X.jerk") or a model setting
  std::vector<double> values;  ///< ascending or as given, each once; in the unit of the key
  bool logarithmic = false;    ///< equal ratios rather than equal steps
};

/// Limits on the values of one sweep and the runs of a study.
inline constexpr std::size_t max_sweep_values = 1000;
inline constexpr std::size_t max_study_runs = 10'000;

/// Reads KEY=FROM:TO:logN, KEY=FROM:TO:linN, or KEY=A;B;C, separated by semicolons or blanks. Numbers have a
/// decimal point; a comma is refused. Values of a range are rounded to 5 digits except its ends. Throws
/// InputError with text, value and bound.
Sweep parse_sweep(const std::string& text);
/// Makes N values from `from` to `to`. Throws InputError as parse_sweep does.
Sweep make_sweep(const std::string& key, double from, double to, std::size_t count, bool logarithmic);

/// Keys of a model: "tolerance", then assignable_keys().
std::vector<std::string> sweep_keys(const ControlModel& model);
/// Setting of a key, for an axis limit without the axis; an unknown key becomes the title, without unit.
SettingSpec sweep_spec(const std::string& key);
/// Unit of a key's values; "" for a plain number or an unknown key.
std::string sweep_unit(const std::string& key);

/// Sets `key` of a setup: the tolerance as --tolerance does, which replaces the program's own, others as
/// --set does. Throws InputError with key, value, bounds and the nearest key.
void apply_swept(const std::string& key, double value, Setup& setup);

}  // namespace feedscope
