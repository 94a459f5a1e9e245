#include "ui/language/remedy_text.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>

#include "core/machine/contour_tolerance.h"
#include "ui/language/core_texts.h"
#include "ui/language/shown_numbers.h"
#include "ui/language/significant.h"

namespace feedscope::ui {

namespace {

using Change = std::pair<std::string, SettingValue>;

bool of_axis(const std::string& key) {
  return key.size() > 2 && key[1] == '.';
}

QString percent(double factor) {
  return QStringLiteral("+%1").arg(significant_number(100 * (factor - 1), 3));
}

/// "Jerk of all axes +50 %" if `changes` begins with a limit of every axis; else nothing.
QString all_axes(std::span<const Change> changes, const Setup& setup) {
  constexpr std::size_t axes = 3;
  if (changes.size() < axes || !changes[0].first.starts_with("X.") || !changes[1].first.starts_with("Y.") ||
      !changes[2].first.starts_with("Z.")) {
    return {};
  }
  const std::string limit = changes[0].first.substr(2);
  const QString title = limit == "jerk" ? QCoreApplication::translate("WhyText", "Jerk of all axes")
                                        : QCoreApplication::translate("WhyText", "Acceleration of all axes");
  const double factor = std::get<double>(changes[0].second) / axis_limit(setup.machine, 'X', limit);
  return QCoreApplication::translate("WhyText", "%1 %2 %").arg(title, percent(factor));
}

QString one(const Change& change, std::optional<double> before, const Setup& setup) {
  const auto& [key, value] = change;
  const bool axis = of_axis(key);
  const std::string name = axis ? key.substr(2) : key;
  for (const SettingSpec& spec : axis ? axis_specs_of(key[0]) : settings_of(*setup.model)) {
    if (spec.key != name) {
      continue;
    }
    const QString title = core_text(spec.title);
    if (std::holds_alternative<std::string>(value)) {
      return QCoreApplication::translate("WhyText", "%1: %2")
          .arg(title, core_text(std::get<std::string>(value)));
    }
    const double now = axis     ? axis_limit(setup.machine, key[0], name)
                       : before ? *before
                                : number_in_force(setup.settings, spec);
    const KeyUnit unit = key_unit(spec.unit);
    return QCoreApplication::translate("WhyText", "%1 %2 → %3 %4")
        .arg(axis
                 ? QCoreApplication::translate("WhyText", "%1 of %2").arg(title, QString(QLatin1Char(key[0])))
                 : title,
             significant_number(now * unit.factor, 4),
             significant_number(std::get<double>(value) * unit.factor, 4), unit.text)
        .trimmed()
        .replace(QStringLiteral(" °"), QStringLiteral("°"));
  }
  return QString::fromStdString(key);
}

}  // namespace

QString remedy_text(const Remedy& remedy, const Setup& setup) {
  QStringList parts;
  if (!remedy.machine.empty()) {
    parts += QCoreApplication::translate("texts", "On %1", "a machine")
                 .arg(QString::fromStdString(shipped_machines().load(remedy.machine).name));
  }
  std::span<const Change> rest(remedy.changes);
  while (!rest.empty()) {
    if (const QString all = all_axes(rest, setup); !all.isEmpty()) {
      parts += all;
      rest = rest.subspan(3);
      continue;
    }
    // A tolerance also replaces the program's, which needs no mention.
    const bool said = rest.front().first == program_tolerance_key && remedy.changes.size() > 1;
    if (!said) {
      parts += one(rest.front(), is_tolerance(rest.front().first) ? remedy.before : std::nullopt, setup);
    }
    rest = rest.subspan(1);
  }
  return parts.join(QStringLiteral(", "));
}

}  // namespace feedscope::ui
