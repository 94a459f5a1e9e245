#include "ui/fields/number_box.h"

#include <algorithm>
#include <cmath>

#include "ui/fields/number_text.h"
#include "ui/fields/spin_box_text.h"

namespace feedscope::ui {

NumberBox::NumberBox(QWidget* parent) : QDoubleSpinBox(parent) {
  setKeyboardTracking(false);
}

bool NumberBox::is_special(const QString& text) const {
  return !specialValueText().isEmpty() && text == specialValueText();
}

QString NumberBox::problem(const QString& text) const {
  const QString typed = typed_in(*this, text);
  const auto value = number_of(typed, locale());
  if (!value) {
    return number_problem(typed, locale());
  }
  if (*value < minimum() || *value > maximum()) {
    return tr("“%1” is not between %2 and %3.")
        .arg(typed, editable_text(minimum()), editable_text(maximum()));
  }
  const double finest = std::pow(10, -decimals());
  const double scaled = *value / finest;
  const double rounding = 1e-9 * std::max(1.0, std::abs(scaled));
  return std::abs(scaled - std::round(scaled)) > rounding
             ? tr("“%1” has too many decimals; the smallest step is %2.").arg(typed, editable_text(finest))
             : QString();
}

QValidator::State NumberBox::validate(QString& text, int&) const {
  return is_special(text) || problem(text).isEmpty() ? QValidator::Acceptable : QValidator::Intermediate;
}

double NumberBox::valueFromText(const QString& text) const {
  return is_special(text) ? minimum() : number_of(typed_in(*this, text), locale()).value_or(value());
}

void NumberBox::fixup(QString& text) const {
  if (!is_special(text)) {
    say_refused(*this, problem(text));
  }
}

}  // namespace feedscope::ui
