#include "ui/setup/setup_view.h"

#include <QAction>
#include <QEvent>
#include <QHeaderView>
#include <QLabel>
#include <QScrollArea>
#include <QTableView>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/fields/choice_delegate.h"
#include "ui/fields/focus_outline.h"
#include "ui/language/core_texts.h"
#include "ui/language/in_language.h"
#include "ui/shared/panel_action.h"
#include "ui/theme/theme.h"
#include "ui/theme/type_size.h"
#include "ui/units/unit_system.h"
#include "ui/workbench/workbench.h"

namespace feedscope::ui {

namespace {

constexpr int row_height = 22;
constexpr int least_letters = 6;  // of the title of a column

QTableView* make_table(QAbstractItemModel* model, const QString& name, QWidget* parent) {
  auto* table = new QTableView(parent);
  table->setModel(model);
  table->setItemDelegate(new ChoiceDelegate(table));
  table->setAccessibleName(name);
  table->setSelectionMode(QAbstractItemView::SingleSelection);
  table->setTabKeyNavigation(false);
  table->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed |
                         QAbstractItemView::AnyKeyPressed);
  table->setAlternatingRowColors(true);
  table->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table->horizontalHeader()->setHighlightSections(false);
  table->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  new FocusOutline(*table);
  return table;
}

QLabel* make_heading(const QString& text, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  QFont font = label->font();
  font.setBold(true);
  label->setFont(font);
  label->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  return label;
}

/// Height that shows all rows.
int full_height(const QTableView* table) {
  return table->verticalHeader()->length() + table->horizontalHeader()->sizeHint().height() +
         2 * table->frameWidth();
}

}  // namespace

