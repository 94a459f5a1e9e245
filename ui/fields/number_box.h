#pragma once

#include <QDoubleSpinBox>

namespace feedscope::ui {

/// The field for all numbers with decimals in the window, read by number_of(). It accepts every key:
/// QDoubleSpinBox alone drops some, and so reads 0,02 as 2 where the decimal sign is a point. The text stays
/// as typed; if it is not a number within range and decimals, the last value is restored and a tooltip gives
/// the reason.
class NumberBox : public QDoubleSpinBox {
  Q_OBJECT

 public:
  /// Without keyboard tracking: a value takes effect when typing ends.
  explicit NumberBox(QWidget* parent = nullptr);

  QValidator::State validate(QString& text, int& place) const override;
  double valueFromText(const QString& text) const override;
  /// Changes nothing, but shows why the text is refused.
  void fixup(QString& text) const override;

 private:
  bool is_special(const QString& text) const;
  /// Reason why a text is refused; empty if it is accepted.
  QString problem(const QString& text) const;
};

}  // namespace feedscope::ui
