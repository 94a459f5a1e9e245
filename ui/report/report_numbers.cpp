#include "ui/report/report_numbers.h"

#include <QLocale>
#include <QRegularExpression>
#include <algorithm>
#include <cmath>

#include "ui/language/signed_number.h"
#include "ui/report/report_words.h"

namespace feedscope::ui {

QString fixed(double value, int decimals) {
  const QString text = QLocale().toString(value, 'f', decimals);
  const QString minus = QLocale().negativeSign();
  const bool zero = text.startsWith(minus) && !text.contains(QRegularExpression(QStringLiteral("[1-9]")));
  return zero ? text.mid(minus.size()) : text;
}

QString significant(double value, int digits) {
  const double size = std::abs(value);
  constexpr double plain_from = 1e-5;
  constexpr double plain_to = 1e12;
  if (size != 0 && (size < plain_from || size >= plain_to)) {
    return QLocale().toString(value, 'g', digits);
  }
  const int before = size > 0 ? static_cast<int>(std::floor(std::log10(size))) + 1 : 1;
  const QLocale locale;
  QString text = locale.toString(value, 'f', std::max(0, digits - before));
  const QString point = locale.decimalPoint();
  if (text.contains(point)) {
    while (text.endsWith('0')) {
      text.chop(1);
    }
    if (text.endsWith(point)) {
      text.chop(point.size());
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

QString percent(double share, int decimals) {
  return std::isfinite(share) ? fixed(100 * share, decimals) : QStringLiteral("–");
}

QString error_number(double millimetres) {
  return number_text(millimetres, Dimension::error);
}

QString signed_percent(double share) {
  return signed_number(100 * share, 1);
}

QString date_text(const QDateTime& date) {
  return date.isValid() ? QLocale().toString(date.date(), ReportWords::tr("yyyy-MM-dd", "date")) : QString();
}

}  // namespace feedscope::ui
