#pragma once

#include <string>
#include <string_view>

#include "core/base/typed_number.h"

namespace feedscope {

/// The unit that a key of machine files and --set carries, against the one inside.
struct KeyConversion {
  double (*to_internal)(double);
  double (*to_unit)(double);
};

/// The shortest decimal number in the unit that converts to exactly `internal`: 20, not 20.000000000000004.
double shortest_in_unit(double internal, const KeyConversion& conversion);

/// Reads a number as typed_number() does. It is in `unit`, that of a key ("m/s2"), unless another unit of
/// data sheets stands after it: "0.5 g" is 4.903325 m/s2 (1 g is 9.80665 m/s2, 3rd CGPM, 1901), and
/// "2 (m/min)/mm" is 33.33 1/s. The problem with another unit names those that are known.
TypedNumber typed_in_unit(std::string_view text, std::string_view unit);

/// The unit in which data sheets often give what a key has in `unit`: g for m/s2, (m/min)/mm for 1/s.
struct DataSheetUnit {
  std::string_view name;  ///< empty: the same
  double factor = 1;      ///< one of them in `unit`
};
DataSheetUnit data_sheet_unit(std::string_view unit);

}  // namespace feedscope
