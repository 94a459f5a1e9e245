#include "ui/report/whole_units.h"

#include <QRegularExpression>

namespace feedscope::ui {

QString with_whole_units(QString text) {
  static const QRegularExpression slash(
      QStringLiteral("(\\d[ \\x{a0}](?:mm|m|µm|in|°|N|kN|U|rad))/(?=(?:min|s|mm|tooth|dent)(?:[²³23]|\\b))"),
      QRegularExpression::UseUnicodePropertiesOption);
  constexpr char16_t joiner[] = u"\u2060";
  return text.replace(slash, QStringLiteral("\\1%1/%1").arg(QStringView(joiner)));
}

}  // namespace feedscope::ui
