#pragma once

#include <QString>
#include <span>
#include <string>

namespace feedscope::ui {

/// A text of the core (title of a setting, limiting cause, summary of a model) in the user's language.
QString core_text(const std::string& text);

/// A unit of the core as it is written: "m/s³" for "m/s3".
QString unit_text(const std::string& unit);

/// The texts of the core that translators get to see.
std::span<const char* const> known_core_texts();

}  // namespace feedscope::ui
