#include "ui/contour/contour_view.h"

#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QSaveFile>
#include <QSplitter>
#include <QTreeView>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "core/export/contour.h"
#include "ui/contour/contour_texts.h"
#include "ui/fields/focus_outline.h"
#include "ui/shared/panel_action.h"
#include "ui/shared/row_copy.h"

namespace feedscope::ui {

ContourView::ContourView(Workbench& workbench, QWidget* parent)
    : Panel({QStringLiteral("contour"), tr("Contour error"), Qt::BottomDockWidgetArea, false}, parent),
      workbench_(workbench),
      places_(new ContourPlacesModel(this)),
      verdict_(new QLabel(this)),
      shares_(new QLabel(this)),
      sides_(new QCheckBox(tr("&Left and right"), this)),
      close_up_(new QCheckBox(tr("Close-&up"), this)),
      results_(new QSplitter(this)),
      chart_(new ContourChart(this)),
      list_(new QTreeView(this)) {
  verdict_->setWordWrap(true);
  shares_->setWordWrap(true);
  sides_->setToolTip(tr("Distinguish the sides of the path in XY; otherwise only the distance"));
  close_up_->setToolTip(tr("Zoom the 3D view to the selected place"));
  close_up_->setChecked(true);
  list_->setModel(places_);
  list_->setRootIsDecorated(false);
  list_->setUniformRowHeights(true);
  list_->setFrameShape(QFrame::NoFrame);
  list_->setAccessibleName(tr("Places farthest from the programmed path"));
  list_->header()->setStretchLastSection(true);
  install_row_copy(*list_);
  new FocusOutline(*list_);
  make_actions();
  make_layout();
  connect(sides_, &QCheckBox::toggled, this, &ContourView::show_reports);
  connect(list_, &QTreeView::clicked, this, &ContourView::choose);
  connect(list_, &QTreeView::activated, this, &ContourView::choose);
  connect(&job_, &ContourJob::changed, this, &ContourView::show_reports);
  connect(this, &ContourView::place_chosen, &workbench_, &Workbench::show_place);
  connect(&workbench_, &Workbench::run_changed, this, &ContourView::refresh);
  for (const auto signal : {&RunList::item_changed, &RunList::result_changed}) {
    connect(&workbench_.runs(), signal, this, &ContourView::refresh);
  }
  connect(&workbench_.runs(), &RunList::list_changed, this, &ContourView::refresh);
  show_reports();
}

void ContourView::make_actions() {
  actions_.append(make_action(this, tr("Contour &error …"),
                              tr("Show how far and where the executed path deviates from the programmed one"),
                              QKeySequence(tr("Ctrl+Shift+E")), [this] { emit attention_wanted(); }));
  actions_.append(make_action(this, tr("Copy the picture of the contour error"),
                              tr("Copy the histogram to the clipboard"), {},
                              [this] { QApplication::clipboard()->setPixmap(chart_->grab()); }));
  actions_.append(make_action(this, tr("Copy the worst contour errors"),
                              tr("Copy the list to the clipboard as CSV with units"), {}, [this] {
                                if (places_->report() != nullptr) {
                                  QApplication::clipboard()->setText(
                                      QString::fromStdString(contour_places_csv(*places_->report())));
                                }
                              }));
  actions_.append(make_action(
      this, tr("Save the worst contour errors as CSV …"), tr("One row per place, with units"), {}, [this] {
        save(tr("Save the worst contour errors"),
             places_->report() == nullptr ? std::string() : contour_places_csv(*places_->report()));
      }));
  actions_.append(make_action(this, tr("Save the histogram of the contour error as CSV …"),
                              tr("Path length by contour error, one column per run, with units"), {}, [this] {
                                save(tr("Save the histogram of the contour error"), histogram_csv());
                              }));
  steps_.append(make_action(this, tr("Next contour error"),
                            tr("Go to the next listed place far from the programmed path"),
                            QKeySequence(Qt::Key_F6), [this] { step(true); }));
  steps_.append(make_action(this, tr("Previous contour error"), tr("Go to the previous listed place"),
                            QKeySequence(Qt::SHIFT | Qt::Key_F6), [this] { step(false); }));
}

void ContourView::make_layout() {
  auto* choices = new QHBoxLayout;
  choices->addWidget(sides_);
  choices->addWidget(close_up_);
  choices->addStretch(1);
  auto* head = new QVBoxLayout;
  head->setContentsMargins(6, 4, 6, 2);
  head->setSpacing(2);
  head->addWidget(verdict_);
  head->addWidget(shares_);
  head->addLayout(choices);
  results_->addWidget(chart_);
  results_->addWidget(list_);
  results_->setChildrenCollapsible(false);
  results_->setSizes({1000, 1000});
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addLayout(head);
  layout->addWidget(results_, 1);
}

/// Places the parts side by side if there is room.
void ContourView::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  constexpr int wide = 620;
  const Qt::Orientation suits = width() >= wide ? Qt::Horizontal : Qt::Vertical;
  if (results_->orientation() != suits) {
    results_->setOrientation(suits);
    results_->setSizes({1000, 1000});
  }
}

void ContourView::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  refresh();
}

