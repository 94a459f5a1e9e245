#include "ui/language/significant.h"

#include <QLocale>
#include <algorithm>
#include <cmath>

namespace feedscope::ui {

QString significant_number(double value, int digits) {
  const double size = std::abs(value);
  constexpr double tiny = 1e-4;
  constexpr double huge = 1e12;
  if (size > 0 && (size < tiny || size >= huge)) {
    return QLocale().toString(value, 'g', digits);
  }
  const int before = size > 0 ? static_cast<int>(std::floor(std::log10(size))) + 1 : 1;
  QString text = QLocale().toString(value, 'f', std::clamp(digits - before, 0, digits + 3));
  const QString point = QLocale().decimalPoint();
  while (text.contains(point) && (text.endsWith('0') || text.endsWith(point))) {
    text.chop(1);
  }
  return text;
}

}  // namespace feedscope::ui
