#include "ui/runs/run_notice.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QToolButton>
#include <algorithm>

#include "ui/shared/paths.h"

namespace feedscope::ui {

namespace {

constexpr int progress_steps = 1000;

}  // namespace

RunNotice::RunNotice(Workbench& workbench, QWidget& stage)
    : QFrame(&stage),
      workbench_(workbench),
      text_(new QLabel(this)),
      progress_(new QProgressBar(this)),
      again_(new QToolButton(this)) {
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
  layout->addWidget(progress_, 1);
  layout->addWidget(again_);
  progress_->setRange(0, progress_steps);
  progress_->setTextVisible(false);
  connect(again_, &QToolButton::clicked, this,
          [this] { workbench_.simulate_again(workbench_.runs().current()); });
  RunList& runs = workbench_.runs();
  connect(&workbench_, &Workbench::program_changed, this, &RunNotice::follow);
  connect(&workbench_, &Workbench::busy_changed, this, [this] {
    activity_.clear();
    progress_->setValue(0);
    follow();
  });
  connect(&workbench_, &Workbench::progressed, this, [this](const QString& activity, double fraction) {
    activity_ = activity;
    progress_->setValue(static_cast<int>(progress_steps * fraction));
    follow();
  });
  connect(&runs, &RunList::current_changed, this, &RunNotice::follow);
  connect(&runs, &RunList::list_changed, this, &RunNotice::follow);
  for (const auto signal : {&RunList::status_changed, &RunList::result_changed, &RunList::item_changed}) {
    connect(&runs, signal, this, &RunNotice::follow);
  }
  stage.installEventFilter(this);
  follow();
}

bool RunNotice::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize && watched == parentWidget()) {
    place();
  }
  return QFrame::eventFilter(watched, event);
}

void RunNotice::place() {
  const QSize room = parentWidget()->size();
  const int height = hasHeightForWidth() ? heightForWidth(room.width()) : sizeHint().height();
  setGeometry(0, room.height() - height, room.width(), height);
  raise();
}

bool RunNotice::waits() const {
  const RunList& runs = workbench_.runs();
  return workbench_.busy() && runs.last_result(runs.current()) == nullptr &&
         runs.status(runs.current()) == RunStatus::waiting;
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
  progress_->setVisible(waits());
  setVisible(!why.isEmpty());
  place();
}

QString RunNotice::reason() const {
  if (waits()) {
    return activity_.isEmpty() ? tr("Reading the program …") : activity_;
  }
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
  if (program == nullptr) {
    return without_program_;
  }
  if (!workbench_.shown_program().input.toolpath->segments.empty()) {
    return {};
  }
  const QString file = to_qstring(workbench_.file().filename());
  const QString dialect = QString::fromUtf8(info_of(program->dialect).title.data());
  return tr("Nothing in %1 moves an axis. Check that it is an NC program; it was read as %2, and File › "
            "Reading › Program import options selects another language. The panel Messages lists what was "
            "found in it.")
      .arg(file, dialect);
}

void RunNotice::say_without_program(const QString& text) {
  without_program_ = text;
  follow();
}

QString RunNotice::text() const {
  return isHidden() ? QString() : text_->text();
}

}  // namespace feedscope::ui
