#pragma once

#include "ui/views/program/input_bar.h"

class QLabel;
class QSpinBox;

namespace feedscope::ui {

class ProgramView;

/// Asks for a line number and goes there.
class GoToBar : public InputBar {
  Q_OBJECT

 public:
  /// `view` outlives this.
  explicit GoToBar(ProgramView& view, QWidget* parent = nullptr);

  /// Shows itself with the number of the line at the caret.
  void open();
  QSpinBox& input() { return *input_; }

 protected:
  void enter(Qt::KeyboardModifiers modifiers) override;

 private:
  ProgramView& view_;
  QSpinBox* input_;
  QLabel* count_;
};

}  // namespace feedscope::ui
