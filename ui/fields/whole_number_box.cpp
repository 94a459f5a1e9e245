#include "ui/fields/whole_number_box.h"

#include <QRegularExpression>

namespace feedscope::ui {

namespace {

constexpr QChar thin_blank(0x202F);
constexpr int group = 3;

}  // namespace

WholeNumberBox::WholeNumberBox(QWidget* parent) : QSpinBox(parent) {
  setKeyboardTracking(false);
}

/// Without prefix, suffix and blanks.
QString WholeNumberBox::bare(const QString& text) const {
  QString number = text;
  if (!prefix().isEmpty() && number.startsWith(prefix())) {
    number.remove(0, prefix().size());
  }
  if (!suffix().isEmpty() && number.endsWith(suffix())) {
    number.chop(suffix().size());
  }
  static const QRegularExpression blanks(QStringLiteral("\\s"),
                                         QRegularExpression::UseUnicodePropertiesOption);
  return number.remove(blanks);
}

QValidator::State WholeNumberBox::validate(QString& text, int&) const {
  static const QRegularExpression typed(QRegularExpression::anchoredPattern(QStringLiteral("[+-]?[\\d.,]*")));
  const QString number = bare(text);
  if (!typed.match(number).hasMatch()) {
    return QValidator::Invalid;
  }
  bool is_number = false;
  const qlonglong value = number.toLongLong(&is_number);
  const bool is_accepted = is_number && value >= minimum() && value <= maximum();
  return is_accepted ? QValidator::Acceptable : QValidator::Intermediate;
}

int WholeNumberBox::valueFromText(const QString& text) const {
  bool is_number = false;
  const int number = bare(text).toInt(&is_number);
  return is_number ? number : value();
}

QString WholeNumberBox::textFromValue(int value) const {
  QString text = QString::number(value);
  const qsizetype first = value < 0 ? 1 : 0;
  for (qsizetype place = text.size() - group; isGroupSeparatorShown() && place > first; place -= group) {
    text.insert(place, thin_blank);
  }
  return text;
}

void WholeNumberBox::fixup(QString&) const {}

}  // namespace feedscope::ui
