#include "ui/models/texts.h"

#include <QCoreApplication>
#include <QLocale>
#include <cmath>

namespace feedscope::ui {

QString clock_text(double seconds) {
  constexpr int minute = 60;
  if (seconds < minute) {
    return QCoreApplication::translate("texts", "%1 s").arg(QLocale().toString(seconds, 'f', 3));
  }
  const int minutes = static_cast<int>(seconds / minute);
  const double rest = std::floor((seconds - minute * minutes) * 10) / 10;
  const QString padding = rest < 10 ? QStringLiteral("0") : QString();
  return QStringLiteral("%1:%2%3").arg(minutes).arg(padding, QLocale().toString(rest, 'f', 1));
}

}  // namespace feedscope::ui
