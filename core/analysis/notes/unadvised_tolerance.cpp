#include "core/analysis/notes/unadvised_tolerance.h"

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

Message shares_text(const UnadvisedTolerance& tolerance) {
  return tolerance.tolerance.is_range()
             ? message(NC_("core", "{:.0f} to {:.0f} %"), 100 * tolerance.least, 100 * tolerance.largest)
             : message(NC_("core", "{:.0f} %"), 100 * tolerance.least);
}

Message describe(const UnadvisedTolerance& tolerance) {
  const ToleranceInForce& in_force = tolerance.tolerance;
  const Message range = in_force.is_range() ? message(NC_("core", "{} ... {}"), in_force.min, in_force.max)
                                            : Message::number(range_text(in_force));
  return message(NC_("core",
                     "The contour tolerance of {} mm is {} of the estimated chord error of the short lines "
                     "({:.2g} mm); Heidenhain advises 110 to 200 %."),
                 range, shares_text(tolerance), tolerance.chord_error);
}

}  // namespace feedscope
