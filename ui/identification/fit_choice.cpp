#include "ui/identification/fit_choice.h"

#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QListWidget>
#include <QSignalBlocker>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "core/base/error.h"
#include "ui/fields/focus_outline.h"
#include "ui/identification/identification_texts.h"
#include "ui/language/core_texts.h"
#include "ui/language/in_language.h"
#include "ui/theme/type_size.h"

namespace feedscope::ui {
namespace {

constexpr int key_role = Qt::UserRole;
constexpr int shown_models = 5;
constexpr int shown_parameters = 7;
constexpr int machine_characters = 8;

/// Keys of the first entries in the list of machines; runs by their ids and machines by their keys follow.
const QString current_run = QStringLiteral("current");
const QString typical_machine = QStringLiteral("typical");

}  // namespace

FitChoice::FitChoice(Workbench& workbench, QWidget* parent)
    : QWidget(parent),
      workbench_(workbench),
      machines_(new QComboBox(this)),
      models_(new QListWidget(this)),
      parameters_(new QTreeWidget(this)) {
  machines_->setToolTip(tr(
      "Limits and settings that the search begins with; those that are not looked for, or not found, stay"));
  machines_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  machines_->setMinimumContentsLength(machine_characters);
  machines_->setFocusPolicy(Qt::StrongFocus);
  machines_->installEventFilter(this);
  models_->setAccessibleName(tr("Control models that are fitted"));
  models_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  models_->setWordWrap(true);
  models_->setResizeMode(QListView::Adjust);
  new FocusOutline(*models_);
  for (const ControlModel* model : all_models()) {
    auto* item = new QListWidgetItem(core_text(model->info().title), models_);
    item->setData(key_role, QString::fromStdString(model->info().id));
    item->setToolTip(core_text(model->info().summary));
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
    item->setCheckState(Qt::Unchecked);
  }
  parameters_->setAccessibleName(tr("Numbers that are to be found"));
  parameters_->setRootIsDecorated(false);
  parameters_->setUniformRowHeights(true);
  parameters_->setAlternatingRowColors(true);
  parameters_->setHeaderLabels({tr("Number"), tr("Begins with")});
  parameters_->header()->setStretchLastSection(false);
  parameters_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  parameters_->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  new FocusOutline(*parameters_);

  auto* machine_label = new QLabel(tr("&Begin with machine"), this);
  machine_label->setBuddy(machines_);
  auto* models_label =
      new QLabel(tr("Control mo&dels: tick several to see which one explains the recording best"), this);
  models_label->setBuddy(models_);
  models_label->setWordWrap(true);
  auto* parameters_label = new QLabel(tr("&Numbers to be found"), this);
  parameters_label->setBuddy(parameters_);
  parameters_label->setWordWrap(true);
  auto* usual = new QToolButton(this);
  usual->setText(tr("Usual ones"));
  usual->setToolTip(tr(
      "Tick the limits of the axes, the settings with a unit, and the drives whose set and actual positions "
      "are recorded"));
  auto* none = new QToolButton(this);
  none->setText(tr("None"));
  none->setToolTip(tr("Tick no number"));
  auto* heading = new QHBoxLayout;
  heading->addWidget(parameters_label, 1);
  heading->addWidget(usual);
  heading->addWidget(none);
  keyboard_way_ = {machines_, models_, usual, none, parameters_};
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  layout->addWidget(machine_label);
  layout->addWidget(machines_);
  layout->addWidget(models_label);
  layout->addWidget(models_);
  layout->addLayout(heading);
  layout->addWidget(parameters_);

  connect(machines_, &QComboBox::activated, this, &FitChoice::choose_machine);
  connect(models_, &QListWidget::itemChanged, this, [this] {
    own_models_ = true;
    refresh();
  });
  connect(parameters_, &QTreeWidget::itemChanged, this, [this](const QTreeWidgetItem* item) {
    wanted_[item->data(0, key_role).toString().toStdString()] = item->checkState(0) == Qt::Checked;
    QMetaObject::invokeMethod(this, &FitChoice::refresh, Qt::QueuedConnection);  // it rebuilds the list
  });
  connect(usual, &QToolButton::clicked, this, &FitChoice::tick_usual);
  connect(none, &QToolButton::clicked, this, &FitChoice::tick_none);
  RunList& runs = workbench_.runs();
  for (const auto signal : {&RunList::list_changed, &RunList::current_changed}) {
    connect(&runs, signal, this, &FitChoice::follow_runs);
  }
  connect(&runs, &RunList::item_changed, this, &FitChoice::follow_runs);
  connect(&runs, &RunList::setup_changed, this, &FitChoice::follow_runs);
  connect(&TypeSize::of_application(), &TypeSize::changed, this,
          [this] { QMetaObject::invokeMethod(this, &FitChoice::fit_heights, Qt::QueuedConnection); });
  choices_ = workbench_.machine_choices();
  follow_runs();
}

void FitChoice::read_machines() {
  choices_ = workbench_.machine_choices();
  list_machines();
}

bool FitChoice::eventFilter(QObject* watched, QEvent* event) {
  if (watched == machines_ && event->type() == QEvent::Wheel && !machines_->hasFocus()) {
    event->ignore();
    return true;
  }
  return QWidget::eventFilter(watched, event);
}

/// Row of the initial run.
std::size_t FitChoice::begun_row() const {
  const RunList& runs = workbench_.runs();
  const std::size_t held = held_run_ == 0 ? runs.items().size() : runs.row_of(held_run_);
  return held < runs.items().size() ? held : runs.current();
}

void FitChoice::hold_run() {
  if (machine_.isEmpty() && !typical_) {
    held_run_ = workbench_.runs().items()[begun_row()].id;
  }
}

void FitChoice::follow_current_run() {
  held_run_ = 0;
  follow_runs();
}

FitChoiceState FitChoice::state() const {
  FitChoiceState state;
  const RunList& runs = workbench_.runs();
  if (const std::size_t row = runs.row_of(held_run_); held_run_ != 0 && row < runs.items().size()) {
    state.run = row;
  }
  state.machine = machine_;
  state.typical = typical_;
  if (own_models_) {
    state.models = ticked_models();
  }
  state.wanted = wanted_;
  return state;
}

void FitChoice::set_state(const FitChoiceState& state) {
  const std::vector<RunItem>& runs = workbench_.runs().items();
  held_run_ = state.run && *state.run < runs.size() ? runs[*state.run].id : 0;
  machine_ = state.machine;
  typical_ = state.typical;
  wanted_ = state.wanted;
  own_models_ = state.models.has_value();
  if (own_models_) {
    const QSignalBlocker quiet(models_);
    for (int i = 0; i < models_->count(); ++i) {
      const std::string id = models_->item(i)->data(key_role).toString().toStdString();
      const bool ticked = std::ranges::find(*state.models, id) != state.models->end();
      models_->item(i)->setCheckState(ticked ? Qt::Checked : Qt::Unchecked);
    }
  }
  follow_runs();
}

void FitChoice::follow_runs() {
  list_machines();
  if (!own_models_) {
    const std::string& model = workbench_.runs().items()[begun_row()].setup.file().model->info().id;
    const QSignalBlocker quiet(models_);
    for (int i = 0; i < models_->count(); ++i) {
      const bool is_it = models_->item(i)->data(key_role).toString().toStdString() == model;
      models_->item(i)->setCheckState(is_it ? Qt::Checked : Qt::Unchecked);
      if (is_it) {
        models_->setCurrentRow(i);
      }
    }
  }
  refresh();
}

void FitChoice::list_machines() {
  const QSignalBlocker quiet(machines_);
  machines_->clear();
  const RunList& runs = workbench_.runs();
  machines_->addItem(tr("Current run: %1").arg(runs.title(runs.current_item())), current_run);
  for (const RunItem& run : runs.items()) {
    if (runs.items().size() > 1) {
      machines_->addItem(tr("Run: %1").arg(runs.title(run)), run.id);
    }
  }
  machines_->addItem(tr("Typical machine of each model"), typical_machine);
  machines_->insertSeparator(machines_->count());
  for (const MachineChoice& choice : choices_) {
    machines_->addItem(choice.owner.isEmpty() ? choice.name : tr("%1 (%2)").arg(choice.name, choice.owner),
                       choice.key());
  }
  const bool is_held = held_run_ != 0 && runs.row_of(held_run_) < runs.items().size();
  const QVariant shown = typical_                             ? QVariant(typical_machine)
                         : !machine_.isEmpty()                ? QVariant(machine_)
                         : is_held && runs.items().size() > 1 ? QVariant(held_run_)
                                                              : QVariant(current_run);
  machines_->setCurrentIndex(std::max(0, machines_->findData(shown)));
}

void FitChoice::choose_machine(int index) {
  const QVariant chosen = machines_->itemData(index);
  typical_ = chosen == QVariant(typical_machine);
  held_run_ = chosen.typeId() == QMetaType::Int ? chosen.toInt() : 0;
  const bool is_machine = !typical_ && held_run_ == 0 && chosen != QVariant(current_run);
  machine_ = is_machine ? chosen.toString() : QString();
  follow_runs();
}

std::vector<std::string> FitChoice::ticked_models() const {
  std::vector<std::string> ids;
  for (int i = 0; i < models_->count(); ++i) {
    if (models_->item(i)->checkState() == Qt::Checked) {
      ids.push_back(models_->item(i)->data(key_role).toString().toStdString());
    }
  }
  return ids;
}

/// Throws InputError for an unreadable machine.
Setup FitChoice::setup_of(const std::string& model) const {
  if (typical_ || !machine_.isEmpty()) {
    SetupRequest request;
    request.machine = typical_ ? usual_machine_of(model) : machine_.toStdString();
    request.model = model;
    return make_setup(request);
  }
  SetupState state = workbench_.runs().items()[begun_row()].setup;
  if (state.file().model->info().id != model) {
    state.set_model(find_model(model));
  }
  return state.setup();
}

bool FitChoice::is_wanted(const std::string& key, bool usual) const {
  const auto chosen = wanted_.find(key);
  return chosen == wanted_.end() ? usual : chosen->second;
}

void FitChoice::refresh() {
  starts_.clear();
  problem_.clear();
  try {
    for (const std::string& model : ticked_models()) {
      starts_.push_back({setup_of(model), {}});
    }
  } catch (const InputError& error) {
    starts_.clear();
    problem_ = failure_text(error);
  }
  list_parameters();
  emit changed();
}

void FitChoice::set_recorded_drives(const std::string& axes) {
  if (axes != recorded_drives_) {
    recorded_drives_ = axes;
    refresh();
  }
}

std::vector<FitParameter> FitChoice::offered(const Setup& setup, bool usual) const {
  std::vector<FitParameter> all = usual ? usual_fit_parameters(setup) : fit_parameters(setup);
  for (const char axis : recorded_drives_) {
    for (std::size_t i = 0; i < drive_parameter_count; ++i) {
      all.push_back(drive_parameter(axis, i));
    }
  }
  return all;
}

/// Lists the numbers of all ticked models; each start gets its own ones that are ticked.
void FitChoice::list_parameters() {
  const QSignalBlocker quiet(parameters_);
  const QTreeWidgetItem* current = parameters_->currentItem();
  const QVariant current_key = current == nullptr ? QVariant() : current->data(0, key_role);
  parameters_->clear();
  std::map<std::string, QTreeWidgetItem*> rows;
  for (IdentificationStart& start : starts_) {
    const std::vector<FitParameter> usual = offered(start.setup, true);
    for (const FitParameter& parameter : offered(start.setup, false)) {
      const bool is_usual = std::ranges::find(usual, parameter.key, &FitParameter::key) != usual.end();
      const bool wanted = is_wanted(parameter.key, is_usual);
      if (wanted) {
        start.keys.push_back(parameter.key);
      }
      QTreeWidgetItem*& row = rows[parameter.key];
      if (row == nullptr) {
        row = new QTreeWidgetItem(parameters_,
                                  {IdentificationTexts::title(parameter),
                                   IdentificationTexts::value(fit_value(start.setup, parameter), parameter)});
        row->setData(0, key_role, QString::fromStdString(parameter.key));
        row->setToolTip(0, QString::fromStdString(parameter.key));
        row->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
        row->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
        row->setCheckState(0, Qt::Unchecked);
      }
      if (wanted) {
        row->setCheckState(0, Qt::Checked);
      }
      if (row->data(0, key_role) == current_key) {
        parameters_->setCurrentItem(row);
      }
    }
  }
  fit_heights();
}

/// Sets heights for the intended number of rows at the current font size.
void FitChoice::fit_heights() {
  models_->setFixedHeight(shown_models * models_->sizeHintForRow(0) + 2 * models_->frameWidth() + 2);
  parameters_->setFixedHeight(shown_parameters * std::max(1, parameters_->sizeHintForRow(0)) +
                              parameters_->header()->sizeHint().height() + 2 * parameters_->frameWidth());
}

void FitChoice::tick_usual() {
  wanted_.clear();
  refresh();
}

void FitChoice::tick_none() {
  for (int i = 0; i < parameters_->topLevelItemCount(); ++i) {
    wanted_[parameters_->topLevelItem(i)->data(0, key_role).toString().toStdString()] = false;
  }
  refresh();
}

}  // namespace feedscope::ui
