#include "ui/language/signed_number.h"

#include <QLocale>
#include <cmath>

namespace feedscope::ui {

QString signed_number(double value, int decimals) {
  const QLocale locale;
  const QString size = locale.toString(std::abs(value), 'f', decimals);
  if (size == locale.toString(0.0, 'f', decimals)) {
    return size;
  }
  return (value < 0 ? QStringLiteral("−") : QStringLiteral("+")) + size;
}

}  // namespace feedscope::ui
