#pragma once

#include <QJsonObject>

namespace feedscope::ui {

/// Every text of the page's own in the language in force, by its English.
QJsonObject page_texts();
/// Units and factors of what the page shows, by the names of page_data.js.
QJsonObject page_units();

}  // namespace feedscope::ui
