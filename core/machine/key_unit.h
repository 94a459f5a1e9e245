#pragma once

#include <string>
#include <string_view>

#include "core/base/typed_number.h"

namespace feedscope {

/// Conversion between the unit of a key in machine files and --set, and the internal one.
struct KeyConversion {
  double (*to_internal)(double);
  double (*to_unit)(double);
};

/// Shortest decimal number in the unit that converts to exactly `internal`: 20, not 20.000000000000004.
double shortest_in_unit(double internal, const KeyConversion& conversion);

/// Reads a number as typed_number() does. It is in `unit`, that of a key ("m/s2"), unless another unit of
/// data sheets stands after it: "0.5 g" is 4.903325 m/s2 (1 g is 9.80665 m/s2, 3rd CGPM, 1901), and
/// "2 (m/min)/mm" is 33.33 1/s. The problem with another unit names those that are known.
TypedNumber typed_in_unit(std::string_view text, std::string_view unit);

/// Usual unit in data sheets for a key with `unit`: g for m/s2, (m/min)/mm for 1/s.
struct DataSheetUnit {
  std::string_view name;  ///< empty: no other unit
  double factor = 1;      ///< one of them in `unit`
};
DataSheetUnit data_sheet_unit(std::string_view unit);

}  // namespace feedscope
