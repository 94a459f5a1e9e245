#include "ui/language/shown_numbers.h"

#include <QLocale>
#include <QSettings>
#include <algorithm>
#include <array>
#include <utility>

#include "ui/language/core_texts.h"
#include "ui/language/signed_number.h"

namespace feedscope::ui {

namespace {

const QString settings_key = QStringLiteral("units");

/// Units of keys that depend on the unit system or the language, with their dimension.
constexpr auto key_dimensions = std::to_array<std::pair<std::string_view, Dimension>>({
    {"mm", Dimension::length},
    {"um", Dimension::error},
    {"µm", Dimension::error},
    {"mm/min", Dimension::feed},
    {"m/min", Dimension::velocity},
    {"m/s2", Dimension::acceleration},
    {"m/s3", Dimension::jerk},
    {"deg", Dimension::angle},
    {"rev/min", Dimension::turning},
    {"rev/s2", Dimension::turning_acceleration},
    {"rev/s3", Dimension::turning_jerk},
});

}  // namespace

QStringList unit_systems() {
  return {QStringLiteral("metric"), QStringLiteral("inch")};
}

std::optional<UnitSystem> unit_system_of(const QString& name) {
  const qsizetype index = unit_systems().indexOf(name);
  return index < 0 ? std::nullopt : std::optional(static_cast<UnitSystem>(index));
}

UnitSystem chosen_unit_system() {
  return unit_system_of(QSettings().value(settings_key).toString()).value_or(UnitSystem::metric);
}

void choose_unit_system(UnitSystem system) {
  QSettings().setValue(settings_key, unit_systems()[static_cast<qsizetype>(system)]);
}

QString unit_of(Dimension dimension) {
  const std::string text(shown(dimension).text);
  return text.empty() ? QString() : core_text(text);
}

QString with_unit_of(const QString& title, Dimension dimension) {
  const QString unit = unit_of(dimension);
  return unit.isEmpty() ? title : QStringLiteral("%1 [%2]").arg(title, unit);
}

int decimals_of(Dimension dimension, int metric_decimals) {
  const int usual = shown_unit(dimension).decimals;
  const int asked = metric_decimals < 0 ? usual : metric_decimals;
  return std::max(0, asked + shown(dimension).decimals - usual);
}

QString number_text(double value, Dimension dimension, int metric_decimals) {
  const int decimals = decimals_of(dimension, metric_decimals);
  const double number = in_shown_unit(value, dimension);
  return number < 0 ? signed_number(number, decimals) : QLocale().toString(number, 'f', decimals);
}

QString amount_text(double value, Dimension dimension, int metric_decimals) {
  return QStringLiteral("%1 %2")
      .arg(number_text(value, dimension, metric_decimals), unit_of(dimension))
      .trimmed();
}

QString significant_text(double value, Dimension dimension, int digits) {
  return QStringLiteral("%1 %2")
      .arg(QLocale().toString(in_shown_unit(value, dimension), 'g', digits), unit_of(dimension))
      .trimmed();
}

KeyUnit key_unit(const std::string& unit) {
  const auto found = std::ranges::find(key_dimensions, std::string_view(unit),
                                       &std::pair<std::string_view, Dimension>::first);
  if (found == key_dimensions.end()) {
    return {unit_text(unit), 1};
  }
  return {unit_of(found->second), shown(found->second).factor / shown_unit(found->second).factor};
}

}  // namespace feedscope::ui
