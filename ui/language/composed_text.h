#pragma once

#include <QString>
#include <string>

namespace feedscope::ui {

/// A text that the core puts together from words, numbers and lists (what a control model guarantees, path
/// control of a program, notes on a run) in the user's language. Its pattern is looked up, then what stands
/// in the places of the pattern; numbers get the decimal sign of the language. A text of no known pattern
/// stays as it is. English comes back unchanged.
QString composed_text(const std::string& text);
QString composed_text(const QString& text);

}  // namespace feedscope::ui
