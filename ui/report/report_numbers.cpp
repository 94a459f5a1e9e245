#include "ui/report/report_numbers.h"

#include <QLocale>
#include <QRegularExpression>
#include <algorithm>
#include <cmath>

namespace feedscope::ui {

QString fixed(double value, int decimals) {
  const QString text = QLocale::c().toString(value, 'f', decimals);
  const bool zero = text.startsWith('-') && !text.contains(QRegularExpression(QStringLiteral("[1-9]")));
  return zero ? text.mid(1) : text;
}

QString significant(double value, int digits) {
  const double size = std::abs(value);
  constexpr double plain_from = 1e-5;
  constexpr double plain_to = 1e12;
  if (size != 0 && (size < plain_from || size >= plain_to)) {
    return QLocale::c().toString(value, 'g', digits);
  }
  const int before = size > 0 ? static_cast<int>(std::floor(std::log10(size))) + 1 : 1;
  QString text = QLocale::c().toString(value, 'f', std::max(0, digits - before));
  if (text.contains('.')) {
    while (text.endsWith('0')) {
      text.chop(1);
    }
    if (text.endsWith('.')) {
      text.chop(1);
    }
  }
  return text;
}

QString fixed(double value, Dimension dimension, int metric_decimals) {
  return fixed(in_shown_unit(value, dimension), decimals_of(dimension, metric_decimals));
}

QString significant(double value, Dimension dimension, int digits) {
  return significant(in_shown_unit(value, dimension), digits);
}

QString error_number(double millimetres) {
  return significant(millimetres, Dimension::error, millimetres < 0.1 ? 3 : 4);
}

QString signed_percent(double share) {
  const QString size = fixed(std::abs(100 * share), 1);
  if (size == fixed(0, 1)) {
    return size;
  }
  return (share < 0 ? QStringLiteral("−") : QStringLiteral("+")) + size;
}

}  // namespace feedscope::ui
