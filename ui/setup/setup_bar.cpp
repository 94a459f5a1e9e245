#include "ui/setup/setup_bar.h"

#include <QAbstractItemView>
#include <QComboBox>
#include <QLabel>
#include <QSignalBlocker>
#include <QToolButton>
#include <utility>

#include "ui/fields/number_box.h"
#include "ui/language/core_texts.h"
#include "ui/language/shown_numbers.h"
#include "ui/theme/type_size.h"
#include "ui/workbench/tolerance_text.h"

namespace feedscope::ui {

namespace {

constexpr int id_role = Qt::UserRole + 1;  // of the machine; the data is its key
constexpr int usual_list = 13;             // letters of the machine
constexpr int usual_control = 18;          // letters of the control
constexpr double several = -1;             // of the tolerance box: no single value, shown as a text [mm]

QLabel* make_label(const QString& text, QWidget* buddy, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  label->setBuddy(buddy);
  label->setContentsMargins(8, 0, 4, 0);
  return label;
}

/// Fixes the width of the box to `characters`, so that a new entry cannot push the bar out of sight; the
/// opened list is as wide as its longest entry.
void fix_width(QComboBox* box, int characters) {
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box->setMinimumContentsLength(characters);
  box->view()->setMinimumWidth(box->view()->sizeHintForColumn(0) + 2 * box->view()->frameWidth());
}

}  // namespace

SetupBar::SetupBar(Workbench& workbench, QWidget* parent)
    : QToolBar(tr("Setup"), parent),
      workbench_(workbench),
      machine_(new QComboBox(this)),
      control_model_(new QComboBox(this)),
      tolerance_(new NumberBox(this)) {
  setObjectName(QStringLiteral("setup_bar"));
  setMovable(false);
  list_machines();
  for (const ControlModel* control : all_models()) {
    control_model_->addItem(core_text(control->info().title), QString::fromStdString(control->info().id));
    const QString summary = core_text(control->info().summary);
    control_model_->setItemData(control_model_->count() - 1, summary, Qt::ToolTipRole);
  }
  fix_width(control_model_, usual_control);
  tolerance_->setDecimals(decimals_of(Dimension::length, 4));
  tolerance_->setRange(0, in_shown_unit(10, Dimension::length));
  tolerance_->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  tolerance_->setKeyboardTracking(false);
  tolerance_->setSuffix(' ' + unit_of(Dimension::length));

  add_field(tr("&Machine"), machine_);
  add_field(tr("&Control"), control_model_);
  add_field(tr("&Tolerance"), tolerance_);

  connect(machine_, &QComboBox::activated, this, &SetupBar::choose_machine);
  connect(control_model_, &QComboBox::activated, this,
          [this] { workbench_.choose_model(control_model_->currentData().toString()); });
  connect(tolerance_, &NumberBox::valueChanged, this, &SetupBar::set_tolerance);
  connect(&workbench_.setup(), &SetupEdit::keys_changed, this, &SetupBar::show_setup);
  connect(&workbench_, &Workbench::program_changed, this, &SetupBar::show_setup);
  connect(&workbench_.setup(), &SetupEdit::values_changed, this, &SetupBar::show_tolerance);
  connect(&workbench_.runs(), &RunList::item_changed, this, &SetupBar::show_tolerance);
  show_setup();
}

void SetupBar::add_field(const QString& label, QWidget* field) {
  labels_.append(addWidget(make_label(label, field, this)));
  addWidget(field);
}

void SetupBar::resizeEvent(QResizeEvent* event) {
  QToolBar::resizeEvent(event);
  fit_in();
}

void SetupBar::fit_in() {
  constexpr int wide = 1200;  // [px]
  const bool narrow = width() < type_pixels(wide);
  for (QAction* label : labels_) {
    label->setVisible(!narrow);
  }
  constexpr int narrow_list = 9;  // letters
  machine_->setMinimumContentsLength(narrow ? narrow_list : usual_list);
  control_model_->setMinimumContentsLength(narrow ? narrow_list : usual_control);
}

/// Lists the shipped machines, then the user's with the owner of the file.
void SetupBar::list_machines() {
  machine_->clear();
  bool own = false;
  for (const MachineChoice& choice : workbench_.machine_choices()) {
    if (!choice.file.isEmpty() && !std::exchange(own, true)) {
      machine_->insertSeparator(machine_->count());
    }
    machine_->addItem(choice.owner.isEmpty() ? choice.name : tr("%1 (%2)").arg(choice.name, choice.owner),
                      choice.key());
    machine_->setItemData(machine_->count() - 1, choice.id, id_role);
    machine_->setItemData(machine_->count() - 1, choice.file, Qt::ToolTipRole);
  }
  machine_->insertSeparator(machine_->count());
  machine_->addItem(tr("Machine file …"));
  machine_->setItemData(machine_->count() - 1, tr("Open a machine file of your own"), Qt::ToolTipRole);
  fix_width(machine_, usual_list);
  fit_in();
}

void SetupBar::choose_machine() {
  if (const QVariant key = machine_->currentData(); key.isValid()) {
    workbench_.choose_machine(key.toString());
  } else {
    show_setup();  // until a file is chosen
    emit machine_file_wanted();
  }
}

void SetupBar::insert_first(const QList<QAction*>& actions) {
  QAction* first = this->actions().first();
  insertActions(first, actions);
}

void SetupBar::add_last(QAction* for_all, QAction* compare, const QList<QAction*>& output) {
  addAction(for_all);
  addAction(compare);
  auto* button = qobject_cast<QToolButton*>(widgetForAction(compare));
  button->setStyleSheet(QStringLiteral(
      "QToolButton { background: palette(highlight); color: palette(highlighted-text); border-radius: 4px; "
      "padding: 4px 8px; } QToolButton:disabled { background: palette(button); color: "
      "palette(placeholder-text); }"));
  auto* space = new QWidget(this);
  space->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  addWidget(space);
  addActions(output);
}

void SetupBar::show_setup() {
  const Setup& file = workbench_.setup().file();
  const QString id = QString::fromStdString(file.machine.id);
  if (machine_->findData(id, id_role) < 0) {
    list_machines();  // the user's own machine that has just been opened or saved
  }
  if (machine_->findData(id, id_role) < 0) {
    machine_->insertItem(0, QString::fromStdString(file.machine.name), id);
    machine_->setItemData(0, id, id_role);
  }
  machine_->setCurrentIndex(machine_->findData(id, id_role));
  // The boxes may be too narrow for the names.
  QStringList tips{machine_->currentText(), tr("Machine whose axis limits and control settings apply")};
  if (workbench_.machine_by_language()) {
    tips.append(tr("Chosen by the language of the program. For the times of your machine choose it here."));
  }
  machine_->setToolTip(tips.join(QLatin1Char('\n')));
  control_model_->setCurrentIndex(control_model_->findData(QString::fromStdString(file.model->info().id)));
  control_model_->setToolTip(control_model_->currentText() + QLatin1Char('\n') +
                             tr("Control model: how the control turns the path into motion"));
  show_tolerance();
}

void SetupBar::show_tolerance() {
  const QSignalBlocker blocker(tolerance_);
  const auto tolerance = workbench_.runs().tolerance(workbench_.runs().current_item());
  const bool is_one = tolerance && !tolerance->is_range();
  tolerance_->setEnabled(tolerance.has_value());
  tolerance_->setMinimum(is_one ? 0 : several);
  tolerance_->setSpecialValueText(is_one      ? QString()
                                  : tolerance ? tolerance_text(*tolerance)
                                              : tolerance_range({}));
  tolerance_->setValue(is_one ? in_shown_unit(tolerance->max, Dimension::length) : several);
  const QString tip = tr("Contour tolerance: how far the path may leave the programmed corners");
  tolerance_->setToolTip(tolerance ? tip + QStringLiteral("\n") + tolerance_origin(*tolerance) : tip);
}

void SetupBar::set_tolerance(double tolerance) {
  if (!workbench_.set_tolerance(from_shown_unit(tolerance, Dimension::length))) {
    show_tolerance();  // out of bounds: restores the value
  }
}

}  // namespace feedscope::ui
