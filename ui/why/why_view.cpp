#include "ui/why/why_view.h"

#include <QEvent>
#include <QFrame>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QScrollArea>
#include <QTableView>
#include <QTextDocument>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <chrono>

#include "ui/fields/focus_outline.h"
#include "ui/language/texts.h"
#include "ui/shared/panel_action.h"
#include "ui/shared/row_copy.h"
#include "ui/theme/cause_colours.h"
#include "ui/theme/theme.h"
#include "ui/theme/type_size.h"
#include "ui/why/why_text.h"
#include "ui/workbench/workbench.h"

namespace feedscope::ui {

namespace {

// Up to these, changes are tried without a request.
constexpr std::size_t short_program = 20'000;  // [blocks]
constexpr double short_simulation = 0.3;       // [s]
constexpr auto resting_time = std::chrono::milliseconds(500);
constexpr int margin = 8;

/// A square in the colour of the cause in scene and charts.
QIcon icon_of(CauseKind kind, ThemeKind theme) {
  constexpr int size = 12;
  QPixmap square(size, size);
  square.fill(colour_of_cause(kind, theme));
  return square;
}

QString plain(const QString& rich) {
  QTextDocument document;
  document.setHtml(rich);
  return document.toPlainText();
}

/// A box with its own background for formulas.
QFrame* make_box(QWidget* parent) {
  auto* box = new QFrame(parent);
  box->setFrameShape(QFrame::StyledPanel);
  box->setBackgroundRole(QPalette::Base);
  box->setAutoFillBackground(true);
  auto* layout = new QVBoxLayout(box);
  layout->setContentsMargins(margin, margin / 2, margin, margin / 2);
  layout->setSpacing(2);
  return box;
}

}  // namespace

WhyView::WhyView(Cursor& cursor, QWidget* parent)
    : Panel({QStringLiteral("why"), tr("Why here?"), Qt::RightDockWidgetArea}, parent),
      cursor_(cursor),
      table_model_(new RemedyTable(this)) {
  rest_.setSingleShot(true);
  rest_.setInterval(resting_time);
  make_actions();
  lay_out();
  connect(&cursor_, &Cursor::changed, this, &WhyView::note_change);
  connect(&rest_, &QTimer::timeout, this, [this] {
    if (is_seen()) {  // only a command may bring a hidden panel up
      try_remedies();
    }
  });
  connect(&job_, &RemedyJob::tried, this, &WhyView::take_trial);
  connect(&job_, &RemedyJob::finished, this, [this] {
    table_model_->sort_by_gain();
    show_table_state();
  });
  show_nothing();
}

void WhyView::follow(Workbench& workbench) {
  const auto show_run = [this, &workbench] { set_run(workbench.shown(), workbench.setup().state()); };
  connect(&workbench, &Workbench::run_changed, this, show_run);
  connect(this, &WhyView::time_chosen, &workbench.cursor(), &Cursor::set_time);
  connect(this, &WhyView::run_wanted, &workbench, [&workbench](const SetupState& setup) {
    workbench.runs().duplicate_as(workbench.runs().current(), setup);
  });
  show_run();
}

QAction* WhyView::add_action(const QString& text, const QString& tip, const QKeySequence& key,
                             void (WhyView::*call)()) {
  actions_.append(make_action(this, text, tip, key, call));
  return actions_.last();
}

void WhyView::make_actions() {
  before_action_ = add_action(tr("&Previous cause"), tr("Go to the start of the previous limiting cause"),
                              QKeySequence(tr("Alt+Shift+Left")), &WhyView::go_before);
  after_action_ = add_action(tr("&Next cause"), tr("Go to the start of the next limiting cause"),
                             QKeySequence(tr("Alt+Shift+Right")), &WhyView::go_after);
  ahead_action_ = add_action(tr("&Slower place ahead"), tr("Go to the place that the tool brakes for"),
                             QKeySequence(tr("Alt+Shift+Down")), &WhyView::go_ahead);
  help_action_ =
      add_action(tr("&What would help?"),
                 tr("Simulate changes of machine, control and feed, and show the time that each saves [s]"),
                 QKeySequence(tr("Ctrl+Shift+H")), &WhyView::try_remedies);
  run_action_ = add_action(tr("New &run with this change"), tr("Create a new run with the selected change"),
                           {}, &WhyView::want_run);
}

QLabel* WhyView::add_label(QWidget* parent) {
  auto* label = new QLabel(parent);
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  label->setMinimumSize(1, 1);  // else the height at the narrowest width would count
  label->setFocusPolicy(Qt::NoFocus);
  parent->layout()->addWidget(label);
  return label;
}

QToolButton* WhyView::add_button(QAction* action) {
  auto* button = new QToolButton(this);
  button->setDefaultAction(action);
  button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  button->setAutoRaise(true);
  button->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  return button;
}

void WhyView::make_table() {
  table_ = new QTableView(this);
  table_->setModel(table_model_);
  table_->setAccessibleName(tr("Changes and the time they save"));
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setAlternatingRowColors(true);
  table_->setTabKeyNavigation(false);
  install_row_copy(*table_);
  table_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  table_->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setHighlightSections(false);
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setSectionResizeMode(RemedyTable::change, QHeaderView::Stretch);
  // Queued: the header announces a higher row before its own length includes it.
  const QHeaderView* rows = table_->verticalHeader();
  connect(rows, &QHeaderView::geometriesChanged, this, &WhyView::fit_table, Qt::QueuedConnection);
  connect(rows, &QHeaderView::sectionResized, this, &WhyView::fit_table, Qt::QueuedConnection);
  connect(rows, &QHeaderView::sectionCountChanged, this, &WhyView::fit_table, Qt::QueuedConnection);
  connect(table_, &QTableView::activated, this, &WhyView::want_run);
  connect(table_->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
          &WhyView::show_table_state);
}

void WhyView::lay_out() {
  auto* content = new QWidget(this);
  auto* layout = new QVBoxLayout(content);
  layout->setContentsMargins(margin, margin, margin, margin);
  heading_ = add_label(content);
  QFont font = heading_->font();
  font.setBold(true);
  heading_->setFont(font);
  set_type_pixels(*heading_, 14);
  place_ = add_label(content);
  sentence_ = add_label(content);
  drives_ = add_label(content);
  QFrame* box = make_box(content);
  layout->addWidget(box);
  formula_ = add_label(box);
  source_ = add_label(box);

  ahead_box_ = make_box(content);
  layout->addWidget(ahead_box_);
  ahead_heading_ = add_label(ahead_box_);
  ahead_sentence_ = add_label(ahead_box_);
  ahead_formula_ = add_label(ahead_box_);
  ahead_source_ = add_label(ahead_box_);
  ahead_button_ = add_button(ahead_action_);
  ahead_box_->layout()->addWidget(ahead_button_);

  before_button_ = add_button(before_action_);
  after_button_ = add_button(after_action_);
  layout->addWidget(before_button_);
  layout->addWidget(after_button_);

  help_ = new QPushButton(help_action_->text(), content);
  help_->setToolTip(help_action_->toolTip());
  connect(help_, &QPushButton::clicked, help_action_, &QAction::trigger);
  layout->addWidget(help_);
  help_state_ = add_label(content);
  make_table();
  layout->addWidget(table_);
  new_run_ = new QPushButton(run_action_->text(), content);
  new_run_->setToolTip(run_action_->toolTip());
  connect(new_run_, &QPushButton::clicked, run_action_, &QAction::trigger);
  layout->addWidget(new_run_);
  layout->addStretch(1);

  auto* scroll = new QScrollArea(this);
  scroll->setWidgetResizable(true);
  new FocusOutline(*scroll);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setWidget(content);
  auto* own = new QVBoxLayout(this);
  own->setContentsMargins(0, 0, 0, 0);
  own->addWidget(scroll);
}

void WhyView::set_run(std::shared_ptr<const ShownRun> shown, const SetupState& setup) {
  if (shown == shown_ && setup_ == setup) {
    return;
  }
  shown_ = std::move(shown);
  setup_ = setup;
  stretch_.reset();
  forget_remedies();
  note_change();
}

void WhyView::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (is_seen()) {
    catch_up();
  }
}