SetupView::SetupView(SetupEdit& edit, QWidget* parent)
    : Panel({QStringLiteral("machine"), tr("Machine"), Qt::RightDockWidgetArea}, parent),
      edit_(edit),
      for_all_(make_action(this, tr("Change all runs"),
                           tr("Changes are those of all runs, but for what the runs are compared in; off: of "
                              "the current run alone"))),
      scope_(new QToolButton(this)),
      axis_model_(new AxisTable(edit, axis_limit_specs(), this)),
      drive_model_(new AxisTable(edit, axis_drive_specs(), this)),
      settings_model_(new SettingsTable(edit, this)),
      machine_(new QLabel(this)),
      remarks_(new QLabel(this)),
      axes_(make_table(axis_model_, tr("Axis limits"), this)),
      drives_(make_table(drive_model_, tr("Drives"), this)),
      settings_(make_table(settings_model_, tr("Control settings"), this)),
      show_drives_(new QToolButton(this)),
      unset_(new QToolButton(this)),
      help_(new QLabel(this)),
      changes_(new QLabel(this)) {
  for (QTableView* table : {axes_, drives_}) {
    table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    table->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    table->verticalHeader()->setTextElideMode(Qt::ElideNone);
    table->verticalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter |
                                                 static_cast<Qt::Alignment>(Qt::TextWordWrap));
  }
  settings_->verticalHeader()->hide();
  settings_->setHorizontalScrollBarPolicy(Qt::ScrollBarAsNeeded);  // for a small screen
  settings_->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
  // With Fixed, text that needs more lines than hinted would be cut off.
  QSizePolicy as_high_as_its_text(QSizePolicy::Preferred, QSizePolicy::Minimum);
  as_high_as_its_text.setHeightForWidth(true);
  for (QLabel* label : {machine_, remarks_}) {
    label->setWordWrap(true);
    label->setSizePolicy(as_high_as_its_text);
  }
  remarks_->hide();
  for (QToolButton* fold : {unset_, show_drives_}) {
    fold->setCheckable(true);
    fold->setAutoRaise(true);
    fold->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);  // a panel may be narrow
    fold->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  }
  for_all_->setIconText(tr("All runs"));
  for_all_->setCheckable(true);
  for_all_->setChecked(edit_.for_all());
  connect(for_all_, &QAction::toggled, &edit_, &SetupEdit::set_for_all);
  scope_->setDefaultAction(for_all_);
  scope_->setToolButtonStyle(Qt::ToolButtonTextOnly);
  show_scope(1);
  show_drives_->setToolTip(tr(
      "How the axes follow their set values: position gain, feed-forward, backlash. Without a gain an axis "
      "follows exactly"));
  connect(show_drives_, &QToolButton::toggled, this, &SetupView::hide_drives);
  connect(unset_, &QToolButton::toggled, this, &SetupView::hide_unset);
  help_->setWordWrap(true);
  help_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  help_->setTextInteractionFlags(Qt::TextSelectableByMouse);

  changes_->setWordWrap(true);
  changes_->setTextFormat(Qt::RichText);
  changes_->setTextInteractionFlags(Qt::LinksAccessibleByMouse | Qt::LinksAccessibleByKeyboard);
  connect(changes_, &QLabel::linkActivated, &edit_, &SetupEdit::reset);

  auto* content = new QWidget(this);
  auto* scroll = new QScrollArea(this);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setWidgetResizable(true);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setFocusPolicy(Qt::NoFocus);
  auto* whole = new QVBoxLayout(this);
  whole->setContentsMargins(0, 0, 0, 0);
  whole->addWidget(scroll);
  auto* layout = new QVBoxLayout(content);
  layout->setContentsMargins(6, 6, 6, 6);
  layout->setSpacing(4);
  layout->addWidget(machine_);
  layout->addWidget(remarks_);
  layout->addWidget(scope_);
  layout->addWidget(make_heading(tr("Axis limits"), this));
  layout->addWidget(axes_);
  layout->addWidget(show_drives_);
  layout->addWidget(drives_);
  layout->addWidget(make_heading(tr("Control settings"), this));
  layout->addWidget(settings_, 1);
  layout->addWidget(unset_);
  layout->addWidget(changes_);
  layout->addWidget(help_);
  layout->addStretch();
  scroll->setWidget(content);  // large type on a low screen: nothing overlaps

  connect(&TypeSize::of_application(), &TypeSize::changed, this,
          [this] { QTimer::singleShot(0, this, &SetupView::fit_type); });
  for (QTableView* table : {axes_, drives_, settings_}) {
    connect(table->selectionModel(), &QItemSelectionModel::currentChanged, this, &SetupView::explain);
  }
  connect(axis_model_, &SetupTable::refused, this,
          [this](const QModelIndex& index, const QString& message) { refuse(axes_, index, message); });
  connect(drive_model_, &SetupTable::refused, this,
          [this](const QModelIndex& index, const QString& message) { refuse(drives_, index, message); });
  connect(settings_model_, &SetupTable::refused, this,
          [this](const QModelIndex& index, const QString& message) { refuse(settings_, index, message); });
  connect(settings_->verticalHeader(), &QHeaderView::sectionResized, this, &SetupView::fit_settings);
  connect(&edit_, &SetupEdit::keys_changed, this, &SetupView::fit_tables);
  connect(&edit_, &SetupEdit::values_changed, this, &SetupView::show_changes);
  connect(&edit_, &SetupEdit::values_changed, this, &SetupView::hide_unset);
  connect(&edit_, &SetupEdit::values_changed, this, &SetupView::hide_drives);
  connect(axis_model_, &QAbstractItemModel::dataChanged, this, [this] { explain(explained_); });
  fit_tables();
  fit_type();
  axes_->installEventFilter(this);
}

/// Fits the row heights to the font.
void SetupView::fit_type() {
  constexpr int least_settings = 4;  // visible rows, however low the panel is
  constexpr int help_lines = 6;
  for (QTableView* table : {axes_, drives_}) {
    table->verticalHeader()->setMinimumSectionSize(type_pixels(row_height));
    table->verticalHeader()->setDefaultSectionSize(type_pixels(row_height));
  }
  fit_names();
  settings_->verticalHeader()->setMinimumSectionSize(type_pixels(row_height));
  settings_->resizeRowsToContents();
  fit_settings();
  settings_->setMinimumHeight(
      std::min(settings_->maximumHeight(), (least_settings + 1) * type_pixels(row_height)));
  help_->setMinimumHeight(help_lines * fontMetrics().height());
}

