#include "ui/models/texts.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>
#include <cmath>
#include <map>

#include "core/machine/contour_tolerance.h"
#include "core/machine/machine.h"
#include "core/models/control_model.h"
#include "ui/language/core_texts.h"

namespace feedscope::ui {

namespace {

/// English titles of the settings of all models, by key.
const std::map<std::string, std::string>& titles() {
  static const std::map<std::string, std::string> all = [] {
    std::map<std::string, std::string> collected;
    for (const ControlModel* model : all_models()) {
      for (const SettingSpec& spec : settings_of(*model)) {
        collected.emplace(spec.key, spec.title);
      }
    }
    return collected;
  }();
  return all;
}

}  // namespace

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
  if (key.size() > 2 && key[1] == '.') {
    const auto limit = std::ranges::find(axis_limit_specs(), key.substr(2), &SettingSpec::key);
    if (limit != axis_limit_specs().end()) {
      return QStringLiteral("%1 %2").arg(QChar(key[0])).arg(core_text(limit->title));
    }
  }
  const auto found = titles().find(key == "tolerance" ? std::string(contour_tolerance_key) : key);
  return found == titles().end() ? QString::fromStdString(key) : core_text(found->second);
}

QString clock_text(double seconds) {
  constexpr int minute = 60;
  if (seconds < minute) {
    return QCoreApplication::translate("texts", "%1 s").arg(QLocale().toString(seconds, 'f', 3));
  }
  constexpr int hour = 60;  // [minutes]
  const int minutes = static_cast<int>(seconds / minute);
  const double rest = std::floor((seconds - minute * minutes) * 10) / 10;
  const auto padded = [](const QString& text, double value) { return (value < 10 ? "0" : "") + text; };
  const QString rest_text = padded(QLocale().toString(rest, 'f', 1), rest);
  return minutes < hour ? QStringLiteral("%1:%2").arg(minutes).arg(rest_text)
                        : QStringLiteral("%1:%2:%3")
                              .arg(minutes / hour)
                              .arg(padded(QString::number(minutes % hour), minutes % hour), rest_text);
}

}  // namespace feedscope::ui
