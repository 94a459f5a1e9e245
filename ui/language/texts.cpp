#include "ui/language/texts.h"

#include <QCoreApplication>
#include <QLocale>

#include "core/analysis/notes/tolerance_effect.h"
#include "core/analysis/study/sweep.h"
#include "core/base/short_text.h"
#include "ui/language/core_texts.h"
#include "ui/language/shown_numbers.h"

namespace feedscope::ui {

namespace {

/// `text` with the decimal sign of the locale and no line break between number and unit.
QString localised(const std::string& text) {
  return QString::fromStdString(text)
      .replace(QLatin1Char('.'), QLocale().decimalPoint())
      .replace(QLatin1Char(' '), QChar::Nbsp);
}

}  // namespace

QString clock_text(double seconds) {
  return localised(short_time(seconds));
}

QString share_text(double share) {
  return localised(short_percent(share));
}

QString setting_title(const std::string& key) {
  if (key == "program") {
    return QCoreApplication::translate("texts", "Program");
  }
  if (key == "machine") {
    return QCoreApplication::translate("texts", "Machine");
  }
  if (key == "model") {
    return QCoreApplication::translate("texts", "Control model");
  }
  const QString title = core_text(sweep_spec(key).title);
  const bool of_axis = key.size() > 2 && key[1] == '.';
  return of_axis ? QCoreApplication::translate("texts", "%1 %2", "an axis and its limit: X Jerk")
                       .arg(QChar(key[0]))
                       .arg(title)
                 : title;
}

QString setting_unit(const std::string& key) {
  if (key == "program" || key == "machine" || key == "model") {
    return {};
  }
  const std::string unit = sweep_unit(key);
  const KeyUnit shown = key_unit(unit);
  return shown.factor == 1 ? shown.text : QString::fromStdString(unit);
}

QString setting_title_with_unit(const std::string& key) {
  const QString unit = setting_unit(key);
  return unit.isEmpty() ? setting_title(key) : QStringLiteral("%1 [%2]").arg(setting_title(key), unit);
}

QString slower_tolerance_text(const SlowerTolerance& slower) {
  const QLocale locale;
  const auto seconds = [&](double value) { return locale.toString(value, 'f', 3); };
  const QString why = QCoreApplication::translate("texts",
                                                  ": a corner blend can take longer than a narrower one or "
                                                  "an exact stop, because it is passed at a limited "
                                                  "speed along its whole length");
  return QCoreApplication::translate(
             "texts", "A tolerance of %1 takes %2 s longer than %3, mostly due to %4 (%5 s more)%6.")
      .arg(significant_text(slower.wide_value, Dimension::length, 5), seconds(slower.more),
           significant_text(slower.narrow_value, Dimension::length, 5), shown_cause(slower.cause),
           seconds(slower.cause_more), is_by_blends(slower) ? why : QString());
}

}  // namespace feedscope::ui
