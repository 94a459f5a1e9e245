#include "core/models/shared_settings.h"

#include "core/base/translatable.h"

namespace feedscope {

SettingSpec used_tolerance_setting() {
  return {
      .key = "beta",
      .title = QT_TRANSLATE_NOOP("core", "Tolerance share beta"),
      .explanation = QT_TRANSLATE_NOOP("core",
                                       "Share of the contour tolerance that the control uses; 0 for the "
                                       "identified rule: 0.6 where an axis "
                                       "reverses in the corner, else 0.8."),
      .maximum = 1,
  };
}

void promise_tolerance(Guarantees& promised, const Settings& settings, double factor) {
  const bool exact = settings.number("contour_tolerance_mm") == 0;
  promised.contour = exact ? 0 : factor;
  promised.meets_tangent_ends = promised.meets_tangent_ends || exact;
  promised.stops_at_line_corners = exact;
}

void promise_smooth_curves(Guarantees& promised, const Settings& settings) {
  using Of = KeptLimit::Of;
  promised.smooths = true;
  promised.lays_curves = true;
  constexpr double between_places = 1.001;  // of SpanExtremes
  promised.curves.velocity = {Of::whole, between_places * promised.lines.velocity.factor};
  promised.curves.acceleration = {Of::whole, 1.05};
  promised.curves.jerk = {Of::whole, 1.1};
  if (settings.text("compressor") != "off") {
    promised.meets_tangent_ends = promised.contour == 0;
  }
}

}  // namespace feedscope
