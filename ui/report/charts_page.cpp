#include "ui/report/charts_page.h"

#include <QApplication>
#include <QLabel>
#include <QPainter>
#include <QTextDocument>
#include <QVBoxLayout>

#include "core/analysis/notes/not_counted.h"
#include "core/toolpath/machine_path.h"
#include "ui/language/core_texts.h"
#include "ui/language/in_language.h"
#include "ui/language/texts.h"
#include "ui/workbench/reading_faults.h"

namespace feedscope::ui {

namespace {

/// `name`: of one run of several; empty: it is the only one.
QString title_of(const Run& run, const QString& name = {}) {
  const QString file = program_file_name(*run.input.program);
  const QString time = clock_text(run.trajectory->duration());
  const QString faults = reading_faults_text(*run.input.program);
  const QString omitted = in_language(not_counted_note(not_counted(*run.path)));
  const QString title =
      QStringLiteral("<b>%1</b> &nbsp; %2 · %3 · %4%5")
          .arg(file.toHtmlEscaped(), QString::fromStdString(run.setup.machine.name).toHtmlEscaped(),
               (name.isEmpty() ? core_text(run.setup.model->info().title) : name).toHtmlEscaped(), time,
               faults.isEmpty()
                   ? QString()
                   : QStringLiteral(" &nbsp; <span style=\"color:#c62818\"><b>%1</b></span>").arg(faults));
  return omitted.isEmpty() ? title : QStringLiteral("%1<br/>%2").arg(title, omitted);
}

}  // namespace

ChartsPage::ChartsPage() : title_(new QLabel(this)), charts_(new ChartsPanel(cursor_, range_, this)) {
  title_->setContentsMargins(8, 6, 8, 2);
  title_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  charts_->hide_controls();
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(title_);
  layout->addWidget(charts_, 1);
  setAttribute(Qt::WA_DontShowOnScreen);
}

void ChartsPage::set_run(const Run& run) {
  title_->setText(title_of(run));
  charts_->set_limits(run.setup);
  charts_->set_run(run.trajectory, std::make_shared<const Envelope>(run.trajectory, run.sources), false,
                   run.sources);
}

void ChartsPage::set_runs(const ReportInput& input, std::size_t row) {
  const ShownRun& shown = *input.runs[row].shown;
  const QString letter = input.runs.size() > 1 ? run_letter(row) : QString();
  title_->setText(title_of(shown.run, letter.isEmpty() ? letter : letter + ' ' + input.runs[row].name));
  charts_->set_limits(shown.run.setup);
  range_.show_rapids(input.scene.rapids);
  charts_->set_run(shown.run.trajectory, shown.envelope, false, shown.run.sources);
  std::vector<RunOverlay> others;
  for (std::size_t i = 0; i < input.runs.size(); ++i) {
    if (i != row) {
      const ReportRun& other = input.runs[i];
      others.push_back({other.shown->run.trajectory, other.shown->envelope, other.shown->run.sources,
                        other.colour, lettered_title(input, i)});
    }
  }
  std::vector<TraceOverlay> traces;
  for (const ReportTrace& trace : input.traces) {
    if (row == input.current) {
      traces.push_back({trace.shown, trace.colour, trace.name});
    }
  }
  charts_->set_state(input.charts);
  charts_->name_run(letter);
  charts_->set_overlays(std::move(others), std::move(traces));
}

void ChartsPage::set_cursor(double time) {
  if (cursor_.trajectory() != charts_->trajectory()) {
    cursor_.set_trajectory(charts_->trajectory());
  }
  cursor_.set_time(time);
}

void ChartsPage::hide_title() {
  title_->hide();
}

void ChartsPage::set_background(const QColor& colour) {
  QPalette colours = palette();
  colours.setColor(QPalette::Window, colour);
  setPalette(colours);
}

int ChartsPage::count() const {
  int count = 0;
  for (std::size_t i = 0; i < chart_count; ++i) {
    count += charts_->chart(i).isVisibleTo(charts_) ? 1 : 0;
  }
  return count;
}

void ChartsPage::prepare(const QSize& size, double resolution) {
  for (std::size_t i = 0; i < chart_count; ++i) {
    charts_->chart(i).set_resolution(resolution);
  }
  resize(size);
  show();
  // The panel of usual values takes width from the charts; Qt Charts lays its axes out in the next turn of
  // the event loop.
  for (int turn = 0; turn < 3; ++turn) {
    QApplication::processEvents();
    charts_->refresh();
  }
  QApplication::processEvents();
}

void ChartsPage::draw(QPainter& painter, bool background) {
  if (background) {
    painter.fillRect(rect(), palette().color(QPalette::Window));
  }
  if (title_->isVisibleTo(this)) {
    QTextDocument text;
    text.setDefaultFont(title_->font());
    text.setDocumentMargin(0);
    text.setDefaultStyleSheet(
        QStringLiteral("body { color: %1 }").arg(palette().color(QPalette::WindowText).name()));
    text.setHtml(QStringLiteral("<body>%1</body>").arg(title_->text()));
    const QRect room = title_->contentsRect().translated(title_->pos());
    painter.save();
    painter.setClipRect(room);
    painter.translate(room.topLeft());
    text.drawContents(&painter);
    painter.restore();
  }
  painter.save();
  painter.translate(charts_->pos());
  charts_->draw(painter);
  painter.restore();
}

}  // namespace feedscope::ui
