#pragma once

#include <QWidget>

class QLabel;
class QSpinBox;

namespace feedscope::ui {

class ProgramView;

/// Asks for a line number and goes there.
class GoToBar : public QWidget {
  Q_OBJECT

 public:
  /// `view` outlives this.
  explicit GoToBar(ProgramView& view, QWidget* parent = nullptr);

  /// Shows itself with the number of the line at the caret.
  void open();
  QSpinBox& input() { return *input_; }

 protected:
  bool eventFilter(QObject* object, QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void close_bar();

  ProgramView& view_;
  QSpinBox* input_;
  QLabel* count_;
};

}  // namespace feedscope::ui