/// Breaks the names of limits into enough lines that the values of all axes fit.
void SetupView::fit_names() {
  constexpr int beside = 12;  // [px] left and right of a name
  for (QTableView* table : {axes_, drives_}) {
    const QAbstractItemModel& model = *table->model();
    QHeaderView* names = table->verticalHeader();
    const QHeaderView& axes = *table->horizontalHeader();
    const auto& view = static_cast<const QAbstractItemView&>(*table);  // its size hints are public
    int values = 2 * table->frameWidth();
    for (int column = 0; column < model.columnCount(); ++column) {
      values +=
          std::max({view.sizeHintForColumn(column), axes.sectionSizeHint(column), axes.minimumSectionSize()});
    }
    names->setMaximumWidth(std::max(table->width() / 3, table->width() - values));
    const int room = std::min(names->maximumWidth(), names->sizeHint().width()) - type_pixels(beside);
    for (int row = 0; row < model.rowCount(); ++row) {
      const QString name = model.headerData(row, Qt::Vertical).toString();
      const QRect words = names->fontMetrics().boundingRect(QRect(0, 0, room, 1000), Qt::TextWordWrap, name);
      const int above = type_pixels(row_height) - names->fontMetrics().height();
      names->resizeSection(row, words.height() + std::max(0, above));
    }
    table->setFixedHeight(full_height(table));
  }
}

bool SetupView::eventFilter(QObject* watched, QEvent* event) {
  if (watched == axes_ && event->type() == QEvent::Resize) {
    fit_names();
    fit_settings();
  }
  return Panel::eventFilter(watched, event);
}

/// Narrows the ranges, which tooltips show too, if the names need the room.
void SetupView::fit_settings() {
  const auto& view = static_cast<const QAbstractItemView&>(*settings_);  // its size hints are public
  const QHeaderView& titles = *settings_->horizontalHeader();
  int width = 0;
  for (int column = 0; column < SettingsTable::columns; ++column) {
    width +=
        std::max(view.sizeHintForColumn(column), titles.fontMetrics().averageCharWidth() * least_letters);
  }
  settings_->setColumnHidden(SettingsTable::range, width > settings_->viewport()->width());
  settings_->setMaximumHeight(full_height(settings_));
}

QString SetupView::changes() const {
  return changes_of(edit_.state()).join(QStringLiteral("\n"));
}

void SetupView::show_remarks(const std::vector<Remark>& remarks) {
  QStringList sentences;
  for (const Remark& remark : remarks) {
    sentences.append(in_language(remark.text));
  }
  remarks_->setText(sentences.join(QStringLiteral("\n")));
  remarks_->setVisible(!sentences.isEmpty());
}

void SetupView::show_changes() {
  constexpr qsizetype most = 6;
  QStringList lines = changes_of(edit_.state());
  const qsizetype more = lines.size() - most;
  changes_->setVisible(!lines.isEmpty());
  changes_->setToolTip(lines.join(QStringLiteral("\n")));
  for (QString& line : lines) {
    line = line.toHtmlEscaped();
  }
  if (more > 0) {
    lines = lines.mid(0, most);
    lines.append(tr("and %n more", nullptr, static_cast<int>(more)));
  }
  changes_->setText(
      QStringLiteral("<p><b>%1</b> <a href=\"reset\">%2</a><br>%3</p>")
          .arg(tr("Changed from the file:"), tr("back to the file"), lines.join(QStringLiteral("<br>"))));
}

void SetupView::show_key(const std::string& key) {
  QTableView* table = settings_;
  QModelIndex index = settings_model_->index(settings_model_->row_of(key), SettingsTable::value);
  for (AxisTable* model : {axis_model_, drive_model_}) {
    if (const QModelIndex cell = model->index_of(key); cell.isValid()) {
      table = model == axis_model_ ? axes_ : drives_;
      index = cell;
    }
  }
  if (index.isValid()) {
    if (table == settings_ && settings_->isRowHidden(index.row())) {
      unset_->setChecked(true);
    }
    if (table == drives_) {
      show_drives_->setChecked(true);
    }
    table->setCurrentIndex(index);
    table->scrollTo(index);
    table->setFocus();
  }
}

QString SetupView::message() const {
  return help_->text();
}