void WhyView::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) {
    show_place();
  }
}

void WhyView::set_on_screen(bool on_screen) {
  on_screen_ = on_screen;
  if (is_seen()) {
    catch_up();
  }
}

void WhyView::note_change() {
  stale_ = !is_seen();
  if (!stale_) {
    show_place();
    return;
  }
  for (QAction* action : {before_action_, after_action_, ahead_action_, help_action_}) {
    action->setEnabled(shown_ != nullptr && cursor_.valid());  // they check again when they are triggered
  }
}

void WhyView::show_place() {
  stale_ = false;
  const bool same_run = shown_ != nullptr && cursor_.trajectory() == shown_->run.trajectory;
  if (!same_run || !cursor_.valid()) {
    show_nothing();
    return;
  }
  why_ = explain(shown_->run, cursor_.state());
  find_stretch();
  const Cause cause = why_->ahead ? why_->ahead->reason.cause : why_->reason.cause;
  if (tried_ && cause != tried_for_) {
    forget_remedies();
  }
  show_reason(*why_);
  show_ahead(*why_);
  show_neighbours();
  show_table_state();
  const bool by_itself =
      shown_->run.path->segments.size() < short_program && shown_->run.simulate_time < short_simulation;
  if (by_itself && !tried_) {
    rest_.start();
  }
}

