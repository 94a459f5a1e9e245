#pragma once

#include <QString>
#include <string>

namespace feedscope::ui {

/// A text of the core (title of a setting, limiting cause, summary of a model) in the user's language. Core
/// marks its texts in place (core/base/translatable.h); those of an axis are one text with %1.
QString core_text(const std::string& text);

/// A unit of the core in print: "m/s³" for "m/s3".
QString unit_text(const std::string& unit);

}  // namespace feedscope::ui
