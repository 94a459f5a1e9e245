#include "ui/fields/number_list_field.h"

#include <QRegularExpression>

#include "ui/fields/number_text.h"

namespace feedscope::ui {

void NumberListField::set_numbers(const std::vector<double>& numbers) {
  QStringList texts;
  for (const double number : numbers) {
    texts.append(editable_text(number));
  }
  setText(texts.join(QLatin1Char(' ')));
}

QStringList NumberListField::parts() const {
  static const QRegularExpression separators(QStringLiteral("[\\s;]+"));
  return text().split(separators, Qt::SkipEmptyParts);
}

std::vector<double> NumberListField::numbers() const {
  std::vector<double> all;
  for (const QString& part : parts()) {
    const std::optional<double> number = number_of(part);
    if (!number) {
      return {};
    }
    all.push_back(*number);
  }
  return all;
}

QString NumberListField::problem() const {
  for (const QString& part : parts()) {
    if (!number_of(part)) {
      return number_problem(part);
    }
  }
  return parts().isEmpty() ? tr("Type one number or several with blanks between them.") : QString();
}

}  // namespace feedscope::ui
