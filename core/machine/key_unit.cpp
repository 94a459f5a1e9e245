#include "core/machine/key_unit.h"

#include <fast_float/fast_float.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <vector>

namespace feedscope {
namespace {

/// An alternative unit for values of a key with the unit `of`; `factor` converts it.
struct WrittenUnit {
  std::string_view of;
  std::string_view name;
  double factor;
  bool in_data_sheets = false;
};

constexpr double standard_gravity = 9.80665;  // [m/s2], exact
constexpr double per_minute_in_metres = 1000.0 / 60;

constexpr auto written_units = std::to_array<WrittenUnit>({
    {"m/s2", "m/s2", 1},
    {"m/s2", "m/s²", 1},
    {"m/s2", "mm/s2", 1e-3},
    {"m/s2", "g", standard_gravity, true},
    {"m/s3", "m/s3", 1},
    {"m/s3", "m/s³", 1},
    {"m/s3", "mm/s3", 1e-3},
    {"m/s3", "g/s", standard_gravity},
    {"m/min", "m/min", 1},
    {"m/min", "mm/min", 1e-3},
    {"m/min", "m/s", 60},
    {"m/min", "mm/s", 0.06},
    {"1/s", "1/s", 1},
    {"1/s", "(m/min)/mm", per_minute_in_metres, true},
    {"1/s", "m/min/mm", per_minute_in_metres},
    {"ms", "ms", 1},
    {"ms", "s", 1e3},
    {"um", "um", 1},
    {"um", "µm", 1},
    {"um", "mm", 1e3},
});

std::string_view without_blanks_behind(std::string_view text) {
  while (!text.empty() && text.back() == ' ') {
    text.remove_suffix(1);
  }
  return text;
}

/// Number before a unit; empty if the text does not end with that unit.
std::string_view number_in_front(std::string_view text, std::string_view unit) {
  if (!text.ends_with(unit)) {
    return {};
  }
  const std::string_view front = text.substr(0, text.size() - unit.size());
  const bool runs_on = !front.empty() && std::isdigit(static_cast<unsigned char>(unit.front())) != 0 &&
                       front.back() != ' ';  // "301/s" is not 30 1/s
  return runs_on ? std::string_view() : without_blanks_behind(front);
}

/// Text after the longest number at the start: "lb" of "0.5 lb"; empty without a number.
std::string_view unit_behind(std::string_view text) {
  for (std::size_t size = text.size() - std::min<std::size_t>(text.size(), 1); size > 0; --size) {
    if (typed_number(without_blanks_behind(text.substr(0, size))).value) {
      text.remove_prefix(size);
      return text.substr(std::min(text.find_first_not_of(' '), text.size()));
    }
  }
  return {};
}

/// Names of the units that values of a key in `unit` may have; empty if there is only its own.
std::vector<std::string_view> names_of_units(std::string_view unit) {
  std::vector<std::string_view> names;
  for (const WrittenUnit& written : written_units) {
    if (written.of == unit) {
      names.push_back(written.name);
    }
  }
  return names;
}

}  // namespace

TypedNumber typed_in_unit(std::string_view text, std::string_view unit) {
  text = without_blanks_behind(text);
  for (const WrittenUnit& written : written_units) {
    const std::string_view front = written.of == unit ? number_in_front(text, written.name) : "";
    if (const auto number = typed_number(front).value; number && !front.empty()) {
      return {*number * written.factor, {}};
    }
  }
  TypedNumber plain = typed_number(text);
  const std::vector<std::string_view> known = names_of_units(unit);
  const std::string_view other = unit_behind(text);
  if (!plain.value && plain.problem.empty() && !known.empty() && !other.empty()) {
    plain.problem = message(NC_("core", "unknown unit '{}'; write the number in one of: {}"), other,
                            fmt::to_string(fmt::join(known, ", ")));
  }
  return plain;
}

DataSheetUnit data_sheet_unit(std::string_view unit) {
  for (const WrittenUnit& written : written_units) {
    if (written.of == unit && written.in_data_sheets) {
      return {written.name, written.factor};
    }
  }
  return {};
}

double shortest_in_unit(double internal, const KeyConversion& conversion) {
  const double plain = conversion.to_unit(internal);
  for (int digits = 1; digits <= 16; ++digits) {
    const std::string text = fmt::format("{:.{}g}", plain, digits);
    double rounded = 0;
    fast_float::from_chars(text.data(), text.data() + text.size(), rounded);
    if (conversion.to_internal(rounded) == internal) {
      return rounded;
    }
  }
  // A round trip of the conversion may be off by one unit in the last place.
  for (const double neighbour : {std::nextafter(plain, 0.0), std::nextafter(plain, 2 * plain)}) {
    if (conversion.to_internal(neighbour) == internal) {
      return neighbour;
    }
  }
  return plain;
}

}  // namespace feedscope
