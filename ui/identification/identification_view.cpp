#include "ui/identification/identification_view.h"

#include <QAction>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QLocale>
#include <QProgressBar>
#include <QPushButton>
#include <QSaveFile>
#include <QScrollArea>
#include <QScrollBar>
#include <QTimer>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "core/base/error.h"
#include "ui/identification/fit_choice.h"
#include "ui/identification/identification_texts.h"
#include "ui/identification/recordings_box.h"
#include "ui/identification/result_box.h"
#include "ui/identification/test_program_dialog.h"
#include "ui/language/in_language.h"
#include "ui/shared/flow_layout.h"
#include "ui/shared/panel_action.h"
#include "ui/shared/paths.h"
#include "ui/workbench/own_machines.h"

namespace feedscope::ui {

namespace {

constexpr int progress_steps = 1000;

/// Adds buttons of commands, as many in a row as fit.
QList<QWidget*> add_buttons(QVBoxLayout& layout, const QList<QAction*>& actions, QWidget* parent) {
  auto* row = new FlowLayout;
  QList<QWidget*> buttons;
  for (QAction* action : actions) {
    auto* button = new QToolButton(parent);
    button->setDefaultAction(action);
    row->addWidget(button);
    buttons.append(button);
  }
  layout.addLayout(row);
  return buttons;
}

}  // namespace

IdentificationView::IdentificationView(Workbench& workbench, QWidget* parent)
    : Panel({QStringLiteral("identification"), tr("Identification"), Qt::RightDockWidgetArea, false}, parent),
      workbench_(workbench),
      recordings_(new RecordingsBox(workbench, this)),
      choice_(new FitChoice(workbench, this)),
      result_(new ResultBox(this)),
      identify_(new QPushButton(tr("&Identify"), this)),
      progress_(new QProgressBar(this)),
      state_(new QLabel(this)),
      scroll_(new QScrollArea(this)) {
  progress_->setRange(0, progress_steps);
  progress_->setTextVisible(false);
  progress_->hide();
  state_->setWordWrap(true);
  state_->setTextFormat(Qt::PlainText);
  state_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  identify_->setToolTip(
      tr("Search the numbers with which each model explains the recordings best; Esc cancels"));
  make_actions();
  make_layout();
  connect(identify_, &QPushButton::clicked, this, [this] { busy() ? cancel() : identify(); });
  connect(recordings_, &RecordingsBox::changed, this, &IdentificationView::follow_recordings);
  connect(choice_, &FitChoice::changed, this, &IdentificationView::follow_input);
  connect(result_, &ResultBox::model_chosen, this, &IdentificationView::follow_input);
  connect(&workbench_, &Workbench::program_changed, this, &IdentificationView::follow_program);
  connect(&job_, &IdentificationJob::progressed, this, [this](double fraction, const QString& stage) {
    progress_->setValue(static_cast<int>(progress_steps * fraction));
    say(stage + QStringLiteral(" …"));
  });
  connect(&job_, &IdentificationJob::finished, this, &IdentificationView::take);
  connect(&job_, &IdentificationJob::cancelled, this, [this] {
    follow_input();
    say(tr("Cancelled."));
  });
  connect(&job_, &IdentificationJob::failed, this, [this](const QString& message) {
    follow_input();
    say(message);
  });
  follow_program();
}

void IdentificationView::make_actions() {
  QAction* begin = make_action(
      this, tr("&Identify the machine …"),
      tr("Limits and settings of your machine from what it recorded, and which control it is like"), {},
      [this] { emit attention_wanted(); });
  set_everyday_words(begin, tr("identify machine parameters trace calibrate fit my own limits measured"));
  open_trace_ = make_action(this, tr("Trace …"), tr("What the control recorded while the program ran"), {},
                            &IdentificationView::trace_wanted);
  open_table_ =
      make_action(this, tr("Open section times …"),
                  tr("A table of the times of sections, for those without a trace: section,seconds"), {},
                  &IdentificationView::ask_for_table);
  open_table_->setIconText(tr("Section times …"));
  set_everyday_words(open_table_, tr("identify machine parameters stopwatch times table"));
  write_program_ = make_action(this, tr("Write a test program …"),
                               tr("The program whose recording tells most limits of a machine"), {},
                               [this] { ask_for_test_program(); });
  write_program_->setIconText(tr("Test program …"));
  set_everyday_words(write_program_, tr("identify machine parameters trace measure corners circles"));
  show_run_ = make_action(this, tr("Show the identified machine as a run"),
                          tr("A run on the machine that was found; its curves lie over the trace"), {},
                          &IdentificationView::show_as_run);
  show_run_->setIconText(tr("Show as run"));
  save_ = make_action(this, tr("Save the identified machine …"),
                      tr("The machine that was found as a machine file, each number with its source"), {},
                      &IdentificationView::ask_for_machine_file);
  save_->setIconText(tr("Save machine file …"));
  actions_ = {begin, write_program_, open_table_, show_run_, save_};
}

QLabel* IdentificationView::add_step(QVBoxLayout& layout, int number, const QString& title) {
  auto* heading = new QLabel(QStringLiteral("%1  %2").arg(number).arg(title), this);
  QFont bold = heading->font();
  bold.setBold(true);
  heading->setFont(bold);
  if (number > 1) {
    layout.addSpacing(6);
  }
  layout.addWidget(heading);
  return heading;
}

void IdentificationView::make_layout() {
  auto* content = new QWidget(this);
  auto* layout = new QVBoxLayout(content);
  layout->setContentsMargins(8, 6, 8, 8);
  layout->setSpacing(4);
  add_step(*layout, 1, tr("What was recorded"));
  layout->addWidget(recordings_);
  QList<QWidget*> keyboard_way{&recordings_->list()};
  keyboard_way += add_buttons(*layout, {open_trace_, open_table_, write_program_}, this);
  add_step(*layout, 2, tr("What is fitted to it"));
  layout->addWidget(choice_);
  search_heading_ = add_step(*layout, 3, tr("Search"));
  auto* search = new QHBoxLayout;
  search->addWidget(identify_);
  search->addWidget(progress_, 1);
  search->addStretch();
  layout->addLayout(search);
  layout->addWidget(state_);
  add_step(*layout, 4, tr("What was found"));
  layout->addWidget(result_);
  keyboard_way += choice_->keyboard_way();
  keyboard_way += {identify_, &result_->models(), &result_->parameters()};
  keyboard_way += add_buttons(*layout, {show_run_, save_}, this);
  for (qsizetype i = 1; i < keyboard_way.size(); ++i) {
    setTabOrder(keyboard_way[i - 1], keyboard_way[i]);
  }
  layout->addStretch(1);
  scroll_->setFrameShape(QFrame::NoFrame);
  scroll_->setWidgetResizable(true);
  scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll_->setFocusPolicy(Qt::NoFocus);
  scroll_->setWidget(content);
  auto* whole = new QVBoxLayout(this);
  whole->setContentsMargins(0, 0, 0, 0);
  whole->addWidget(scroll_);
}

void IdentificationView::set_on_screen(bool on_screen) {
  if (on_screen) {
    choice_->read_machines();
  }
}

void IdentificationView::follow_recordings() {
  const std::vector<std::shared_ptr<const Trace>> held = recordings_->traces();
  std::vector<const Trace*> traces;
  for (const auto& trace : held) {
    traces.push_back(trace.get());
  }
  choice_->set_recorded_drives(axes_with_drives(traces));
  follow_input();
}

IdentificationRequest IdentificationView::request() const {
  return {workbench_.shown_program().input, recordings_->traces(), recordings_->tables(), choice_->starts()};
}

/// Reason why the search cannot start; empty if it can.
QString IdentificationView::missing(const IdentificationRequest& asked) const {
  if (asked.program.program == nullptr) {
    return tr("Open the program that was recorded first.");
  }
  if (recordings_->is_reading()) {
    return tr("The trace is being read …");
  }
  if (asked.traces.empty() && asked.tables.empty()) {
    return tr("Step 1: open a trace or a table of section times.");
  }
  if (!choice_->problem().isEmpty()) {
    return choice_->problem();
  }
  if (asked.starts.empty()) {
    return tr("Step 2: tick a control model.");
  }
  for (const IdentificationStart& start : asked.starts) {
    if (start.keys.empty()) {
      return tr("Step 2: tick a number to be found.");
    }
  }
  return {};
}

/// Discards the recordings of the previous program.
void IdentificationView::follow_program() {
  if (workbench_.file() != file_) {
    file_ = workbench_.file();
    job_.cancel();
    unsettled_ = false;
    result_->set_outcome(nullptr);
    recordings_->forget_tables();
    choice_->follow_current_run();
  }
  follow_input();
}

void IdentificationView::follow_input() {
  const IdentificationRequest asked = request();
  const bool has_result = result_->outcome() != nullptr;
  settle(asked);
  stale_ = has_result && !unsettled_ && !(asked == asked_);
  result_->set_stale(stale_);
  show_run_->setEnabled(has_result && workbench_.program() != nullptr);
  save_->setEnabled(has_result);
  open_trace_->setEnabled(workbench_.program() != nullptr);
  open_table_->setEnabled(workbench_.program() != nullptr);
  identify_->setText(busy() ? tr("Cancel") : tr("&Identify"));
  progress_->setVisible(busy());
  if (!busy()) {
    const QString lacks = missing(asked);
    identify_->setEnabled(lacks.isEmpty());
    say(lacks);
  }
}

/// A restored result is accepted for the current choices if it is equal, as soon as they have been read.
void IdentificationView::settle(const IdentificationRequest& asked) {
  if (unsettled_ && asked.program.program != nullptr && !recordings_->is_reading()) {
    unsettled_ = false;
    asked_ = is_of(*result_->outcome(), asked) ? asked : IdentificationRequest();
  }
}

IdentificationState IdentificationView::state() const {
  return {recordings_->unused_traces(), recordings_->all_tables(), choice_->state(), result_->kept(stale_)};
}

void IdentificationView::set_state(const IdentificationState& state) {
  job_.cancel();
  unsettled_ = false;
  result_->set_outcome(nullptr);
  recordings_->set_state(state.unused_traces, state.tables);
  choice_->set_state(state.choice);
  result_->set_outcome(state.result.outcome, state.result.chosen);
  asked_ = {};
  unsettled_ = state.result.outcome != nullptr && !state.result.stale;
  follow_input();
}

void IdentificationView::identify() {
  const IdentificationRequest asked = request();
  if (const QString lacks = missing(asked); !lacks.isEmpty()) {
    say(lacks);
    return;
  }
  choice_->hold_run();
  progress_->setValue(0);
  job_.start(asked);
  searched_ = asked;
  follow_input();
}

void IdentificationView::take(std::shared_ptr<const IdentificationOutcome> outcome) {
  std::size_t simulations = 0;
  for (const Identification& found : outcome->models) {
    simulations += found.simulations;
  }
  asked_ = searched_;
  unsettled_ = false;
  result_->set_outcome(std::move(outcome));
  follow_input();
  say(tr("Done after %1 simulations of the program.")
          .arg(QLocale().toString(static_cast<qulonglong>(simulations))));
  QTimer::singleShot(0, this, [this] { scroll_->verticalScrollBar()->setValue(search_heading_->y()); });
}

void IdentificationView::show_as_run() {
  const Identification* found = result_->chosen();
  if (found == nullptr) {
    return;
  }
  Setup setup = found->setup;
  setup.machine.id += "-identified";
  setup.machine.name = tr("%1, identified").arg(QString::fromStdString(setup.machine.name)).toStdString();
  setup.load = {};
  RunList& runs = workbench_.runs();
  runs.duplicate_as(runs.current(), SetupState(std::move(setup)),
                    tr("Identified from %1").arg(IdentificationTexts::names(*result_->outcome())));
}

void IdentificationView::ask_for_machine_file() {
  const Identification* found = result_->chosen();
  if (found == nullptr) {
    return;
  }
  const QString file = QFileDialog::getSaveFileName(
      this, tr("Save the machine"), to_qstring(workbench_.file().parent_path() / "my-machine.toml"),
      tr("Machine files (*.toml)"));
  if (!file.isEmpty()) {
    save_machine(to_path(file));
  }
}

void IdentificationView::save_machine(const std::filesystem::path& file) {
  const std::string text = write_machine(identified_machine(*result_->chosen(), file));
  QSaveFile out(to_qstring(file));
  const auto size = static_cast<qint64>(text.size());
  if (out.open(QIODevice::WriteOnly) && out.write(text.data(), size) == size && out.commit()) {
    OwnMachines::add(to_qstring(file));
    choice_->read_machines();
    say(tr("%1 is written; it is offered wherever a machine is chosen.").arg(to_qstring(file.filename())));
  } else {
    emit failed(
        tr("%1 cannot be written: %2. Choose another folder.").arg(to_qstring(file), out.errorString()));
  }
}

void IdentificationView::ask_for_table() {
  const QString file = QFileDialog::getOpenFileName(this, tr("Open table of section times"),
                                                    to_qstring(workbench_.file().parent_path()),
                                                    tr("Tables (*.csv *.tsv *.txt);;All files (*)"));
  if (!file.isEmpty()) {
    add_table(to_path(file));
  }
}

void IdentificationView::add_table(const std::filesystem::path& file) {
  emit attention_wanted();
  if (workbench_.program() == nullptr) {
    say(missing(request()));
    return;
  }
  try {
    recordings_->add_table(file);
  } catch (const InputError& error) {
    say(failure_text(error));
  }
}

TestProgramDialog& IdentificationView::ask_for_test_program() {
  emit attention_wanted();
  const auto program = workbench_.program();
  auto* dialog = new TestProgramDialog(program == nullptr ? Dialect::fanuc : program->dialect,
                                       workbench_.setup().setup(), workbench_.file().parent_path(), this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &TestProgramDialog::open_wanted, this, &IdentificationView::program_wanted);
  dialog->open();
  return *dialog;
}

void IdentificationView::say(const QString& message) {
  state_->setText(message);
  state_->setVisible(!message.isEmpty());
}

QString IdentificationView::message() const {
  return state_->text();
}

}  // namespace feedscope::ui
