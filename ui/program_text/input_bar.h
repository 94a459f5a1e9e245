#pragma once

#include <QWidget>

namespace feedscope::ui {

/// A bar with an input above the view that it serves: Esc closes it and goes back to the view, Enter acts.
class InputBar : public QWidget {
  Q_OBJECT

 public:
  /// `view` outlives this.
  InputBar(QWidget& view, QWidget* parent);

 public slots:
  virtual void close_bar();

 protected:
  /// Esc in `input` is the bar's, not the window's.
  void take_keys_of(QWidget* input);
  virtual void enter(Qt::KeyboardModifiers modifiers) = 0;

  bool eventFilter(QObject* object, QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  QWidget& served_;
};

}  // namespace feedscope::ui
