#pragma once

#include <QSpinBox>

namespace feedscope::ui {

/// The field for every whole number of the window. Points and commas are not accepted: QSpinBox alone drops
/// those that separate groups of digits in the user's language and reads 1,5 as 15. Blanks may separate
/// groups. What is typed stays as it is; where it is not a whole number within range, the last value comes
/// back and a tool tip says why.
class WholeNumberBox : public QSpinBox {
  Q_OBJECT

 public:
  /// Without keyboard tracking: a value counts when it has been typed to its end.
  explicit WholeNumberBox(QWidget* parent = nullptr);

  QValidator::State validate(QString& text, int& place) const override;
  int valueFromText(const QString& text) const override;
  /// With thin blanks between groups if isGroupSeparatorShown().
  QString textFromValue(int value) const override;
  /// Changes nothing, but says why the text is not taken.
  void fixup(QString& text) const override;

 private:
  /// Why a text is not taken; empty: it is.
  QString problem(const QString& text) const;
};

}  // namespace feedscope::ui
