#include "ui/language/core_texts.h"

#include <QCoreApplication>
#include <QRegularExpression>

namespace feedscope::ui {

QString core_text(const std::string& text) {
  const QString shown = QCoreApplication::translate("core", text.c_str());
  const QString as_written = QString::fromStdString(text);
  if (shown != as_written) {
    return shown;
  }
  // "jerk of axis X" is translated as "jerk of axis %1".
  static const QRegularExpression axis(QStringLiteral("\\b[XYZABC]\\b"));
  const QRegularExpressionMatch match = axis.match(as_written);
  if (!match.hasMatch()) {
    return as_written;
  }
  QString pattern = as_written;
  pattern.replace(match.capturedStart(), 1, QStringLiteral("%1"));
  return QCoreApplication::translate("core", pattern.toUtf8().constData())
      .replace(QStringLiteral("%1"), match.captured());
}

QString unit_text(const std::string& unit) {
  return QString::fromStdString(unit)
      .replace(QStringLiteral("s2"), QStringLiteral("s²"))
      .replace(QStringLiteral("s3"), QStringLiteral("s³"));
}

}  // namespace feedscope::ui
