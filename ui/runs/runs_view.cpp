#include "ui/runs/runs_view.h"

#include <QColorDialog>
#include <QFileDialog>
#include <QHeaderView>
#include <QSaveFile>
#include <QTableView>
#include <QToolBar>
#include <QVBoxLayout>
#include <algorithm>

#include "core/export/export.h"
#include "ui/shared/panel_action.h"
#include "ui/shared/row_copy.h"
#include "ui/workbench/workbench.h"

namespace feedscope::ui {

namespace {

constexpr int row_height = 22;

}  // namespace

RunsView::RunsView(RunList& runs, QWidget* parent)
    : Panel({QStringLiteral("runs"), tr("Runs"), Qt::BottomDockWidgetArea, false}, parent),
      runs_(runs),
      model_(new RunTable(runs, this)),
      table_(new QTableView(this)) {
  table_->setModel(model_);
  table_->setAccessibleName(tr("Runs and their results"));
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
  table_->setAlternatingRowColors(true);
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setDefaultSectionSize(row_height);
  table_->horizontalHeader()->setHighlightSections(false);
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setSectionResizeMode(RunTable::name, QHeaderView::Interactive);
  table_->horizontalHeader()->setSectionResizeMode(RunTable::machine, QHeaderView::Stretch);
  table_->setContextMenuPolicy(Qt::ActionsContextMenu);
  install_row_copy(*table_);
  table_->setTabKeyNavigation(false);

  make_actions();
  auto* bar = new QToolBar(this);  // commands that do not fit go into a menu: the panel may be narrow
  bar->setToolButtonStyle(Qt::ToolButtonTextOnly);
  for (QAction* action : actions_) {
    bar->addAction(action);
    table_->addAction(action);
  }
  const QList<QAction*> in_menus{
      make_action(this, tr("Save the runs as CSV …"),
                  tr("The numbers of the runs that are simulated, one row per run, with their names"), {},
                  &RunsView::save_csv)};
  set_everyday_words(in_menus.last(), tr("export table spreadsheet"));
  table_->addActions(in_menus);
  actions_ += in_menus;
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(bar);
  layout->addWidget(table_);

  connect(table_->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
          [this](const QModelIndex& index) {
            if (!index.isValid()) {
              return;
            }
            if (const auto trace = model_->trace_of(index.row())) {
              emit trace_chosen(*trace);
            } else {
              runs_.select(static_cast<std::size_t>(index.row()));
            }
          });
  connect(&runs_, &RunList::current_changed, this, &RunsView::follow_current);
  connect(&runs_, &RunList::list_changed, this, &RunsView::follow_current);
  for (const auto signal : {&RunList::status_changed, &RunList::result_changed, &RunList::item_changed}) {
    connect(&runs_, signal, this, &RunsView::follow_status);
  }
  connect(model_, &RunTable::dataChanged, this, &RunsView::fit_names);
  connect(model_, &RunTable::modelReset, this, &RunsView::fit_names);
  follow_current();
}

void RunsView::make_actions() {
  add_action(tr("&Duplicate"), tr("Copy the current run to change it"), QKeySequence(tr("Ctrl+D")),
             &RunsView::duplicate);
  add_action(tr("R&ename"), tr("Type a name for the current run; empty: named by its machine and settings"),
             QKeySequence(Qt::Key_F2), &RunsView::rename);
  actions_.last()->setShortcutContext(Qt::WidgetWithChildrenShortcut);
  add_action(tr("&Remove"), tr("Remove the current run, or the trace that is selected"),
             QKeySequence(tr("Ctrl+Delete")), &RunsView::remove);
  add_action(tr("&Up"), tr("Move the current run up"), QKeySequence(tr("Alt+Up")), &RunsView::move_up);
  add_action(tr("Dow&n"), tr("Move the current run down"), QKeySequence(tr("Alt+Down")),
             &RunsView::move_down);
  again_ =
      make_action(this, tr("&Simulate again"), tr("Simulate the current run, which was cancelled or failed"),
                  QKeySequence(Qt::Key_F9), [this] { emit again_wanted(runs_.current()); });
  actions_.append(again_);
  table_->addAction(
      make_action(this, tr("&Colour …"),
                  tr("Colour of the current run in charts and 3D view, or of the selected trace in charts"),
                  {}, [this] { choose_colour(); }));
}

void RunsView::add_action(const QString& text, const QString& tip, const QKeySequence& key,
                          void (RunsView::*call)()) {
  actions_.append(make_action(this, text, tip, key, call));
}

void RunsView::duplicate() {
  runs_.duplicate(runs_.current());
}

void RunsView::remove() {
  if (const auto trace = chosen_trace()) {
    traces_->remove(*trace);
  } else {
    runs_.remove(runs_.current());
  }
}

std::optional<std::size_t> RunsView::chosen_trace() const {
  const QModelIndex index = table_->currentIndex();
  return index.isValid() ? model_->trace_of(index.row()) : std::nullopt;
}

void RunsView::rename() {
  emit attention_wanted();
  table_->setFocus();
  const auto trace = chosen_trace();
  const std::size_t row = trace ? runs_.items().size() + *trace : runs_.current();
  table_->edit(model_->index(static_cast<int>(row), RunTable::name));
}

void RunsView::move_up() {
  if (runs_.current() > 0) {
    runs_.move(runs_.current(), runs_.current() - 1);
  }
}

void RunsView::move_down() {
  runs_.move(runs_.current(), runs_.current() + 1);
}

void RunsView::choose_colour() {
  const auto trace = chosen_trace();
  const QColor before = trace ? traces_->items()[*trace].colour : runs_.current_item().colour;
  const QColor colour = QColorDialog::getColor(before, this, tr("Colour of the run"));
  if (!colour.isValid()) {
    return;
  }
  trace ? traces_->set_colour(*trace, colour) : runs_.set_colour(runs_.current(), colour);
}

void RunsView::follow_current() {
  const QModelIndex index = model_->index(static_cast<int>(runs_.current()), RunTable::name);
  if (table_->currentIndex().row() != index.row()) {
    table_->setCurrentIndex(index);
  }
  follow_status();
}

void RunsView::follow_status() {
  const RunStatus status = runs_.status(runs_.current());
  again_->setEnabled(status == RunStatus::cancelled || status == RunStatus::failed);
}

/// Fits the name column to the names, so that they are shortened last.
void RunsView::fit_names() {
  constexpr double most = 0.45;  // of the table
  const auto& view = static_cast<const QAbstractItemView&>(*table_);
  const int wanted = std::max(view.sizeHintForColumn(RunTable::name),
                              table_->horizontalHeader()->sectionSizeHint(RunTable::name));
  table_->setColumnWidth(RunTable::name,
                         std::min(wanted, static_cast<int>(most * table_->viewport()->width())));
}

void RunsView::resizeEvent(QResizeEvent* event) {
  Panel::resizeEvent(event);
  fit_names();
}

std::string RunsView::csv() const {
  std::vector<ComparedRun> runs;
  std::vector<std::string> names;
  for (std::size_t row = 0; row < runs_.items().size(); ++row) {
    if (const auto result = runs_.result(row)) {
      runs.push_back(figures_of(result->run));
      names.push_back(runs_.title(runs_.items()[row]).toStdString());
    }
  }
  return runs.empty() ? std::string() : comparison_csv(runs, names);
}

void RunsView::save_csv() {
  const std::string text = csv();
  if (text.empty()) {
    emit failed(tr("There is no run to save: open a program first."));
    return;
  }
  const QString file = QFileDialog::getSaveFileName(this, tr("Save the runs"), {}, tr("Tables (*.csv)"));
  QSaveFile out(file);
  const auto size = static_cast<qint64>(text.size());
  if (!file.isEmpty() &&
      (!out.open(QIODevice::WriteOnly) || out.write(text.data(), size) != size || !out.commit())) {
    emit failed(tr("%1 cannot be written: %2.").arg(file, out.errorString()));
  }
}

void RunsView::follow(Workbench& workbench) {
  traces_ = &workbench.traces();
  model_->set_traces(*traces_);
  follow_current();
  connect(traces_, &TraceList::list_changed, this, &RunsView::follow_current);
  connect(this, &RunsView::again_wanted, &workbench, &Workbench::simulate_again);
}

}  // namespace feedscope::ui