void SetupView::fit_tables() {
  show_changes();
  const Setup& file = edit_.file();
  machine_->setText(QStringLiteral("<b>%1</b><br>%2<br>%3")
                        .arg(QString::fromStdString(file.machine.name).toHtmlEscaped(),
                             QString::fromStdString(file.machine.control).toHtmlEscaped(),
                             core_text(file.model->info().title).toHtmlEscaped()));
  machine_->setToolTip(QString::fromStdString(file.machine.reference).toHtmlEscaped());
  QHeaderView* header = settings_->horizontalHeader();
  header->setSectionResizeMode(QHeaderView::ResizeToContents);
  header->setSectionResizeMode(SettingsTable::title, QHeaderView::Stretch);
  help_->setStyleSheet({});
  const bool any_settings = settings_model_->rowCount() > 0;
  hide_unset();
  hide_drives();
  fit_names();
  const QString how =
      tr("Select a value to see what it means. Bold: changed. Italic: assumed, without a source.");
  help_->setText(any_settings ? how : tr("This model has no control settings.") + "<br>" + how);
}

/// Explanation of settings without a value.
QString SetupView::unset_tip(bool has_rotary_axes) {
  const auto paragraph = [](const QString& text) {  // wraps, unlike plain text
    return QStringLiteral("<p>%1</p>").arg(text.toHtmlEscaped());
  };
  const QString tip = paragraph(
      tr("Settings that have no value on this machine. Times of tool changes and spindle starts add to the "
         "cycle time; home, tool change position and part zero let moves to machine positions be drawn and "
         "timed."));
  return has_rotary_axes
             ? tip +
                   paragraph(tr(
                       "Tool length and part zero say how X, Y and Z follow the rotary axes, the orientation "
                       "tolerance how far their turns are rounded where blocks meet, and an angle of the "
                       "part "
                       "how it is turned in the clamping."))
             : tip;
}

/// Hides rows without a value; shown ones remain while the button is down.
void SetupView::hide_unset() {
  int count = 0;
  for (int row = 0; row < settings_model_->rowCount(); ++row) {
    const bool is_unset = settings_model_->is_unset(row);
    count += is_unset ? 1 : 0;
    settings_->setRowHidden(row, is_unset && !unset_->isChecked());
  }
  settings_->setVisible(unset_->isChecked() || count < settings_model_->rowCount());
  unset_->setVisible(count > 0);
  unset_->setText(tr("Other settings (%n unset)", nullptr, count));
  unset_->setToolTip(unset_tip(!edit_.file().machine.kinematics.empty()));
  unset_->setArrowType(unset_->isChecked() ? Qt::DownArrow : Qt::RightArrow);
  fit_settings();
}

/// Hides the drives, unless an axis has one or the user requests them.
void SetupView::hide_drives() {
  const bool any = drive_model_->has_values();
  const bool shown = any || show_drives_->isChecked();
  drives_->setVisible(shown);
  show_drives_->setText(any ? tr("Drives") : tr("Drives: none"));
  show_drives_->setArrowType(shown ? Qt::DownArrow : Qt::RightArrow);
  drives_->setFixedHeight(full_height(drives_));
}

void SetupView::explain(const QModelIndex& index) {
  if (index.isValid()) {
    explained_ = index;
    help_->setStyleSheet({});
    help_->setText(index.data(Qt::ToolTipRole).toString());
  }
}

void SetupView::refuse(QTableView* table, const QModelIndex& index, const QString& message) {
  help_->setStyleSheet(QStringLiteral("color: %1;").arg(theme_colours(palette()).error.name()));
  help_->setText(message);
  table->setCurrentIndex(index);
}

void SetupView::follow(Workbench& workbench) {
  const auto show_run = [this, &workbench] {
    const auto shown = workbench.shown();
    show_remarks(shown == nullptr ? std::vector<Remark>() : remarks(shown->run, unit_system()));
  };
  connect(&workbench, &Workbench::run_changed, this, show_run);
  const auto show_scope_of = [this, &runs = workbench.runs()] { show_scope(runs.items().size()); };
  connect(&workbench.runs(), &RunList::list_changed, this, show_scope_of);
  show_scope_of();
  show_run();
}

void SetupView::show_scope(std::size_t runs) {
  for_all_->setVisible(runs > 1);
  scope_->setVisible(runs > 1);
}

}  // namespace feedscope::ui
