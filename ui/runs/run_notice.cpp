#include "ui/runs/run_notice.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

#include "ui/shared/paths.h"

namespace feedscope::ui {

RunNotice::RunNotice(Workbench& workbench, QWidget* parent)
    : QFrame(parent), workbench_(workbench), text_(new QLabel(this)), again_(new QToolButton(this)) {
  setFrameShape(QFrame::StyledPanel);
  setBackgroundRole(QPalette::ToolTipBase);
  setAutoFillBackground(true);
  text_->setWordWrap(true);
  text_->setForegroundRole(QPalette::ToolTipText);
  text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  text_->setTextFormat(Qt::PlainText);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(8, 3, 8, 3);
  layout->addWidget(text_, 1);
  layout->addWidget(again_);
  connect(again_, &QToolButton::clicked, this,
          [this] { workbench_.simulate_again(workbench_.runs().current()); });
  RunList& runs = workbench_.runs();
  connect(&workbench_, &Workbench::program_changed, this, &RunNotice::follow);
  connect(&runs, &RunList::current_changed, this, &RunNotice::follow);
  connect(&runs, &RunList::list_changed, this, &RunNotice::follow);
  for (const auto signal : {&RunList::status_changed, &RunList::result_changed, &RunList::item_changed}) {
    connect(&runs, signal, this, &RunNotice::follow);
  }
  follow();
}

void RunNotice::follow() {
  const RunStatus status = workbench_.runs().status(workbench_.runs().current());
  const QString why = reason();
  text_->setText(why);
  const bool nothing_read = workbench_.program() == nullptr;
  again_->setText(nothing_read ? tr("Read again") : tr("Simulate again"));
  again_->setToolTip(nothing_read ? tr("Read the program again and simulate it (F9)")
                                  : tr("Simulate the current run (F9)"));
  again_->setVisible(status == RunStatus::cancelled || status == RunStatus::failed);
  setVisible(!why.isEmpty());
}

QString RunNotice::reason() const {
  const RunList& runs = workbench_.runs();
  const QString name = runs.title(runs.current_item());
  const auto program = workbench_.program();
  switch (runs.status(runs.current())) {
    case RunStatus::cancelled:
      return tr("The run “%1” was cancelled: it has no result.").arg(name);
    case RunStatus::failed:
      return program == nullptr ? tr("No program is shown. %1").arg(runs.failure(runs.current()))
                                : tr("The run “%1” has failed: %2").arg(name, runs.failure(runs.current()));
    default:
      break;
  }
  if (program == nullptr || !workbench_.shown_program().input.toolpath->segments.empty()) {
    return {};
  }
  const QString file = to_qstring(workbench_.file().filename());
  const QString dialect = QString::fromUtf8(info_of(program->dialect).title.data());
  return tr("Nothing in %1 moves an axis. Check that it is an NC program; it was read as %2, and File › "
            "Program import options selects another language. The panel Messages lists what was found in it.")
      .arg(file, dialect);
}

QString RunNotice::text() const {
  return isHidden() ? QString() : text_->text();
}

}  // namespace feedscope::ui
