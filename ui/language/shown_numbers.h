#pragma once

#include <QString>
#include <QStringList>
#include <optional>
#include <string>

#include "ui/units/unit_system.h"

namespace feedscope::ui {

/// "metric", "inch": the unit systems that can be chosen.
QStringList unit_systems();
/// None for another text.
std::optional<UnitSystem> unit_system_of(const QString& name);
/// What the user chose for the window; metric at first.
UnitSystem chosen_unit_system();
void choose_unit_system(UnitSystem system);

/// "mm/min", "in/min"; empty for numbers without unit.
QString unit_of(Dimension dimension);
/// "Error [µm]"; the title alone for numbers without unit.
QString with_unit_of(const QString& title, Dimension dimension);

/// A value as the core has it in the unit shown.
inline double in_shown_unit(double value, Dimension dimension) {
  return value * shown(dimension).factor;
}
/// The other way.
inline double from_shown_unit(double number, Dimension dimension) {
  return number / shown(dimension).factor;
}

/// Decimals of a number that has `metric_decimals` in metric units, for about the same resolution.
int decimals_of(Dimension dimension, int metric_decimals);
/// By the locale with a true minus, without unit; -1: the usual decimals of the dimension.
QString number_text(double value, Dimension dimension, int metric_decimals = -1);
/// "12.5 mm".
QString amount_text(double value, Dimension dimension, int metric_decimals = -1);
/// With this many significant digits, as "0.02 mm".
QString significant_text(double value, Dimension dimension, int digits);

/// A key's unit of the core, as a setting has it ("mm", "m/s2"), in the unit system shown.
struct KeyUnit {
  QString text;       ///< as written: "m/s²", "in/s²"
  double factor = 1;  ///< number shown for a value in the key's unit
};
KeyUnit key_unit(const std::string& unit);

}  // namespace feedscope::ui