void WhyView::show_nothing() {
  why_.reset();
  stretch_.reset();
  before_.reset();
  after_.reset();
  forget_remedies();
  heading_->setText(tr("Why here?"));
  place_->clear();
  sentence_->setText(tr("Open a program and point at a place to see what limits the feed there."));
  drives_->hide();
  formula_->parentWidget()->hide();
  ahead_box_->hide();
  ahead_action_->setEnabled(false);
  show_neighbours();
  show_table_state();
}

void WhyView::show_reason(const Explanation& why) {
  const State& state = why.state;
  heading_->setText(
      QStringLiteral("<span style='color:%1'>■</span> %2")
          .arg(colour_of_cause(state.cause.kind, theme_of(palette())).name(), WhyText::cause(state.cause)));
  const QString feed = WhyText::speed(state.speed);
  place_->setText(
      state.programmed_feed > 0
          ? tr("Line %1, %2 s: %3 of %4, %5\u00a0%")
                .arg(QString::number(state.line), QLocale().toString(state.time, 'f', 3), feed,
                     WhyText::speed(state.programmed_feed),
                     QLocale().toString(std::abs(100 * state.speed / state.programmed_feed), 'f', 0))
          : tr("Line %1, %2 s").arg(QString::number(state.line), QLocale().toString(state.time, 'f', 3)));
  sentence_->setText(WhyText::sentence(why));
  drives_->setText(WhyText::drives(shown_->run.sources.actual.get(), state));
  drives_->setVisible(!drives_->text().isEmpty());
  const QString formula = WhyText::formula(why.reason);
  const QString muted = theme_colours(palette()).muted.name();
  formula_->parentWidget()->setVisible(!formula.isEmpty());
  formula_->setText(formula);
  source_->setText(
      QStringLiteral("<span style='color:%1'>%2</span>").arg(muted, WhyText::source(why.reason)));
}

void WhyView::show_ahead(const Explanation& why) {
  ahead_box_->setVisible(why.ahead.has_value());
  ahead_action_->setEnabled(why.ahead.has_value());
  if (!why.ahead) {
    return;
  }
  const Reason& reason = why.ahead->reason;
  const QString formula = WhyText::formula(reason);
  const QString muted = theme_colours(palette()).muted.name();
  ahead_heading_->setText(
      QStringLiteral("<span style='color:%1'>■</span> <b>%2</b>")
          .arg(colour_of_cause(reason.cause.kind, theme_of(palette())).name(), WhyText::cause(reason.cause)));
  ahead_sentence_->setText(WhyText::sentence(*why.ahead, why.state));
  ahead_formula_->setText(formula);
  ahead_formula_->setVisible(!formula.isEmpty());
  ahead_source_->setText(
      QStringLiteral("<span style='color:%1'>%2</span>").arg(muted, WhyText::source(reason)));
  ahead_source_->setVisible(!formula.isEmpty());
  ahead_button_->setText(tr("▸ Go to line %1").arg(QString::number(reason.line)));
}

void WhyView::find_stretch() {
  const double time = cursor_.state().time;
  if (stretch_ && time >= stretch_->from && time < stretch_->to) {
    return;
  }
  stretch_ = stretch_at(trajectory(), time);
  before_ = stretch_before(trajectory(), *stretch_);
  after_ = stretch_after(trajectory(), *stretch_);
}

