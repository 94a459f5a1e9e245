#include "ui/report/report_numbers.h"

#include <QLocale>
#include <QRegularExpression>
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

QString fixed(double value, Dimension dimension, int metric_decimals) {
  return fixed(in_shown_unit(value, dimension), decimals_of(dimension, metric_decimals));
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
