#pragma once

#include <QDoubleSpinBox>

namespace feedscope::ui {

/// The field for every number of the window that may have decimals. Decimal point and decimal comma mean the
/// same in every language and there are no group separators: QDoubleSpinBox alone takes the other language's
/// decimal sign for one, drops it and reads 0,02 as 2. What is typed stays as it is; where it is not a number
/// within range and decimals, the last value comes back.
class NumberBox : public QDoubleSpinBox {
  Q_OBJECT

 public:
  /// Without keyboard tracking: a value counts when it has been typed to its end.
  explicit NumberBox(QWidget* parent = nullptr);

  QValidator::State validate(QString& text, int& place) const override;
  double valueFromText(const QString& text) const override;
  /// Changes nothing.
  void fixup(QString& text) const override;

 private:
  QString bare(const QString& text) const;
  bool is_special(const QString& text) const;
};

}  // namespace feedscope::ui
