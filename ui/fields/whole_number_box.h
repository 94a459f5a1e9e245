#pragma once

#include <QSpinBox>

namespace feedscope::ui {

/// The field for all whole numbers of the window. It refuses points and commas: QSpinBox alone drops the
/// group separators of the user's language and reads 1,5 as 15. Blanks may separate groups. The text stays as
/// typed; if it is not a whole number within range, the last value is restored and a tooltip gives the
/// reason.
class WholeNumberBox : public QSpinBox {
  Q_OBJECT

 public:
  /// Without keyboard tracking: a value takes effect when typing ends.
  explicit WholeNumberBox(QWidget* parent = nullptr);

  QValidator::State validate(QString& text, int& place) const override;
  int valueFromText(const QString& text) const override;
  /// With thin blanks between groups if isGroupSeparatorShown().
  QString textFromValue(int value) const override;
  /// Changes nothing, but shows why the text is refused.
  void fixup(QString& text) const override;

 private:
  /// Reason why a text is refused; empty if it is accepted.
  QString problem(const QString& text) const;
};

}  // namespace feedscope::ui
