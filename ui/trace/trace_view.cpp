#include "ui/trace/trace_view.h"

#include <QAction>
#include <QComboBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QSaveFile>
#include <QSignalBlocker>
#include <QSplitter>
#include <QStandardItemModel>
#include <QToolButton>
#include <QTreeView>
#include <QVBoxLayout>
#include <algorithm>

#include "core/base/error.h"
#include "core/export/trace.h"
#include "core/trace/guess_trace.h"
#include "ui/fields/focus_outline.h"
#include "ui/language/in_language.h"
#include "ui/shared/panel_action.h"
#include "ui/shared/paths.h"
#include "ui/shared/row_copy.h"
#include "ui/shared/wrapped_names.h"
#include "ui/trace/trace_import_dialog.h"
#include "ui/trace/trace_tables.h"
#include "ui/workbench/trace_messages.h"

namespace feedscope::ui {

namespace {

constexpr int progress_steps = 1000;
constexpr int least_name = 100;  // of a figure's title, in several lines [px]

/// Width that shows the contents of all columns [px].
int wanted_width(const QTreeView& view) {
  view.header()->resizeSections(QHeaderView::ResizeToContents);
  return view.header()->length();
}

}  // namespace

TraceView::TraceView(Workbench& workbench, QWidget* parent)
    : Panel({QStringLiteral("trace"), tr("Trace"), Qt::BottomDockWidgetArea, false}, parent),
      workbench_(workbench),
      which_(new QComboBox(this)),
      verdict_(new QLabel(this)),
      remarks_(new QLabel(this)),
      progress_(new QProgressBar(this)),
      tables_(new QSplitter(this)),
      figures_(new QStandardItemModel(this)),
      places_(new QStandardItemModel(this)),
      corners_(new QStandardItemModel(this)) {
  which_->setAccessibleName(tr("Trace that is shown"));
  which_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  verdict_->setWordWrap(true);
  remarks_->setWordWrap(true);
  progress_->setRange(0, progress_steps);
  progress_->setTextVisible(false);
  make_actions();
  make_layout();
  TraceList& traces = workbench_.traces();
  connect(which_, &QComboBox::activated, this, [this](int row) { choose(static_cast<std::size_t>(row)); });
  connect(&traces, &TraceList::list_changed, this, &TraceView::list_traces);
  connect(&traces, &TraceList::changed, this, &TraceView::list_traces);
  connect(&traces, &TraceList::progressed, this, &TraceView::show_progress);
  connect(&traces, &TraceList::compared_first, this, &TraceView::tell_faults);
  connect(&workbench_, &Workbench::run_changed, this, &TraceView::refresh);
  connect(&workbench_, &Workbench::program_changed, this, &TraceView::refresh);
  connect(this, &TraceView::place_chosen, &workbench_, &Workbench::show_place);
  list_traces();
}

void TraceView::make_actions() {
  QAction* open = make_action(this, tr("Open &trace …"),
                              tr("Lay what a control recorded beside the run: LinuxCNC halsampler, SINUMERIK "
                                 "trace, TwinCAT Scope or any table of samples"),
                              {}, &TraceView::ask_for_file);
  set_everyday_words(open, tr("measurement oscilloscope recording machine compare real"));
  actions_.append(open);
  actions_.append(make_action(this, tr("Trace import &options …"),
                              tr("What the columns of the trace are, with a preview"), {},
                              &TraceView::change_columns));
  actions_.append(make_action(this, tr("Read and compare the trace again"),
                              tr("After its file has changed, or the comparison was cancelled"), {}, [this] {
                                if (any()) {
                                  const TraceItem item = workbench_.traces().items()[chosen_];
                                  workbench_.traces().set_columns(chosen_, item.columns);
                                }
                              }));
  actions_.append(make_action(this, tr("Save the agreement as JSON …"),
                              tr("Figures, worst places and corners, as feedscope trace --json writes them"),
                              {}, &TraceView::save));
  actions_.append(
      make_action(this, tr("Remove the trace"), tr("Take the trace that is shown off the list"), {}, [this] {
        if (any()) {
          workbench_.traces().remove(chosen_);
        }
      }));
  of_trace_ = actions_.mid(1);
}

QTreeView* TraceView::add_table(QStandardItemModel* model, const QString& name) {
  auto* view = new QTreeView(this);
  view->setModel(model);
  view->setRootIsDecorated(false);
  view->setUniformRowHeights(true);
  view->setAlternatingRowColors(true);
  view->setFrameShape(QFrame::NoFrame);
  view->setAccessibleName(name);
  view->header()->setStretchLastSection(false);
  install_row_copy(*view);
  new FocusOutline(*view);
  connect(view, &QTreeView::clicked, this, &TraceView::go_to);
  connect(view, &QTreeView::activated, this, &TraceView::go_to);
  tables_->addWidget(view);
  return view;
}

void TraceView::make_layout() {
  auto* top = new QHBoxLayout;
  for (QAction* action : {actions_[0], actions_[1]}) {
    auto* button = new QToolButton(this);
    button->setDefaultAction(action);
    top->addWidget(button);
  }
  top->addWidget(which_);
  top->addWidget(progress_);
  top->addStretch(1);
  auto* head = new QVBoxLayout;
  head->setContentsMargins(6, 4, 6, 2);
  head->setSpacing(2);
  head->addLayout(top);
  head->addWidget(verdict_);
  head->addWidget(remarks_);
  figures_view_ = add_table(figures_, tr("Figures of the agreement"));
  figures_view_->setUniformRowHeights(false);
  new WrappedNames(*figures_view_);
  places_view_ = add_table(places_, tr("Places where trace and run differ most"));
  corners_view_ = add_table(corners_, tr("Corners, where trace and run differ most first"));
  tables_->setChildrenCollapsible(false);
  tables_->setSizes({950, 900, 1120});
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addLayout(head);
  layout->addWidget(tables_, 1);
}

bool TraceView::is_trace(const std::filesystem::path& file) {
  return guess_trace(file).guess != TraceGuess::none;
}

void TraceView::open(const std::filesystem::path& file) {
  if (workbench_.program() == nullptr && workbench_.file().empty()) {
    emit failed(tr("%1 is a trace: open the program that it was recorded of first.")
                    .arg(to_qstring(file.filename())));
    return;
  }
  emit attention_wanted();
  const GuessedTrace guessed = guess_trace(file);
  if (guessed.guess == TraceGuess::columns_wanted) {
    ask_for_columns(file, in_language(guessed.problem));
    return;
  }
  workbench_.traces().add(file);
  choose(workbench_.traces().items().size() - 1);
}

void TraceView::ask_for_file() {
  const QString file =
      QFileDialog::getOpenFileName(this, tr("Open trace"), to_qstring(workbench_.file().parent_path()),
                                   tr("Traces (*.txt *.csv *.xml *.tsv *.dat *.log *.gz);;All files (*)"));
  if (!file.isEmpty()) {
    open(to_path(file));
  }
}

void TraceView::ask_for_columns(const std::filesystem::path& file, const QString& reason) {
  try {
    auto* dialog = new TraceImportDialog(file, {}, reason, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog, file] {
      workbench_.traces().add(file, dialog->specification().toStdString());
      choose(workbench_.traces().items().size() - 1);
    });
    dialog->open();
  } catch (const InputError& error) {
    emit failed(failure_text(error));
  }
}

