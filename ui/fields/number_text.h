#pragma once

#include <QLocale>
#include <QString>
#include <optional>

namespace feedscope::ui {

/// The number that a text typed in the window says; none for anything else ("1,000.5", "1.5 mm", "1e400"). A
/// point is a decimal sign in every language, a comma as well: "0.02" and "0,02" are the same. Where the
/// comma is not the decimal sign of the language, "1,000" could be one or one thousand and is none; where it
/// is, it is one.
std::optional<double> number_of(const QString& text, const QLocale& locale = QLocale());

/// Why number_of() gives none for `text` and what to type instead, in the user's language.
QString number_problem(const QString& text, const QLocale& locale = QLocale());

/// A number without group separators, as the user's language writes it, so that number_of() gives it back.
QString editable_text(double number);

}  // namespace feedscope::ui
