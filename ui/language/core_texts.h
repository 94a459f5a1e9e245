#pragma once

#include <QString>
#include <string>

#include "core/limits/cause.h"

namespace feedscope::ui {

/// A fixed text of the core (title of a setting, summary of a model) in the user's language. Core marks its
/// texts in place (core/base/translatable.h).
QString core_text(const std::string& text);
/// cause_title() in the user's language.
QString shown_cause(Cause cause);

/// A unit of the core in print: "m/s³" for "m/s3".
QString unit_text(const std::string& unit);

}  // namespace feedscope::ui