void TraceView::change_columns() {
  if (!any()) {
    return;
  }
  const TraceItem& item = workbench_.traces().items()[chosen_];
  try {
    auto* dialog = new TraceImportDialog(item.file, item.columns, {}, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog, id = item.id] {
      TraceList& traces = workbench_.traces();
      const auto found = std::ranges::find(traces.items(), id, &TraceItem::id);
      if (found != traces.items().end()) {
        traces.set_columns(static_cast<std::size_t>(found - traces.items().begin()),
                           dialog->specification().toStdString());
      }
    });
    dialog->open();
  } catch (const InputError& error) {
    emit failed(failure_text(error));
  }
}

void TraceView::choose(std::size_t row) {
  chosen_ = row;
  list_traces();
}

void TraceView::list_traces() {
  const std::vector<TraceItem>& items = workbench_.traces().items();
  chosen_ = items.empty() ? 0 : std::min(chosen_, items.size() - 1);
  const QSignalBlocker quiet(which_);
  which_->clear();
  for (const TraceItem& item : items) {
    which_->addItem(item.name);
  }
  which_->setCurrentIndex(items.empty() ? -1 : static_cast<int>(chosen_));
  which_->setVisible(items.size() > 1);
  for (QAction* action : of_trace_) {
    action->setEnabled(!items.empty());
  }
  refresh();
}

