#include "ui/language/failure_text.h"

#include <QRegularExpression>

#include "ui/language/composed_text.h"

namespace feedscope::ui {

QString failure_text(const std::string& what) {
  const QString text = QString::fromStdString(what);
  const QString whole = composed_text(text);
  static const QRegularExpression place(QStringLiteral("^(.+?:\\d+(:\\d+)?: )(.+)$"),
                                        QRegularExpression::DotMatchesEverythingOption);
  const QRegularExpressionMatch placed = place.match(text);
  return whole != text || !placed.hasMatch() ? whole : placed.captured(1) + composed_text(placed.captured(3));
}

QString failure_text(const std::exception& error) {
  return failure_text(std::string(error.what()));
}

}  // namespace feedscope::ui
