#include "ui/fields/number_text.h"

#include <QCoreApplication>

#include "core/base/typed_number.h"

namespace feedscope::ui {

namespace {

/// The text for typed_number(): the printed minus sign and the decimal comma of the language replaced.
QString plain_text(const QString& text, const QLocale& locale) {
  QString plain = text.trimmed();
  plain.replace(QChar(0x2212), '-');
  const bool is_decimal_comma = locale.decimalPoint() == QLatin1String(",");
  if (is_decimal_comma && plain.count(',') == 1 && !plain.contains('.')) {
    plain.replace(',', '.');
  }
  return plain;
}

struct NumberText {
  Q_DECLARE_TR_FUNCTIONS(NumberText)
};

}  // namespace

std::optional<double> number_of(const QString& text, const QLocale& locale) {
  return typed_number(plain_text(text, locale).toStdString()).value;
}

QString number_problem(const QString& text, const QLocale& locale) {
  const QString plain = plain_text(text, locale);
  if (typed_number(plain.toStdString()).problem.empty()) {
    return NumberText::tr("“%1” is not a number.").arg(text.trimmed());
  }
  const QString whole = QString::fromStdString(without_thousands_separators(plain.toStdString()));
  if (whole.isEmpty()) {
    return NumberText::tr("“%1” has more than one decimal separator; type one number.").arg(text.trimmed());
  }
  if (plain.count(',') > 1 || plain.contains('.')) {
    return NumberText::tr("“%1” has more than one decimal separator or uses thousands separators; type %2.")
        .arg(text.trimmed(), whole);
  }
  QString with_point = plain;
  with_point.replace(',', '.');
  return NumberText::tr("“%1” could be %2 or %3; type one of these.").arg(text.trimmed(), with_point, whole);
}

QString editable_text(double number) {
  QLocale locale;
  locale.setNumberOptions(QLocale::OmitGroupSeparator);
  return locale.toString(number, 'g', QLocale::FloatingPointShortest);
}

}  // namespace feedscope::ui
