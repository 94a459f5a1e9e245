#pragma once

#include <QJsonObject>

namespace feedscope::ui {

/// All texts of the page itself in the current language, by their English.
QJsonObject page_texts();
/// Units and factors of the page's numbers, by the names of page_data.js.
QJsonObject page_units();

}  // namespace feedscope::ui
