#include "ui/workbench/setting_texts.h"

#include <QCoreApplication>
#include <QLocale>
#include <QRegularExpression>
#include <algorithm>
#include <vector>

#include "core/analysis/study/sweep.h"
#include "ui/language/core_texts.h"
#include "ui/language/shown_numbers.h"
#include "ui/language/texts.h"

namespace feedscope::ui {

namespace {

QString setting_value(const SettingValue& value, const KeyUnit& unit) {
  const auto* number = std::get_if<double>(&value);
  return number != nullptr ? QLocale().toString(*number * unit.factor, 'g', 6)
                           : core_text(std::get<std::string>(value));
}

}  // namespace

QStringList setting_texts(const std::map<std::string, SettingValue>& values) {
  struct Group {
    std::string limit;  ///< "" for a setting of the model
    std::string key;    ///< the first
    QString unit;       ///< rotary axes have another one than linear ones
    QStringList axes;
    QStringList values;
  };
  std::vector<Group> groups;
  for (const auto& [key, value] : values) {
    const bool of_axis = key.size() > 2 && key[1] == '.';
    const std::string limit = of_axis ? key.substr(2) : std::string();
    const KeyUnit unit = key_unit(sweep_unit(key));
    const auto same = std::ranges::find_if(groups, [&](const Group& group) {
      return of_axis && group.limit == limit && group.unit == unit.text;
    });
    Group& group = same == groups.end() ? groups.emplace_back(Group{limit, key, unit.text, {}, {}}) : *same;
    group.axes.append(of_axis ? QString(QLatin1Char(key.front())) : QString());
    group.values.append(setting_value(value, unit));
  }
  QStringList texts;
  for (Group& group : groups) {
    QString title = setting_title(group.key);
    if (group.axes.size() > 1) {
      static const QRegularExpression axis_name(QStringLiteral("\\b[A-Z]\\b"));
      title.replace(axis_name, group.axes.join(QLatin1Char(' ')));
    }
    if (std::ranges::adjacent_find(group.values, std::ranges::not_equal_to()) == group.values.end()) {
      group.values = {group.values.front()};
    }
    const QString pattern =
        group.limit.empty() ? QStringLiteral("%1 %2 %3")
                            : QCoreApplication::translate("texts", "%1 %2 %3",
                                                          "limits of axes and their value: X Y Jerk 15 m/s³");
    texts.append(pattern.arg(title, group.values.join(QStringLiteral(" / ")), group.unit).trimmed());
  }
  return texts;
}

}  // namespace feedscope::ui
