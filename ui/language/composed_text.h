#pragma once

#include <QString>
#include <string>

namespace feedscope::ui {

/// A text that the core composes of words, numbers and lists (guarantees of a control model, path control of
/// a program, notes on a run) in the user's language. Translates its pattern, then the parts in the pattern's
/// places; numbers get the decimal sign of the language. A text without a known pattern remains as it is, and
/// so does English.
QString composed_text(const std::string& text);
QString composed_text(const QString& text);

}  // namespace feedscope::ui
