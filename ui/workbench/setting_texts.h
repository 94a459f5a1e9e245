#pragma once

#include <QStringList>
#include <map>
#include <string>

#include "core/machine/settings.h"

namespace feedscope::ui {

/// Settings by their keys with these values, one text each: "Contour tolerance 0.02 mm". The same limit of
/// several axes is one: "X Y Z Jerk 20 m/s³", "X Z Jerk 20 / 10 m/s³".
QStringList setting_texts(const std::map<std::string, SettingValue>& values);

}  // namespace feedscope::ui
