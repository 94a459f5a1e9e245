#pragma once

#include <optional>
#include <string>

#include "core/analysis/contour/chord_error.h"
#include "core/analysis/run/tolerance_in_force.h"

namespace feedscope {

/// Contour tolerances in force outside of Heidenhain's advice, as shares of the chord error.
struct UnadvisedTolerance {
  ToleranceInForce tolerance;
  double chord_error = 0;  ///< [mm]
  double least = 0;        ///< of the tolerances
  double largest = 0;
};
std::optional<UnadvisedTolerance> unadvised_tolerance(const std::optional<ChordError>& error,
                                                      const std::optional<ToleranceInForce>& tolerance);
/// Text: "510 %", "90 to 510 %".
Message shares_text(const UnadvisedTolerance& tolerance);
/// As one sentence.
Message describe(const UnadvisedTolerance& tolerance);

}  // namespace feedscope
