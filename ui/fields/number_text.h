#pragma once

#include <QLocale>
#include <QString>
#include <optional>

namespace feedscope::ui {

/// The number in a text typed in the window; none for anything else ("1,000.5", "1.5 mm", "1e400"). Point and
/// comma are decimal signs in every language: "0.02" and "0,02" are equal. Where the language's decimal sign
/// is not the comma, "1,000" is ambiguous (one or one thousand) and refused; where it is, it means one.
std::optional<double> number_of(const QString& text, const QLocale& locale = QLocale());

/// Reason why number_of() refuses `text`, and what to type instead, in the user's language.
QString number_problem(const QString& text, const QLocale& locale = QLocale());

/// A number without group separators in the format of the user's language, so that number_of() returns it.
QString editable_text(double number);

}  // namespace feedscope::ui
