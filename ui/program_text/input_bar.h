#pragma once

#include <QWidget>

namespace feedscope::ui {

/// A bar with an input above its view: Esc closes it and returns to the view, Enter acts.
class InputBar : public QWidget {
  Q_OBJECT

 public:
  /// `view` outlives this.
  InputBar(QWidget& view, QWidget* parent);

 public slots:
  virtual void close_bar();

 protected:
  /// Makes Esc in `input` close the bar instead of acting on the window.
  void take_keys_of(QWidget* input);
  virtual void enter(Qt::KeyboardModifiers modifiers) = 0;

  bool eventFilter(QObject* object, QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  QWidget& served_;
};

}  // namespace feedscope::ui
