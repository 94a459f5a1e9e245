#include "ui/views/program/go_to_bar.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLocale>
#include <QSpinBox>
#include <algorithm>
#include <limits>

#include "ui/views/program/program_view.h"

namespace feedscope::ui {

GoToBar::GoToBar(ProgramView& view, QWidget* parent)
    : QWidget(parent), view_(view), input_(new QSpinBox(this)), count_(new QLabel(this)) {
  input_->setAccessibleName(tr("Line to go to"));
  input_->setToolTip(tr("Line to go to (Enter)"));
  input_->installEventFilter(this);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(4, 4, 4, 4);
  layout->addWidget(new QLabel(tr("Line"), this));
  layout->addWidget(input_);
  layout->addWidget(count_, 1);
}

void GoToBar::open() {
  const std::uint32_t lines = std::max(1U, view_.text().line_count());
  input_->setRange(1, static_cast<int>(std::min<std::uint32_t>(lines, std::numeric_limits<int>::max())));
  input_->setValue(static_cast<int>(view_.caret().line));
  count_->setText(tr("of %1").arg(QLocale().toString(lines)));
  show();
  input_->setFocus(Qt::ShortcutFocusReason);
  input_->selectAll();
}

void GoToBar::close_bar() {
  hide();
  view_.setFocus();
}

/// Esc in the input is the bar's, not the window's.
bool GoToBar::eventFilter(QObject* object, QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
    event->accept();
    return true;
  }
  return QWidget::eventFilter(object, event);
}

void GoToBar::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Escape:
      close_bar();
      break;
    case Qt::Key_Return:
    case Qt::Key_Enter:
      view_.go_to({static_cast<std::uint32_t>(input_->value()), 0});
      close_bar();
      break;
    default:
      QWidget::keyPressEvent(event);
  }
}

}  // namespace feedscope::ui
