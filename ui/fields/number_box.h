#pragma once

#include <QDoubleSpinBox>

namespace feedscope::ui {

/// The field for every number of the window that may have decimals, typed as number_of() reads it. Every key
/// is accepted: without one of them the number could change by a factor (QDoubleSpinBox alone reads 0,02 as 2
/// where the decimal sign is a point). The text stays as typed; if it is not a number within range and
/// decimals, the last value is restored and a tool tip says why.
class NumberBox : public QDoubleSpinBox {
  Q_OBJECT

 public:
  /// Without keyboard tracking: a value counts when it has been typed to its end.
  explicit NumberBox(QWidget* parent = nullptr);

  QValidator::State validate(QString& text, int& place) const override;
  double valueFromText(const QString& text) const override;
  /// Changes nothing, but says why the text is not taken.
  void fixup(QString& text) const override;

 private:
  bool is_special(const QString& text) const;
  /// Why a text is not taken; empty: it is.
  QString problem(const QString& text) const;
};

}  // namespace feedscope::ui
