#include "ui/fields/whole_number_box.h"

#include <QLocale>
#include <QRegularExpression>
#include <optional>

#include "ui/fields/spin_box_text.h"

namespace feedscope::ui {

namespace {

constexpr QChar thin_blank(0x202F);
constexpr int group = 3;

/// Blanks may group the digits.
std::optional<qlonglong> whole_number_of(QString text) {
  static const QRegularExpression blanks(QStringLiteral("\\s"),
                                         QRegularExpression::UseUnicodePropertiesOption);
  bool is_number = false;
  const qlonglong number = text.remove(blanks).toLongLong(&is_number);
  return is_number ? std::optional(number) : std::nullopt;
}

}  // namespace

WholeNumberBox::WholeNumberBox(QWidget* parent) : QSpinBox(parent) {
  setKeyboardTracking(false);
}

QString WholeNumberBox::problem(const QString& text) const {
  const QString typed = typed_in(*this, text);
  const auto value = whole_number_of(typed);
  if (!value) {
    return tr("“%1” is not a whole number.").arg(typed);
  }
  return *value < minimum() || *value > maximum()
             ? tr("“%1” is not between %2 and %3.")
                   .arg(typed, textFromValue(minimum()), textFromValue(maximum()))
             : QString();
}

QValidator::State WholeNumberBox::validate(QString& text, int&) const {
  return problem(text).isEmpty() ? QValidator::Acceptable : QValidator::Intermediate;
}

int WholeNumberBox::valueFromText(const QString& text) const {
  return static_cast<int>(whole_number_of(typed_in(*this, text)).value_or(value()));
}

QString WholeNumberBox::textFromValue(int value) const {
  QString text = QString::number(value);
  const qsizetype first = value < 0 ? 1 : 0;
  for (qsizetype place = text.size() - group; isGroupSeparatorShown() && place > first; place -= group) {
    text.insert(place, thin_blank);
  }
  return text;
}

void WholeNumberBox::fixup(QString& text) const {
  say_refused(*this, problem(text));
}

}  // namespace feedscope::ui
