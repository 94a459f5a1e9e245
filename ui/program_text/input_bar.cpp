#include "ui/program_text/input_bar.h"

#include <QKeyEvent>

namespace feedscope::ui {

InputBar::InputBar(QWidget& view, QWidget* parent) : QWidget(parent), served_(view) {}

void InputBar::close_bar() {
  hide();
  served_.setFocus();
}

void InputBar::take_keys_of(QWidget* input) {
  input->installEventFilter(this);
}

bool InputBar::eventFilter(QObject* object, QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
    event->accept();
    return true;
  }
  return QWidget::eventFilter(object, event);
}

void InputBar::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Escape:
      close_bar();
      break;
    case Qt::Key_Return:
    case Qt::Key_Enter:
      enter(event->modifiers());
      break;
    default:
      QWidget::keyPressEvent(event);
  }
}

}  // namespace feedscope::ui