void WhyView::show_neighbours() {
  const auto show = [this](QToolButton* button, QAction* action, const std::optional<CauseStretch>& stretch,
                           const QString& text) {
    button->setVisible(shown_ != nullptr && stretch.has_value());
    action->setEnabled(stretch.has_value());
    if (stretch) {
      button->setIcon(icon_of(stretch->cause.kind, theme_of(palette())));
      button->setAccessibleName(text.arg(WhyText::cause(stretch->cause), QString::number(stretch->line)));
    }
  };
  show(before_button_, before_action_, before_, tr("◂ %1, line %2"));
  show(after_button_, after_action_, after_, tr("▸ %1, line %2"));
  fit_buttons();
}

void WhyView::fit_buttons() {
  constexpr int around_text = 56;  // [px]: icon, margins, scroll bar
  for (QToolButton* button : {before_button_, after_button_}) {
    const QString whole = button->accessibleName();
    button->setText(button->fontMetrics().elidedText(whole, Qt::ElideRight,
                                                     std::max(0, width() - type_pixels(around_text))));
    button->setToolTip(whole);
  }
}

void WhyView::resizeEvent(QResizeEvent* event) {
  Panel::resizeEvent(event);
  fit_buttons();
}

SegmentRange WhyView::segments_here() const {
  const double time = cursor_.state().time;
  const auto& places = shown_->slow_places->places;
  const auto after = std::ranges::upper_bound(places, time, {}, &SlowPlace::from);
  if (after != places.begin() && time < std::prev(after)->to) {
    return segments_between(trajectory(), std::prev(after)->from, std::prev(after)->to);
  }
  return segments_between(trajectory(), stretch_->from, stretch_->to);
}

void WhyView::catch_up() {
  if (stale_) {
    show_place();
  }
}

void WhyView::try_remedies() {
  catch_up();
  if (!is_seen()) {
    emit attention_wanted();
  }
  rest_.stop();
  if (shown_ == nullptr || !why_) {
    return;
  }
  tried_ = true;
  tried_for_ = why_->ahead ? why_->ahead->reason.cause : why_->reason.cause;
  RemedyRequest request{shown_->run,
                        feedscope::remedies(shown_->run.setup, *why_, shown_->run.input.feed_controls),
                        segments_here()};
  const RemedyTrial before{trajectory().duration(), passage_time(trajectory(), request.here), {}};
  table_model_->begin(shown_->run.setup, request.remedies, before);
  job_.start(std::move(request));
  show_table_state();
}

void WhyView::take_trial(std::size_t index, const RemedyTrial& trial) {
  table_model_->set_trial(index, trial);
}

void WhyView::forget_remedies() {
  rest_.stop();
  job_.cancel();
  tried_ = false;
  table_model_->clear();
}

void WhyView::show_table_state() {
  const bool any = table_model_->rowCount() > 0;
  help_->setVisible(why_.has_value() && !any);
  help_action_->setEnabled(why_.has_value());
  help_state_->setVisible(any);
  help_state_->setText(job_.busy() ? tr("What would help? Simulating …")
                                   : tr("What would help, each change simulated separately:"));
  table_->setVisible(any);
  const Remedy* chosen = table_model_->remedy(table_->currentIndex().row());
  run_action_->setEnabled(chosen != nullptr);
  new_run_->setVisible(any);
  new_run_->setEnabled(chosen != nullptr);
}

/// As high as its rows: the panel scrolls as a whole.
void WhyView::fit_table() {
  table_->setFixedHeight(table_->verticalHeader()->length() +
                         table_->horizontalHeader()->sizeHint().height() + 2 * table_->frameWidth());
}

void WhyView::go_before() {
  catch_up();
  if (before_) {
    emit time_chosen(before_->from);
  }
}

void WhyView::go_after() {
  catch_up();
  if (after_) {
    emit time_chosen(after_->from);
  }
}

void WhyView::go_ahead() {
  catch_up();
  if (why_ && why_->ahead) {
    emit time_chosen(why_->ahead->time);
  }
}

void WhyView::want_run() {
  const Remedy* chosen = table_model_->remedy(table_->currentIndex().row());
  if (chosen == nullptr || !setup_) {
    return;
  }
  SetupState setup = *setup_;
  for (const auto& [key, value] : chosen->changes) {
    setup.set(key, value);
  }
  emit run_wanted(setup);
}

QString WhyView::cause_text() const {
  return plain(heading_->text());
}

QString WhyView::drives_text() const {
  return drives_->text();
}

QString WhyView::sentence_text() const {
  return sentence_->text();
}

QString WhyView::formula_text() const {
  return plain(formula_->text());
}

}  // namespace feedscope::ui
