#include "core/analysis/notes/unadvised_tolerance.h"

#include <fmt/format.h>

namespace feedscope {

std::optional<UnadvisedTolerance> unadvised_tolerance(const std::optional<ChordError>& error,
                                                      const std::optional<ToleranceInForce>& tolerance) {
  if (!error || !tolerance) {
    return std::nullopt;
  }
  const UnadvisedTolerance found{*tolerance, error->value, tolerance->min / error->value,
                                 tolerance->max / error->value};
  return is_advised_tolerance(found.least) && is_advised_tolerance(found.largest) ? std::nullopt
                                                                                  : std::optional(found);
}

std::string shares_text(const UnadvisedTolerance& tolerance) {
  return tolerance.tolerance.is_range()
             ? fmt::format("{:.0f} to {:.0f} %", 100 * tolerance.least, 100 * tolerance.largest)
             : fmt::format("{:.0f} %", 100 * tolerance.least);
}

std::string describe(const UnadvisedTolerance& tolerance) {
  return fmt::format(
      "The contour tolerance of {} mm is {} of the estimated chord error of the short lines ({:.2g} mm); "
      "Heidenhain advises 110 to 200 %.",
      range_text(tolerance.tolerance), shares_text(tolerance), tolerance.chord_error);
}

}  // namespace feedscope
