#include "ui/models/tolerance_text.h"

#include <QCoreApplication>
#include <QLocale>

namespace feedscope::ui {

namespace {

struct Tolerance {
  Q_DECLARE_TR_FUNCTIONS(Tolerance)
};

QString number(double mm) {
  return QLocale().toString(mm, 'g', 6);
}

}  // namespace

QString tolerance_range(const std::optional<ToleranceInForce>& tolerance) {
  if (!tolerance) {
    return QStringLiteral("–");
  }
  return tolerance->is_range() ? QStringLiteral("%1 … %2").arg(number(tolerance->min), number(tolerance->max))
                               : number(tolerance->max);
}

QString tolerance_text(const ToleranceInForce& tolerance) {
  return Tolerance::tr("%1 mm").arg(tolerance_range(tolerance));
}

QString tolerance_origin(const ToleranceInForce& tolerance) {
  switch (tolerance.set_by) {
    case ToleranceInForce::Setter::program:
      return Tolerance::tr("The tolerance is set by the program.");
    case ToleranceInForce::Setter::both:
      return Tolerance::tr(
          "The tolerance is set by the program on some blocks, by the setting on the others.");
    default:
      return Tolerance::tr("The tolerance is set by the setting, not by the program.");
  }
}

}  // namespace feedscope::ui
