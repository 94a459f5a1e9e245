#pragma once

#include "ui/program_text/input_bar.h"

class QLabel;

namespace feedscope::ui {

class WholeNumberBox;

class ProgramView;

/// Asks for a line number and goes there.
class GoToBar : public InputBar {
  Q_OBJECT

 public:
  /// `view` outlives this.
  explicit GoToBar(ProgramView& view, QWidget* parent = nullptr);

  /// Opens with the number of the caret's line.
  void open();
  WholeNumberBox& input() { return *input_; }

 protected:
  void enter(Qt::KeyboardModifiers modifiers) override;

 private:
  ProgramView& view_;
  WholeNumberBox* input_;
  QLabel* count_;
};

}  // namespace feedscope::ui
