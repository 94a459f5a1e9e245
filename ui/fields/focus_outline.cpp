#include "ui/fields/focus_outline.h"

#include <QEvent>
#include <QPainter>

namespace feedscope::ui {

FocusOutline::FocusOutline(QWidget& target, QWidget* beside)
    : QWidget(beside != nullptr ? beside : &target), target_(target) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setFocusPolicy(Qt::NoFocus);
  target_.installEventFilter(this);
  follow();
}

bool FocusOutline::eventFilter(QObject* watched, QEvent* event) {
  switch (event->type()) {
    case QEvent::FocusIn:
    case QEvent::FocusOut:
    case QEvent::Move:
    case QEvent::Resize:
    case QEvent::Show:
    case QEvent::Hide:
      follow();
      break;
    default:
      break;
  }
  return QWidget::eventFilter(watched, event);
}

void FocusOutline::follow() {
  setGeometry(parentWidget() == &target_ ? target_.rect() : target_.geometry());
  setVisible(target_.hasFocus() && target_.isVisible());
  raise();
}

void FocusOutline::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setPen(palette().color(QPalette::Highlight));
  painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

}  // namespace feedscope::ui
