#include "ui/fields/number_box.h"

#include <QRegularExpression>
#include <algorithm>

#include "ui/fields/number_text.h"

namespace feedscope::ui {

NumberBox::NumberBox(QWidget* parent) : QDoubleSpinBox(parent) {
  setKeyboardTracking(false);
}

/// Without prefix, suffix and blanks around.
QString NumberBox::bare(const QString& text) const {
  QString number = text;
  if (!prefix().isEmpty() && number.startsWith(prefix())) {
    number.remove(0, prefix().size());
  }
  if (!suffix().isEmpty() && number.endsWith(suffix())) {
    number.chop(suffix().size());
  }
  return number.trimmed();
}

bool NumberBox::is_special(const QString& text) const {
  return !specialValueText().isEmpty() && text == specialValueText();
}

QValidator::State NumberBox::validate(QString& text, int&) const {
  if (is_special(text)) {
    return QValidator::Acceptable;
  }
  static const QRegularExpression typed(
      QRegularExpression::anchoredPattern(QStringLiteral(R"([+-]?[\d.,]*)")));
  const QString number = bare(text);
  if (!typed.match(number).hasMatch()) {
    return QValidator::Invalid;
  }
  // A sign or digit that a key would not enter were a factor of 10 or 100: it is entered, but not accepted.
  const auto value = number_of(number);
  const qsizetype point = std::max(number.indexOf('.'), number.indexOf(','));
  const bool is_fine_enough = point < 0 || number.size() - point - 1 <= decimals();
  const bool is_accepted = value && is_fine_enough && *value >= minimum() && *value <= maximum();
  return is_accepted ? QValidator::Acceptable : QValidator::Intermediate;
}

double NumberBox::valueFromText(const QString& text) const {
  return is_special(text) ? minimum() : number_of(bare(text)).value_or(value());
}

void NumberBox::fixup(QString&) const {}

}  // namespace feedscope::ui
