#include "ui/runs/runs_view.h"

#include <QCheckBox>
#include <QColorDialog>
#include <QFileDialog>
#include <QHeaderView>
#include <QInputDialog>
#include <QLabel>
#include <QLocale>
#include <QRegularExpression>
#include <QSaveFile>
#include <QTableView>
#include <QToolBar>
#include <QVBoxLayout>
#include <algorithm>

#include "core/base/error.h"
#include "core/export/export.h"
#include "core/machine/contour_tolerance.h"
#include "ui/fields/number_box.h"
#include "ui/fields/number_text.h"
#include "ui/language/failure_text.h"
#include "ui/language/shown_numbers.h"
#include "ui/language/texts.h"
#include "ui/shared/panel_action.h"
#include "ui/shared/row_copy.h"
#include "ui/workbench/workbench.h"

namespace feedscope::ui {

namespace {

constexpr int row_height = 22;
constexpr double usual_bound = 10;      // [um]
constexpr double largest_bound = 1000;  // [um]

/// "0.01 0.02; 0,05" by point or comma. Throws InputError that says which word is not a number, and why.
QList<double> numbers_of(const QString& text) {
  QList<double> numbers;
  static const QRegularExpression separators(QStringLiteral("[\\s;]+"));
  for (const QString& word : text.split(separators, Qt::SkipEmptyParts)) {
    const auto number = number_of(word);
    if (!number) {
      const QString hint = RunsView::tr("Separate the tolerances by spaces or semicolons.");
      throw InputError((number_problem(word) + ' ' + hint).toStdString());
    }
    numbers.append(*number);
  }
  return numbers;
}

}  // namespace

RunsView::RunsView(RunList& runs, QWidget* parent)
    : Panel({QStringLiteral("runs"), tr("Runs"), Qt::BottomDockWidgetArea}, parent),
      runs_(runs),
      model_(new RunTable(runs, this)),
      table_(new QTableView(this)),
      bounded_(new QCheckBox(tr("Ma&x. error"), this)),
      bound_(new NumberBox(this)),
      verdict_(new QLabel(this)) {
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
  bound_->setRange(0, in_shown_unit(largest_bound / 1000, Dimension::error));
  bound_->setDecimals(decimals_of(Dimension::error, 1));
  bound_->setValue(in_shown_unit(usual_bound / 1000, Dimension::error));
  bound_->setSuffix(' ' + unit_of(Dimension::error));
  bound_->setEnabled(false);
  bounded_->setToolTip(tr("Only runs with a contour error within this bound are considered for the fastest"));
  bound_->setToolTip(bounded_->toolTip());
  verdict_->setWordWrap(true);
  verdict_->setContentsMargins(6, 0, 6, 4);

  make_actions();
  auto* bar = new QToolBar(this);  // what has no room in it goes into a menu: the panel may be narrow
  bar->setToolButtonStyle(Qt::ToolButtonTextOnly);
  for (QAction* action : actions_) {
    bar->addAction(action);
    table_->addAction(action);
  }
  for_all_ = make_action(this, tr("Change &all runs"),
                         tr("Values that are changed from now on are changed in all runs that know them, not "
                            "in the current one alone"),
                         {});
  for_all_->setCheckable(true);
  const QList<QAction*> in_menus{
      for_all_,
      make_action(this, tr("Save the runs as CSV …"),
                  tr("The numbers of the runs that are simulated, one row per run, with their names"), {},
                  &RunsView::save_csv)};
  set_everyday_words(in_menus.last(), tr("export table spreadsheet"));
  table_->addActions(in_menus);
  actions_ += in_menus;
  bar->addSeparator();
  bar->addWidget(bounded_);
  bar->addWidget(bound_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(bar);
  layout->addWidget(verdict_);
  layout->addWidget(table_);

  const auto set_bound = [this] {
    bound_->setEnabled(bounded_->isChecked());
    model_->set_error_bound(bounded_->isChecked()
                                ? std::optional(from_shown_unit(bound_->value(), Dimension::error))
                                : std::nullopt);
  };
  connect(bounded_, &QCheckBox::toggled, this, set_bound);
  connect(bound_, &NumberBox::valueChanged, this, set_bound);
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
  connect(model_, &RunTable::dataChanged, this, &RunsView::show_verdict);
  connect(model_, &RunTable::modelReset, this, &RunsView::show_verdict);
  follow_current();
}

void RunsView::make_actions() {
  add_action(tr("&Duplicate"), tr("Copy the current run to change it"), QKeySequence(tr("Ctrl+D")),
             &RunsView::duplicate);
  add_action(tr("&Tolerances …"), tr("Create copies of the current run with other contour tolerances"),
             QKeySequence(tr("Ctrl+T")), &RunsView::add_variants);
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

void RunsView::add_variants() {
  if (!runs_.current_item().setup.file().settings.has(contour_tolerance_key)) {
    verdict_->setText(tr("The model of this run does not use a contour tolerance."));
    return;
  }
  const QString asked = tr("Contour tolerances [%1], separated by spaces:").arg(unit_of(Dimension::length));
  const bool metric = unit_system() == UnitSystem::metric;
  const std::array<double, 3> usual =
      metric ? std::array{0.01, 0.02, 0.05} : std::array{0.0005, 0.001, 0.002};
  QString text = editable_text(usual[0]) + ' ' + editable_text(usual[1]) + ' ' + editable_text(usual[2]);
  QString problem;
  do {  // what is wrong is said above what was typed, so that it can be mended there
    bool accepted = false;
    text = QInputDialog::getText(this, tr("Runs with other tolerances"),
                                 problem.isEmpty() ? asked : problem + QStringLiteral("\n\n") + asked,
                                 QLineEdit::Normal, text, &accepted);
    if (!accepted) {
      return;
    }
    problem = add_tolerances(text);
  } while (!problem.isEmpty());
}

QString RunsView::add_tolerances(const QString& text) {
  std::vector<SetupState> setups;
  try {
    for (const double tolerance : numbers_of(text)) {
      setups.push_back(runs_.current_item().setup);
      setups.back().set_tolerance(from_shown_unit(tolerance, Dimension::length));
    }
  } catch (const InputError& error) {
    return failure_text(error);
  }
  runs_.history().beginMacro(tr("runs with other tolerances"));
  for (const SetupState& setup : setups) {
    runs_.duplicate_as(runs_.current(), setup);
  }
  runs_.history().endMacro();
  return {};
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
  show_verdict();
}

QString RunsView::verdict() const {
  const std::size_t count = runs_.items().size();
  if (count < 2) {
    return tr("Duplicate the run and change a value to compare.");
  }
  const std::vector<std::size_t> fastest = model_->fastest();
  if (fastest.empty()) {
    std::size_t done = 0;
    std::size_t given_up = 0;
    for (std::size_t row = 0; row < count; ++row) {
      const RunStatus status = runs_.status(row);
      done += status == RunStatus::simulated ? 1 : 0;
      given_up += status == RunStatus::cancelled || status == RunStatus::failed ? 1 : 0;
    }
    if (given_up > 0) {
      return tr("%1 of %2 runs are simulated; %3 were cancelled or failed.")
          .arg(done)
          .arg(count)
          .arg(given_up);
    }
    if (done < count) {
      return tr("%1 of %2 runs are simulated.").arg(done).arg(count);
    }
    return model_->all_refused() ? tr("The control refuses the program in all runs.")
           : bounded_->isChecked()
               ? tr("No run is within this bound.")
               : tr("The machine cannot turn its rotary axes as the program asks in any run.");
  }
  const QString time = clock_text(runs_.result(fastest.front())->run.summary.cycle_time);
  if (fastest.size() == count) {
    return tr("All runs take %1.").arg(time);
  }
  const QString lead =
      bounded_->isChecked()
          ? tr("Fastest within %1")
                .arg(amount_text(from_shown_unit(bound_->value(), Dimension::error), Dimension::error))
          : tr("Fastest");
  return tr("%1: %2 with %3.").arg(lead, runs_.title(runs_.items()[fastest.front()]), time);
}

/// As wide as the names are, so that what is cut last is a name.
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

void RunsView::show_verdict() {
  fit_names();
  verdict_->setText(verdict());
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
    verdict_->setText(tr("There is no run to save: open a program first."));
    return;
  }
  const QString file = QFileDialog::getSaveFileName(this, tr("Save the runs"), {}, tr("Tables (*.csv)"));
  QSaveFile out(file);
  const auto size = static_cast<qint64>(text.size());
  if (!file.isEmpty() &&
      (!out.open(QIODevice::WriteOnly) || out.write(text.data(), size) != size || !out.commit())) {
    verdict_->setText(tr("%1 cannot be written: %2.").arg(file, out.errorString()));
  }
}

void RunsView::follow(Workbench& workbench) {
  traces_ = &workbench.traces();
  model_->set_traces(*traces_);
  follow_current();
  connect(traces_, &TraceList::list_changed, this, &RunsView::follow_current);
  for_all_->setChecked(workbench.setup().for_all());
  connect(for_all_, &QAction::toggled, &workbench.setup(), &SetupEdit::set_for_all);
  connect(this, &RunsView::again_wanted, &workbench, &Workbench::simulate_again);
}

}  // namespace feedscope::ui
