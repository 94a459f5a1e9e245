#include "ui/window/panels/state_line.h"

namespace feedscope::ui {

StateLine::StateLine(QWidget* parent) : QLabel(parent) {
  setWordWrap(true);
  setTextFormat(Qt::PlainText);
  setTextInteractionFlags(Qt::TextSelectableByMouse);
}

void StateLine::say(const QString& message) {
  setText(message);
  setForegroundRole(QPalette::WindowText);
}

void StateLine::say_failure(const QString& message) {
  setText(message);
  setForegroundRole(QPalette::BrightText);
}

}  // namespace feedscope::ui
