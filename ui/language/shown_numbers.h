#pragma once

#include <QString>
#include <QStringList>
#include <optional>
#include <string>

#include "ui/units/unit_system.h"

namespace feedscope::ui {

/// The unit systems to choose from: "metric", "inch".
QStringList unit_systems();
/// None for an unknown name.
std::optional<UnitSystem> unit_system_of(const QString& name);
/// The user's choice for the window; initially metric.
UnitSystem chosen_unit_system();
void choose_unit_system(UnitSystem system);

/// "mm/min", "in/min"; empty for numbers without unit.
QString unit_of(Dimension dimension);
/// "Error [µm]"; the title alone for numbers without unit.
QString with_unit_of(const QString& title, Dimension dimension);

/// A core value in the shown unit.
inline double in_shown_unit(double value, Dimension dimension) {
  return value * shown(dimension).factor;
}
/// The inverse of in_shown_unit().
inline double from_shown_unit(double number, Dimension dimension) {
  return number / shown(dimension).factor;
}

/// Number of decimals in the shown unit for about the same resolution as `metric_decimals` in metric units.
int decimals_of(Dimension dimension, int metric_decimals);
/// By the locale with a true minus sign, without unit; -1: the usual decimals of the dimension.
QString number_text(double value, Dimension dimension, int metric_decimals = -1);
/// "12.5 mm".
QString amount_text(double value, Dimension dimension, int metric_decimals = -1);
/// With this many significant digits: "0.02 mm".
QString significant_text(double value, Dimension dimension, int digits);

/// The core's unit of a key, as in a setting ("mm", "m/s2"), in the shown unit system.
struct KeyUnit {
  QString text;       ///< as printed: "m/s²", "in/s²"
  double factor = 1;  ///< shown number per unit of the key
};
KeyUnit key_unit(const std::string& unit);

}  // namespace feedscope::ui