void TraceView::refresh() {
  verdict_->setText(verdict());
  show_result();
  show_progress();
}

void TraceView::show_result() {
  const auto shown = any() ? workbench_.traces().result(chosen_) : nullptr;
  remarks_->setText(shown == nullptr ? QString() : remarks_of(*shown).join(QStringLiteral(" ")));
  remarks_->setVisible(shown != nullptr);
  tables_->setVisible(shown != nullptr);
  if (shown == seen_.lock() && shown != nullptr) {
    return;
  }
  seen_ = shown;
  if (shown == nullptr) {
    clear_tables(*figures_, *places_, *corners_);
    return;
  }
  fill_figures(*figures_, *shown);
  fill_worst_places(*places_, *shown);
  fill_corners(*corners_, *shown);
  for (QTreeView* view : {figures_view_, places_view_, corners_view_}) {
    view->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
  }
  figures_view_->header()->setSectionResizeMode(
      0,
      QHeaderView::Stretch);  // long titles of operations are wrapped
  figures_view_->header()->setMinimumHeight(places_view_->header()->sizeHint().height());
  const int figures = wanted_width(*figures_view_) - figures_view_->header()->sectionSize(0) + least_name;
  const int places = wanted_width(*places_view_);
  const int corners = wanted_width(*corners_view_);
  const int room = tables_->width() - 2 * tables_->handleWidth();
  tables_->setSizes({std::max(room - places - corners, figures), places, corners});
}

void TraceView::show_progress() {
  const TraceList& traces = workbench_.traces();
  progress_->setVisible(traces.busy());
  progress_->setValue(static_cast<int>(traces.fraction() * progress_steps));
}

QString TraceView::verdict() const {
  if (!any()) {
    return tr(
        "Drop what the control recorded onto the window, or open it here, to see how well the "
        "simulation agrees with your machine.");
  }
  const TraceList& traces = workbench_.traces();
  switch (traces.status(chosen_)) {
    case TraceStatus::compared:
      return verdict_of(*traces.result(chosen_));
    case TraceStatus::failed:
      return traces.failure(chosen_);
    case TraceStatus::cancelled:
      return tr("The comparison was cancelled. Read and compare the trace again to have it.");
    default:
      return traces.busy() ? tr("Reading the trace and laying it beside the run …")
                           : tr("The trace is read; it waits for the run to be simulated.");
  }
}

void TraceView::tell_faults(std::size_t row) {
  const TraceList& traces = workbench_.traces();
  const auto shown = traces.result(row);
  for (const Diagnostic& message : messages_on(*shown->trace, shown->found)) {
    if (message.severity != Severity::info) {
      emit noted(message.severity, tr("Trace %1: %2").arg(traces.items()[row].name, message_text(message)));
    }
  }
}

void TraceView::go_to(const QModelIndex& index) {
  const QVariant place = index.data(trace_place_role);
  const auto shown = any() ? workbench_.traces().result(chosen_) : nullptr;
  if (!place.isValid() || shown == nullptr || shown->run != workbench_.shown()) {
    return;
  }
  const double s = place.toDouble();
  const double reach = index.data(trace_reach_role).toDouble();
  emit place_chosen(shown->alignment.run_time(s), shown->alignment.run_time(s - reach),
                    shown->alignment.run_time(s + reach));
}

void TraceView::save() {
  const auto shown = any() ? workbench_.traces().result(chosen_) : nullptr;
  if (shown == nullptr) {
    emit failed(tr("The agreement cannot be saved yet: compare the trace with a run first."));
    return;
  }
  const std::string text = trace_json(*shown->trace, shown->found, shown->agreement, shown->run->run);
  const QString file = QFileDialog::getSaveFileName(this, tr("Save the agreement"), {}, tr("JSON (*.json)"));
  QSaveFile out(file);
  const auto size = static_cast<qint64>(text.size());
  if (!file.isEmpty() &&
      (!out.open(QIODevice::WriteOnly) || out.write(text.data(), size) != size || !out.commit())) {
    emit failed(tr("%1 cannot be written: %2. Choose another folder.").arg(file, out.errorString()));
  }
}

}  // namespace feedscope::ui
