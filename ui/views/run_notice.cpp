#include "ui/views/run_notice.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

namespace feedscope::ui {

RunNotice::RunNotice(Workbench& model, QWidget* parent)
    : QFrame(parent), model_(model), text_(new QLabel(this)), again_(new QToolButton(this)) {
  setFrameShape(QFrame::StyledPanel);
  setBackgroundRole(QPalette::ToolTipBase);
  setAutoFillBackground(true);
  text_->setWordWrap(true);
  text_->setForegroundRole(QPalette::ToolTipText);
  text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  text_->setTextFormat(Qt::PlainText);
  again_->setText(tr("Simulate again"));
  again_->setToolTip(tr("Simulate the current run (F9)"));
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(8, 3, 8, 3);
  layout->addWidget(text_, 1);
  layout->addWidget(again_);
  connect(again_, &QToolButton::clicked, this, [this] { model_.simulate_again(model_.runs().current()); });
  RunList& runs = model_.runs();
  connect(&runs, &RunList::current_changed, this, &RunNotice::follow);
  connect(&runs, &RunList::list_changed, this, &RunNotice::follow);
  for (const auto signal : {&RunList::status_changed, &RunList::result_changed, &RunList::item_changed}) {
    connect(&runs, signal, this, &RunNotice::follow);
  }
  follow();
}

void RunNotice::follow() {
  const RunList& runs = model_.runs();
  const QString name = runs.title(runs.current_item());
  switch (runs.status(runs.current())) {
    case RunStatus::cancelled:
      text_->setText(tr("The run “%1” was cancelled: there is nothing to show of it.").arg(name));
      show();
      break;
    case RunStatus::failed:
      text_->setText(tr("The run “%1” has failed: %2").arg(name, runs.failure(runs.current())));
      show();
      break;
    default:
      hide();
  }
}

QString RunNotice::text() const {
  return isHidden() ? QString() : text_->text();
}

}  // namespace feedscope::ui
