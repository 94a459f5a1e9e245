#include "ui/workbench/tolerance_text.h"

#include <QCoreApplication>
#include <QLocale>

#include "ui/language/shown_numbers.h"

namespace feedscope::ui {

namespace {

struct Tolerance {
  Q_DECLARE_TR_FUNCTIONS(Tolerance)
};

QString number(double mm) {
  return QLocale().toString(in_shown_unit(mm, Dimension::length), 'g',
                            unit_system() == UnitSystem::metric ? 6 : 4);
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
  return QStringLiteral("%1 %2").arg(tolerance_range(tolerance), unit_of(Dimension::length));
}

QString tolerance_origin(const ToleranceInForce& tolerance) {
  switch (tolerance.set_by) {
    case ToleranceInForce::Setter::program:
      return Tolerance::tr("The tolerance comes from the program.");
    case ToleranceInForce::Setter::both:
      return Tolerance::tr(
          "The tolerance comes from the program for some blocks and from the setting for the others.");
    default:
      return Tolerance::tr("The tolerance comes from the setting, not from the program.");
  }
}

}  // namespace feedscope::ui
