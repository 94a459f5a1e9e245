#include "ui/window/panels/status_panel.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QStyle>
#include <QToolButton>
#include <algorithm>
#include <cmath>

#include "ui/language/shown_numbers.h"
#include "ui/messages/diagnostic_rows.h"

namespace feedscope::ui {

namespace {

constexpr int progress_steps = 1000;
constexpr int progress_width = 140;

}  // namespace

StatusPanel::StatusPanel(Workbench& workbench, RunComparison& comparison, QWidget* parent)
    : QWidget(parent),
      workbench_(workbench),
      comparison_(comparison),
      activity_(new QLabel(this)),
      progress_(new QProgressBar(this)),
      cancel_(new QToolButton(this)),
      diagnostics_(new QToolButton(this)),
      cursor_(new QLabel(this)) {
  progress_->setRange(0, progress_steps);
  progress_->setFixedWidth(progress_width);
  progress_->setTextVisible(false);
  cancel_->setText(tr("Cancel"));
  cancel_->setToolTip(tr("Stop the running calculation (Esc)"));
  diagnostics_->setAutoRaise(true);
  diagnostics_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  diagnostics_->setToolTip(tr("Show what the reader found in the program"));

  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 6, 0);
  layout->addWidget(activity_);
  layout->addWidget(progress_);
  layout->addWidget(cancel_);
  layout->addWidget(diagnostics_);
  layout->addWidget(cursor_);

  connect(cancel_, &QToolButton::clicked, this, &StatusPanel::cancel);
  connect(diagnostics_, &QToolButton::clicked, this, &StatusPanel::diagnostics_clicked);
  connect(&workbench_, &Workbench::busy_changed, this, &StatusPanel::show_busy);
  connect(&workbench_, &Workbench::progressed, this, &StatusPanel::show_activity);
  connect(&comparison_, &RunComparison::progressed, this, &StatusPanel::show_comparison);
  connect(&workbench_, &Workbench::program_changed, this, &StatusPanel::count_diagnostics);
  connect(&workbench_.cursor(), &Cursor::changed, this, &StatusPanel::show_cursor);
  show_busy();
  count_diagnostics();
  show_cursor();
  keep_height();
}

void StatusPanel::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange) {
    keep_height();
  }
}

/// Keeps the status bar at one height with and without buttons.
void StatusPanel::keep_height() {
  for (QWidget* part : {static_cast<QWidget*>(progress_), static_cast<QWidget*>(cancel_),
                        static_cast<QWidget*>(diagnostics_)}) {
    part->setFixedHeight(fontMetrics().height());
  }
}

void StatusPanel::cancel() {
  if (workbench_.busy()) {
    workbench_.cancel();
  } else if (workbench_.traces().busy()) {
    workbench_.traces().cancel();
  } else {
    comparison_.cancel();
  }
}

void StatusPanel::show_activity(const QString& activity, double fraction) {
  activity_->setText(activity);
  show_progress(fraction);
}

/// A visible bar with updates would paint at once all that waits in the window, the 3D view too.
void StatusPanel::show_progress(double fraction) {
  progress_->setUpdatesEnabled(false);
  progress_->setValue(static_cast<int>(fraction * progress_steps));
  progress_->setUpdatesEnabled(true);
}

void StatusPanel::show_comparison() {
  if (workbench_.busy()) {
    return;  // it has priority
  }
  if (!comparison_.busy() || !progress_->isVisibleTo(this)) {
    show_busy();
  }
  if (comparison_.busy()) {
    const double fraction = comparison_.progress();
    show_activity(tr("Comparing runs %1 %").arg(QLocale().toString(100 * fraction, 'f', 0)), fraction);
  }
}

void StatusPanel::show_busy() {
  const bool busy = workbench_.busy() || comparison_.busy();
  show_progress(0);
  activity_->clear();
  activity_->setVisible(busy);
  progress_->setVisible(busy);
  cancel_->setVisible(busy);
}

void StatusPanel::count_diagnostics() {
  const auto program = workbench_.program();
  diagnostics_->setVisible(program != nullptr && !program->diagnostics.empty());
  if (program == nullptr) {
    return;
  }
  const auto errors = count_of(program->diagnostics, Severity::error);
  const auto warnings = count_of(program->diagnostics, Severity::warning);
  const auto notes = std::ranges::count(diagnostic_rows(program->diagnostics), Severity::info,
                                        [&](const DiagnosticRow& row) {
                                          return program->diagnostics[row.index].severity;
                                        });  // each once, for any number of places
  QStringList parts;
  if (errors > 0) {
    parts.append(errors == 1 ? tr("1 error") : tr("%1 errors").arg(errors));
  }
  if (warnings > 0) {
    parts.append(warnings == 1 ? tr("1 warning") : tr("%1 warnings").arg(warnings));
  }
  if (parts.isEmpty()) {
    parts.append(notes == 1 ? tr("1 note") : tr("%1 notes").arg(notes));
  }
  diagnostics_->setText(parts.join(QStringLiteral(", ")));
  diagnostics_->setIcon(style()->standardIcon(errors > 0     ? QStyle::SP_MessageBoxCritical
                                              : warnings > 0 ? QStyle::SP_MessageBoxWarning
                                                             : QStyle::SP_MessageBoxInformation));
}

void StatusPanel::show_cursor() {
  if (!workbench_.cursor().valid()) {
    cursor_->clear();
    return;
  }
  const State& state = workbench_.cursor().state();
  const QLocale locale;
  const QStringList parts{
      tr("%1 s").arg(locale.toString(state.time, 'f', 3)),
      amount_text(state.path_length, Dimension::length),
      tr("line %1").arg(state.line),
      amount_text(std::max(0.0, state.speed), Dimension::feed),
  };
  cursor_->setText(parts.join(QStringLiteral("   ")));
}

}  // namespace feedscope::ui
