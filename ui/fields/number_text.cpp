#include "ui/fields/number_text.h"

#include <QLocale>
#include <QRegularExpression>
#include <cmath>

namespace feedscope::ui {

std::optional<double> number_of(const QString& text) {
  static const QRegularExpression pattern(
      QRegularExpression::anchoredPattern(QStringLiteral(R"([+-]?(\d+([.,]\d*)?|[.,]\d+)([eE][+-]?\d+)?)")));
  QString plain = text.trimmed();
  plain.replace(QChar(0x2212), '-');  // the minus of printed text
  if (!pattern.match(plain).hasMatch()) {
    return std::nullopt;
  }
  const double number = plain.replace(',', '.').toDouble();
  return std::isfinite(number) ? std::optional(number) : std::nullopt;
}

QString editable_text(double number) {
  QLocale locale;
  locale.setNumberOptions(QLocale::OmitGroupSeparator);
  return locale.toString(number, 'g', QLocale::FloatingPointShortest);
}

}  // namespace feedscope::ui
