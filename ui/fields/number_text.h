#pragma once

#include <QString>
#include <optional>

namespace feedscope::ui {

/// The number that a text says, by decimal point or decimal comma in every language: "0.02" and "0,02" are
/// the same. There are no group separators: "1,000" is one. None for anything else, "1,000.5" and "1.5 mm"
/// too.
std::optional<double> number_of(const QString& text);

/// A number without group separators, as the user's language writes it, so that number_of() gives it back.
QString editable_text(double number);

}  // namespace feedscope::ui
