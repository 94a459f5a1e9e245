#include "ui/language/whole_units.h"

#include <QRegularExpression>

namespace feedscope::ui {

QString with_whole_units(QString text) {
  // Not within words, paths or encoded data, hence the characters that must not precede.
  static const QRegularExpression slash(
      QStringLiteral("((?<![\\w/.+-])(?:mm|m|µm|in|°|N|kN|U|rad|rev|1)|(?<=m/)min\\))/"
                     "(?=(?:min|s|mm|tooth|dent)(?:[²³23]|\\b))"),
      QRegularExpression::UseUnicodePropertiesOption);
  static const QRegularExpression space(
      QStringLiteral("(?<=[\\d_]) (?=(?:[%°]|(?:mm|µm|m|in|ms|s|min|N|kN)(?![\\w/])))"),
      QRegularExpression::UseUnicodePropertiesOption);
  constexpr char16_t joiner[] = u"\u2060";
  return text.replace(slash, QStringLiteral("\\1%1/%1").arg(QStringView(joiner)))
      .replace(space, QString(QChar(QChar::Nbsp)));
}

}  // namespace feedscope::ui
