#include "core/machine/key_unit.h"

#include <fast_float/fast_float.h>
#include <fmt/format.h>

#include <cmath>
#include <string>

namespace feedscope {

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
  // Converting there and back may miss by one unit in the last place.
  for (const double neighbour : {std::nextafter(plain, 0.0), std::nextafter(plain, 2 * plain)}) {
    if (conversion.to_internal(neighbour) == internal) {
      return neighbour;
    }
  }
  return plain;
}

}  // namespace feedscope
