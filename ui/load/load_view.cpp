#include "ui/load/load_view.h"

#include <QAction>
#include <QComboBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QSaveFile>
#include <QScopedValueRollback>
#include <QSplitter>
#include <QTableView>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "core/base/error.h"
#include "core/load/load_model.h"
#include "ui/fields/choice_delegate.h"
#include "ui/fields/focus_outline.h"
#include "ui/language/in_language.h"
#include "ui/load/load_figures_table.h"
#include "ui/load/load_places_table.h"
#include "ui/load/load_texts.h"
#include "ui/load/operation_table.h"
#include "ui/shared/panel_action.h"
#include "ui/shared/paths.h"
#include "ui/shared/row_copy.h"

namespace feedscope::ui {
namespace {

constexpr int row_height = 22;          // [pixels]
constexpr int widest_column = 230;      // [pixels]
constexpr double around_instant = 0.1;  // [s]; shown before and after the largest value

void prepare(QTableView& table, QAbstractItemModel& model) {
  table.setModel(&model);
  table.setFrameShape(QFrame::NoFrame);
  table.setTabKeyNavigation(false);
  table.setWordWrap(false);
  table.setSelectionMode(QAbstractItemView::SingleSelection);
  table.verticalHeader()->hide();
  table.verticalHeader()->setDefaultSectionSize(row_height);
  table.horizontalHeader()->setHighlightSections(false);
  table.horizontalHeader()->setMaximumSectionSize(widest_column);
  table.horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  new FocusOutline(table);
}

}  // namespace

LoadView::LoadView(Workbench& workbench, QWidget* parent)
    : Panel({QStringLiteral("load"), tr("Cutting load"), Qt::BottomDockWidgetArea, false}, parent),
      workbench_(workbench),
      table_(new OperationTable(this)),
      figures_table_(new LoadFiguresTable(this)),
      places_table_(new LoadPlacesTable(this)),
      operations_(new QTableView(this)),
      figures_(new QTableView(this)),
      places_(new QTableView(this)),
      which_(new QComboBox(this)),
      message_(new QLabel(this)) {
  prepare(*operations_, *table_);
  operations_->setAccessibleName(tr("Operations"));
  operations_->setItemDelegate(new ChoiceDelegate(operations_));
  operations_->setSelectionBehavior(QAbstractItemView::SelectRows);
  operations_->setEditTriggers(QAbstractItemView::AllEditTriggers);
  for (QTableView* table : {figures_, places_}) {
    prepare(*table, table == figures_ ? static_cast<QAbstractItemModel&>(*figures_table_) : *places_table_);
    table->setSelectionBehavior(QAbstractItemView::SelectRows);
    table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    install_row_copy(*table);
  }
  figures_->setAccessibleName(tr("Cutting load"));
  places_->setAccessibleName(tr("Places beyond a bound"));
  which_->setToolTip(tr("Operation whose load is listed"));
  which_->setAccessibleName(tr("Operation"));
  message_->setWordWrap(true);
  message_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  make_actions();
  make_layout();
  connect(table_, &OperationTable::edited, this, &LoadView::apply);
  connect(table_, &OperationTable::refused, this, [this](const QString& message) { say(message, true); });
  connect(which_, &QComboBox::currentIndexChanged, this, &LoadView::show_totals);
  const auto go_to_largest = [this](const QModelIndex& index) {
    const double time = figures_table_->time_of(index.row());
    workbench_.show_place(time, time - around_instant, time + around_instant);
  };
  const auto go_to_place = [this](const QModelIndex& index) {
    const LoadPlace& place = places_table_->place(index.row());
    workbench_.show_place((place.from + place.to) / 2, place.from, place.to);
  };
  for (const auto signal : {&QTableView::clicked, &QTableView::activated}) {
    connect(figures_, signal, this, go_to_largest);
    connect(places_, signal, this, go_to_place);
  }
  connect(&workbench_, &Workbench::program_changed, this, &LoadView::follow_program);
  connect(&workbench_, &Workbench::run_changed, this, &LoadView::show_result);
  connect(&workbench_.runs(), &RunList::load_changed, this, &LoadView::follow_load);
  follow_load();
  follow_program();
  show_result();
}

void LoadView::make_actions() {
  actions_.append(make_action(this, tr("Cutting &load …"),
                              tr("Chip thickness, cutting force, torque and power of the run"), {},
                              [this] { emit attention_wanted(); }));
  add_ = make_action(this, tr("Add operation"), tr("Another tool, or lines on which it is engaged otherwise"),
                     {}, [this] {
                       table_->add();
                       operations_->selectRow(table_->rowCount() - 1);
                       emit attention_wanted();
                     });
  remove_ = make_action(this, tr("Remove operation"), tr("Remove the selected operation"), {}, [this] {
    if (operations_->currentIndex().isValid()) {
      table_->remove(operations_->currentIndex().row());
    }
  });
  actions_.append({add_, remove_});
  actions_.append(make_action(this, tr("Open load file …"), tr("Operations and materials of a file"), {},
                              &LoadView::ask_to_open));
  actions_.append(make_action(this, tr("Save load file …"),
                              tr("Operations and materials, for other programs and the command line"), {},
                              &LoadView::ask_to_save));
}

void LoadView::make_layout() {
  auto* bar = new QHBoxLayout;
  bar->setContentsMargins(4, 4, 4, 2);
  for (QAction* action : actions_.mid(1)) {
    auto* button = new QToolButton(this);
    button->setDefaultAction(action);
    button->setToolButtonStyle(Qt::ToolButtonTextOnly);
    bar->addWidget(button);
  }
  bar->addStretch();
  bar->addWidget(which_);
  message_->setContentsMargins(8, 0, 8, 2);
  auto* results = new QSplitter(this);
  results->addWidget(figures_);
  results->addWidget(places_);
  results->setChildrenCollapsible(false);
  auto* parts = new QSplitter(Qt::Vertical, this);
  parts->addWidget(operations_);
  parts->addWidget(results);
  parts->setChildrenCollapsible(false);
  parts->setSizes({1000, 2200});
  results->setSizes({1300, 1000});
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addLayout(bar);
  layout->addWidget(message_);
  layout->addWidget(parts, 1);
}

const LoadSetup& LoadView::setup() const {
  return table_->setup();
}

void LoadView::set_setup(const LoadSetup& setup) {
  table_->set_setup(setup);
  apply();
}

QString LoadView::message() const {
  return message_->text();
}

/// Applies the table to the runs, or an empty load if it does not fit.
void LoadView::apply() {
  const LoadSetup& setup = table_->setup();
  const auto& input = workbench_.shown_program().input;
  problem_.clear();
  for (const Engagement& operation : setup.operations) {
    if (problem_.isEmpty()) {
      problem_ = in_language(operation_problem(operation));
    }
  }
  if (problem_.isEmpty() && !setup.empty() && input.program != nullptr) {
    try {
      const LoadModel model(setup, *input.program, *input.toolpath);
    } catch (const InputError& error) {
      problem_ = failure_text(error);
    }
  }
  const QScopedValueRollback<bool> guard(applying_, true);
  if (problem_.isEmpty()) {
    workbench_.runs().set_load(setup, tr("cutting load"));
  } else {
    workbench_.runs().use_load({});
  }
  show_result();
}

void LoadView::follow_program() {
  table_->set_program(workbench_.program());
  if (workbench_.program() != nullptr && !table_->setup().empty()) {
    const QScopedValueRollback<bool> guard(applying_, true);
    apply();
  }
  show_result();
}

/// Follows a change by undo, another program or a session.
void LoadView::follow_load() {
  if (!applying_ && !(workbench_.runs().load() == table_->setup())) {
    problem_.clear();
    table_->set_setup(workbench_.runs().load());
  }
  show_result();
}

void LoadView::show_result() {
  const auto shown = workbench_.shown();
  const bool has = shown != nullptr && shown->run.summary.load.has_value();
  const int before = which_->currentIndex();
  {
    const QSignalBlocker quiet(which_);
    which_->clear();
    if (has) {
      which_->addItem(tr("All operations"));
      for (const Engagement& operation : shown->run.setup.load.operations) {
        which_->addItem(operation_text(operation));
      }
      which_->setCurrentIndex(std::clamp(before, 0, which_->count() - 1));
    }
  }
  which_->setVisible(has && shown->run.setup.load.operations.size() > 1);
  places_table_->set_limits(has ? shown->run.summary.load->limits : std::vector<LimitFigures>());
  show_totals();
  if (!problem_.isEmpty()) {
    say(problem_, true);
  } else if (has) {
    QStringList sentences{assumptions_text(*shown->run.summary.load),
                          without_load_text(*shown->run.summary.load)};
    sentences.removeAll(QString());
    say(sentences.join(' '), false);
  } else if (table_->setup().empty()) {
    say(tr("Say how the tools of the program are engaged: the load then follows from the feed that the "
           "control "
           "reaches, beside that of the programmed feed."),
        false);
  } else {
    say(workbench_.program() == nullptr ? tr("No program yet.") : tr("The run is being simulated."), false);
  }
  remove_->setEnabled(!table_->setup().empty());
}

void LoadView::show_totals() {
  const auto shown = workbench_.shown();
  if (shown == nullptr || !shown->run.summary.load) {
    figures_table_->set_totals(std::nullopt);
    return;
  }
  const LoadFigures& load = *shown->run.summary.load;
  const int row = which_->currentIndex() - 1;
  figures_table_->set_totals(row < 0 ? load.all : load.operations[static_cast<std::size_t>(row)]);
}

void LoadView::say(const QString& message, bool wrong) {
  message_->setText(wrong ? QStringLiteral("⚠ ") + message : message);
}

void LoadView::open_file(const QString& file) {
  try {
    set_setup(read_load_file(to_path(file)));
  } catch (const InputError& error) {
    emit failed(failure_text(error));
  }
}

void LoadView::save_file(const QString& file) {
  if (table_->setup().empty()) {
    emit failed(tr("No operation to save: add one first."));
    return;
  }
  QSaveFile out(file);
  const QByteArray text = QByteArray::fromStdString(load_file_text(table_->setup()));
  if (!out.open(QIODevice::WriteOnly) || out.write(text) != text.size() || !out.commit()) {
    emit failed(tr("%1 cannot be written: %2").arg(file, out.errorString()));
  }
}

void LoadView::ask_to_open() {
  const QString file =
      QFileDialog::getOpenFileName(this, tr("Open load file"), {}, tr("Load files (*.toml)"));
  if (!file.isEmpty()) {
    open_file(file);
    emit attention_wanted();
  }
}

void LoadView::ask_to_save() {
  const QString file = QFileDialog::getSaveFileName(this, tr("Save load file"), QStringLiteral("load.toml"),
                                                    tr("Load files (*.toml)"));
  if (!file.isEmpty()) {
    save_file(file);
  }
}

}  // namespace feedscope::ui