void ContourView::set_on_screen(bool on_screen) {
  on_screen_ = on_screen;
  refresh();
}

void ContourView::refresh() {
  std::vector<std::shared_ptr<const ShownRun>> wanted;
  if (is_seen()) {
    const RunList& runs = workbench_.runs();
    wanted.push_back(workbench_.shown());
    for (std::size_t row = 0; row < runs.items().size(); ++row) {
      if (row != runs.current() && runs.items()[row].visible) {
        wanted.push_back(runs.result(row));
      }
    }
  }
  std::erase(wanted, nullptr);
  job_.want(std::move(wanted));
  show_reports();  // even if hidden: the contents of the panel can be copied and saved
}

void ContourView::show_reports() {
  const auto shown = workbench_.shown();
  const auto report = shown == nullptr ? nullptr : job_.report(shown);
  if (places_->report() != report.get()) {
    places_->set_report(report);
    for (int column = 0; column < ContourPlacesModel::cause; ++column) {
      list_->resizeColumnToContents(column);
    }
  }
  if (report != nullptr && judged_.lock() != workbench_.program()) {
    judged_ = workbench_.program();
    const QSignalBlocker quiet(sides_);
    sides_->setChecked(report->is_flat());
  }
  verdict_->setText(verdict());
  shares_->setText(report == nullptr ? QString() : share_text(*report, sides_->isChecked()));
  chart_->set_curves(curves());
  if (report != nullptr && pending_step_) {
    step(*std::exchange(pending_step_, std::nullopt));
  }
}

QString ContourView::verdict() const {
  if (workbench_.shown() == nullptr) {
    return workbench_.program() == nullptr
               ? tr("Open a program to see how far the executed path is from the programmed one.")
               : tr("This run has not been simulated.");
  }
  if (places_->report() == nullptr) {
    return job_.busy() ? tr("Comparing the executed with the programmed path …")
                       : tr("The program needs more memory than is available.");
  }
  return verdict_text(*places_->report());
}

ContourCurves ContourView::curves() const {
  ContourCurves shown;
  shown.sides = sides_->isChecked();
  const RunList& runs = workbench_.runs();
  const auto add = [&](std::size_t row) {
    const auto report = runs.result(row) == nullptr ? nullptr : job_.report(runs.result(row));
    if (report != nullptr) {
      const RunItem& item = runs.items()[row];
      shown.runs.push_back({runs.lettered_title(row), item.colour, report->largest, report->spread});
    }
    return report;
  };
  if (const auto current = add(runs.current())) {
    shown.tolerance = current->tolerance;
    for (std::size_t row = 0; row < runs.items().size(); ++row) {
      if (row != runs.current() && runs.items()[row].visible) {
        add(row);
      }
    }
  }
  return shown;
}

void ContourView::step(bool forward) {
  if (workbench_.shown() == nullptr) {
    emit attention_wanted();
    return;
  }
  if (!is_seen() || job_.report(workbench_.shown()) == nullptr) {
    pending_step_ = forward;
    emit attention_wanted();
    return;
  }
  const Cursor& cursor = workbench_.cursor();
  const int row = places_->next_row(cursor.valid() ? cursor.state().time : 0, forward);
  if (row >= 0) {
    const QModelIndex index = places_->index(row, 0);
    list_->setCurrentIndex(index);
    choose(index);
  }
}

void ContourView::choose(const QModelIndex& index) {
  const auto shown = workbench_.shown();
  if (shown == nullptr || job_.report(shown).get() != places_->report()) {
    return;
  }
  const ContourPlace& place = places_->finding(index.row()).place;
  const Trajectory& trajectory = *shown->run.trajectory;
  constexpr double shown_errors = 12;  // of path on both sides
  constexpr double least = 0.01;       // [mm]
  const double around = std::max(shown_errors * place.error, least);
  const double from = trajectory.state_at_path(place.path_length - around).time;
  const double to = trajectory.state_at_path(place.path_length + around).time;
  emit place_chosen(place.time, from, to);
  if (close_up_->isChecked()) {
    emit close_up_wanted(from, to);
  }
}

std::string ContourView::histogram_csv() const {
  const ContourCurves& shown = chart_->curves();
  std::vector<NamedHistogram> histograms;
  for (std::size_t i = 0; i < shown.runs.size(); ++i) {
    histograms.push_back({shown.runs[i].name.toStdString(), shown.histogram(i)});
  }
  return histograms.empty() ? std::string() : contour_histogram_csv(histograms);
}

void ContourView::save(const QString& title, const std::string& text) {
  if (text.empty()) {
    emit failed(tr("There is no contour error to save: open a program and this panel."));
    return;
  }
  const QString file = QFileDialog::getSaveFileName(this, title, {}, tr("Tables (*.csv)"));
  QSaveFile out(file);
  const auto size = static_cast<qint64>(text.size());
  if (!file.isEmpty() &&
      (!out.open(QIODevice::WriteOnly) || out.write(text.data(), size) != size || !out.commit())) {
    emit failed(tr("%1 cannot be written: %2. Choose another folder.").arg(file, out.errorString()));
  }
}

}  // namespace feedscope::ui
