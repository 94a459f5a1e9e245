#include "ui/lessons/lesson_view.h"

#include <QAction>
#include <QClipboard>
#include <QCoreApplication>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QSplitter>
#include <QStackedWidget>
#include <QTextBrowser>
#include <QToolButton>
#include <QUrl>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "core/base/markdown.h"
#include "core/base/typed_number.h"
#include "ui/fields/focus_outline.h"
#include "ui/fields/short_number_box.h"
#include "ui/language/texts.h"
#include "ui/language/whole_units.h"
#include "ui/lessons/fit_to_text.h"
#include "ui/lessons/lesson_tries.h"
#include "ui/lessons/tries_table.h"
#include "ui/shared/flow_layout.h"
#include "ui/shared/panel_action.h"
#include "ui/shared/row_copy.h"

namespace feedscope::ui {

namespace {

QTextBrowser* make_browser(const QString& name, QWidget* parent) {
  auto* browser = new QTextBrowser(parent);
  new FocusOutline(*browser);
  browser->setAccessibleName(name);
  browser->setFrameShape(QFrame::NoFrame);
  browser->setOpenLinks(false);
  return browser;
}

/// A button for an action; it stays pressed while a checkable action is checked.
QPushButton* make_button(QAction* action, QWidget* parent) {
  auto* button = new QPushButton(action->text(), parent);
  button->setToolTip(action->toolTip());
  button->setCheckable(action->isCheckable());
  QObject::connect(button, &QPushButton::clicked, action, &QAction::trigger);
  QObject::connect(action, &QAction::changed, button, [button, action] {
    button->setEnabled(action->isEnabled());
    button->setChecked(action->isChecked());
  });
  return button;
}

QToolButton* make_arrow(QAction* action, Qt::ArrowType arrow, QWidget* parent) {
  auto* button = new QToolButton(parent);
  button->setDefaultAction(action);
  button->setArrowType(arrow);
  button->setToolButtonStyle(Qt::ToolButtonIconOnly);
  return button;
}

/// HTML of Markdown; unlike that of QTextDocument with space between paragraphs.
QString as_html(const QString& markdown) {
  return with_whole_units(QString::fromStdString(markdown_as_html(markdown.toStdString())));
}

/// Lays out at once: heights depend on widths, and the places of all widgets on these heights.
void settle_heights() {
  for (int turn = 0; turn < 2; ++turn) {
    QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
  }
}

bool is_setting(const std::string& key) {
  return key != "program" && key != "machine" && key != "model";
}

bool takes_numbers(const Control& control) {
  return std::ranges::all_of(control.values,
                             [](const std::string& value) { return typed_number(value).value.has_value(); });
}

}  // namespace

LessonView::LessonView(LessonDesk& desk, QWidget* parent)
    : Panel({QStringLiteral("lesson"), tr("Lesson"), Qt::RightDockWidgetArea, false}, parent),
      desk_(desk),
      pages_(new QStackedWidget(this)),
      list_(make_browser(tr("Lessons"), this)),
      text_(make_browser(tr("Text of the lesson"), this)),
      next_(new QPushButton(tr("Next step"), this)),
      number_(new QLabel(this)),
      question_(make_browser(tr("Question"), this)),
      control_(new QWidget(this)),
      key_(new QLabel(control_)),
      values_(new QWidget(control_)),
      own_(new QWidget(values_)),
      own_value_(new ShortNumberBox(own_)),
      show_setting_(new QToolButton(control_)),
      value_(new QLabel(this)),
      lower_(new QStackedWidget(this)),
      predict_text_(make_browser(tr("Before you look"), this)),
      own_prediction_(new QPlainTextEdit(this)),
      predict_(new QPushButton(tr("Show the run"), this)),
      transfer_(new QPlainTextEdit(this)),
      tried_(new QWidget(this)),
      tries_(new TriesTable(tried_)),
      own_answer_(new QPlainTextEdit(this)),
      expected_(make_browser(tr("Expected answer"), this)),
      work_(new QScrollArea(this)),
      halves_(new QSplitter(Qt::Vertical, this)) {
  make_actions();
  make_own_value();
  set_up_ = make_button(set_up_action_, this);
  return_ = make_button(return_action_, this);
  before_ = make_arrow(before_action_, Qt::LeftArrow, this);
  after_ = make_arrow(after_action_, Qt::RightArrow, this);
  hint_ = make_button(hint_action_, this);
  answer_ = make_button(answer_action_, this);
  value_->setTextFormat(Qt::RichText);
  value_->setWordWrap(true);
  key_->setWordWrap(true);
  fit_to_text(*question_);
  fit_to_text(*expected_);
  fit_to_lines(*own_answer_);
  fit_to_lines(*own_prediction_);
  fit_to_text(*predict_text_);
  fit_to_lines(*transfer_);
  own_answer_->setAccessibleName(tr("Your own answer"));
  own_answer_->setPlaceholderText(tr("Your own answer"));
  own_answer_->setToolTip(tr("Your own answer, kept with the session"));
  own_answer_->setTabChangesFocus(true);
  show_setting_->setText(tr("Show setting"));
  show_setting_->setToolTip(tr("Show the setting in the tables of axis limits and control settings"));
  lay_out();
  offer_return(false);

  connect(list_, &QTextBrowser::anchorClicked, this, [this](const QUrl& link) {
    desk_.open(desk_.entries()[link.path().toULongLong()].file, !desk_.unlocked());
  });
  connect(show_setting_, &QToolButton::clicked, this, [this] {
    emit setting_wanted(QString::fromStdString(desk_.lesson()->questions[desk_.question()].control.key));
  });
  connect(own_answer_, &QPlainTextEdit::textChanged, this,
          [this] { desk_.set_answer(own_answer_->toPlainText()); });
  connect(transfer_, &QPlainTextEdit::textChanged, this,
          [this] { desk_.set_transfer(transfer_->toPlainText()); });
  connect(own_prediction_, &QPlainTextEdit::textChanged, this, [this] {
    desk_.set_draft(own_prediction_->toPlainText());
    predict_->setEnabled(!own_prediction_->toPlainText().trimmed().isEmpty());
  });
  connect(predict_, &QPushButton::clicked, this, [this] { desk_.predict(own_prediction_->toPlainText()); });
  next_->setToolTip(tr("Go on to the question"));
  next_->hide();
  connect(next_, &QPushButton::clicked, this, [this] { read_text(false); });
  connect(&desk_, &LessonDesk::cover_changed, this, &LessonView::show_cover);
  connect(&desk_, &LessonDesk::listed, this, &LessonView::show_list);
  connect(&desk_, &LessonDesk::opened, this, &LessonView::show_lesson);
  connect(&desk_, &LessonDesk::question_changed, this, &LessonView::show_question);
  connect(&desk_, &LessonDesk::value_changed, this, &LessonView::show_value);
  connect(&desk_, &LessonDesk::work_changed, this, &LessonView::show_work);
  show_list();
}

void LessonView::make_own_value() {
  constexpr double largest = 1e9;
  constexpr int decimals = 5;
  own_value_->setRange(-largest, largest);
  own_value_->setDecimals(decimals);
  own_value_->setButtonSymbols(QAbstractSpinBox::NoButtons);
  own_value_->setAccessibleName(tr("Another value"));
  own_value_->setToolTip(tr("Type another value to try"));
  auto* set = new QToolButton(own_);
  set->setText(tr("Try"));
  set->setToolTip(tr("Set this value in the current run"));
  connect(set, &QToolButton::clicked, this, &LessonView::try_own_value);
  connect(own_value_->findChild<QLineEdit*>(), &QLineEdit::returnPressed, this, &LessonView::try_own_value);
  auto* layout = new QHBoxLayout(own_);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2);
  layout->addWidget(own_value_);
  layout->addWidget(set);
}

void LessonView::make_actions() {
  set_up_action_ = make_action(
      this, tr("Set up the window"),
      tr("Open the program of the lesson with its machine, settings and view; this replaces the runs"));
  return_action_ = make_action(
      this, tr("Back to my own"),
      tr("Bring back the program, runs, settings and view that were in the window before the lesson"));
  before_action_ = make_action(this, tr("Previous question"), tr("Go to the previous question"));
  after_action_ = make_action(this, tr("Next question"), tr("Go to the next question"));
  hint_action_ = make_action(this, tr("Hint"), tr("Show or hide the hint of the question"));
  answer_action_ = make_action(this, tr("Show answer"), tr("Show or hide the answer to the question"));
  hint_action_->setCheckable(true);
  answer_action_->setCheckable(true);
  list_action_ = make_action(this, tr("All lessons"), tr("Show the list of lessons"));
  copy_action_ = make_action(this, tr("Copy the values tried"),
                             tr("Copy the values tried at this question, for a text or a spreadsheet"));
  csv_action_ = make_action(this, tr("Copy the values tried as CSV"),
                            tr("Copy the values tried at this question as CSV, with decimal points"));
  clear_action_ = make_action(
      this, tr("Clear the values tried"),
      tr("Forget the values tried at this question; the answer stays. Edit > Undo brings them back"));
  unlock_action_ = make_action(this, tr("Runs without a prediction"),
                               tr("For teachers: show the run of a lesson before a prediction is written"));
  unlock_action_->setCheckable(true);
  actions_ = {set_up_action_, before_action_, after_action_, hint_action_,  answer_action_,
              list_action_,   copy_action_,   csv_action_,   clear_action_, return_action_};
  connect(unlock_action_, &QAction::triggered, this, [this](bool on) {
    const bool covered = desk_.awaits_prediction();
    desk_.unlock(on);
    if (covered) {
      desk_.set_up_window();
    }
  });
  connect(list_action_, &QAction::triggered, this, [this] { pages_->setCurrentWidget(list_); });
  connect(copy_action_, &QAction::triggered, this,
          [this] { QGuiApplication::clipboard()->setText(rows_text(*tries_->model())); });
  connect(csv_action_, &QAction::triggered, this, &LessonView::copy_csv);
  connect(clear_action_, &QAction::triggered, &desk_, &LessonDesk::clear_tries);
  connect(set_up_action_, &QAction::triggered, &desk_, &LessonDesk::set_up_window);
  connect(return_action_, &QAction::triggered, this, &LessonView::return_wanted);
  connect(before_action_, &QAction::triggered, this, [this] { go(false); });
  connect(after_action_, &QAction::triggered, this, [this] { go(true); });
  for (QAction* action : {hint_action_, answer_action_}) {
    connect(action, &QAction::toggled, this, &LessonView::show_texts);
    connect(action, &QAction::toggled, this, [this](bool shown) {
      if (shown) {  // once its height is known
        QTimer::singleShot(0, this, &LessonView::show_expected);
      }
    });
  }
}

void LessonView::lay_out() {
  halves_->addWidget(make_upper());
  halves_->addWidget(make_lower());
  halves_->setStretchFactor(0, 1);
  halves_->setStretchFactor(1, 2);
  halves_->setChildrenCollapsible(false);
  sharing_.setSingleShot(true);
  sharing_.setInterval(0);
  connect(&sharing_, &QTimer::timeout, this, &LessonView::share_height);
  connect(halves_, &QSplitter::splitterMoved, this, [this] { shared_by_user_ = true; });
  pages_->addWidget(list_);
  pages_->addWidget(halves_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 6, 6, 6);
  layout->addWidget(pages_, 1);
}

/// Gives the text the height that the question with its tried values leaves, at least a third and no more
/// than it needs, until the user moves the border. Hints and answers do not move it.
void LessonView::share_height() {
  if (shared_by_user_ || presenting_ || !isVisible() || shows_list()) {
    return;
  }
  const QWidget& upper = *halves_->widget(0);
  const QWidget& lower = *halves_->widget(1);
  const int wanted_below = height_for_lower();
  const int wanted_above = upper.height() - text_->viewport()->height() +
                           static_cast<int>(std::ceil(text_->document()->size().height()));
  const int all = upper.height() + lower.height();
  const int least = all / 3;
  const int above = std::clamp(all - wanted_below, least, std::max(least, wanted_above));
  halves_->setSizes({above, all - above});
}

int LessonView::height_for_lower() const {
  const int all = halves_->widget(1)->height();
  if (desk_.awaits_prediction()) {
    return lower_->currentWidget()->sizeHint().height();
  }
  if (at_transfer_) {
    return all - transfer_page_->height() + transfer_page_->sizeHint().height();
  }
  const QLayout& question = *work_->widget()->layout();
  const int width = work_->viewport()->width();
  // Room for the first value, which then leaves the buttons in place.
  const int values = tried_->isHidden()
                         ? tried_->sizeHint().height() + tries_->minimumHeight() + 3 * fontMetrics().height()
                         : 0;
  return all - work_->viewport()->height() + values +
         (question.hasHeightForWidth() ? question.totalHeightForWidth(width)
                                       : question.totalSizeHint().height());
}

QWidget* LessonView::make_upper() {
  auto* upper = new QWidget(this);
  auto* buttons = new FlowLayout;
  buttons->setSpacing(4);
  for (QPushButton* button : {set_up_, return_, make_button(list_action_, this), next_}) {
    buttons->addWidget(button);
  }
  auto* layout = new QVBoxLayout(upper);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  layout->addWidget(text_, 1);
  layout->addLayout(buttons);
  return upper;
}

QWidget* LessonView::make_lower() {
  auto* values = new FlowLayout(values_);
  values->setContentsMargins(0, 0, 0, 0);
  values->setSpacing(2);
  auto* control = new QVBoxLayout(control_);
  control->setContentsMargins(0, 0, 0, 0);
  control->setSpacing(2);
  control->addWidget(key_);
  control->addWidget(values_);
  control->addWidget(show_setting_, 0, Qt::AlignLeft);

  auto* steps = new QHBoxLayout;
  steps->addWidget(number_, 1);
  steps->addWidget(before_);
  steps->addWidget(after_);
  auto* copies = new FlowLayout;
  copies->setSpacing(4);
  for (const auto& [action, text] : {std::pair(copy_action_, tr("Copy")), std::pair(csv_action_, tr("CSV")),
                                     std::pair(clear_action_, tr("Clear"))}) {
    QPushButton* button = make_button(action, tried_);
    button->setText(text);
    button->setAccessibleName(action->text());
    copies->addWidget(button);
  }
  auto* tried = new QVBoxLayout(tried_);
  tried->setContentsMargins(0, 0, 0, 0);
  tried->setSpacing(2);
  tried->addWidget(tries_);
  tried->addLayout(copies);
  auto* help = new FlowLayout;
  help->setSpacing(4);
  help->addWidget(hint_);
  help->addWidget(answer_);

  auto* content = new QWidget(this);
  auto* layout = new QVBoxLayout(content);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(question_);
  layout->addWidget(control_);
  layout->addWidget(value_);
  layout->addWidget(tried_);
  layout->addWidget(own_answer_);
  layout->addLayout(help);
  layout->addWidget(expected_);
  layout->addStretch(1);
  work_->setFrameShape(QFrame::NoFrame);
  work_->setWidgetResizable(true);
  work_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  work_->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);  // the buttons wrap the same with more values
  work_->setFocusPolicy(Qt::NoFocus);
  work_->setWidget(content);
  auto* lower = new QWidget(this);
  auto* whole = new QVBoxLayout(lower);
  whole->setContentsMargins(0, 0, 0, 0);
  whole->addLayout(steps);  // always at the same place
  whole->addWidget(work_, 1);
  transfer_page_ = make_transfer();
  whole->addWidget(transfer_page_, 1);
  lower_->addWidget(make_prediction());
  lower_->addWidget(lower);
  return lower_;
}

QWidget* LessonView::make_prediction() {
  auto* page = new QWidget(this);
  auto* layout = new QVBoxLayout(page);
  layout->setContentsMargins(0, 0, 0, 0);
  own_prediction_->setAccessibleName(tr("Your prediction"));
  own_prediction_->setPlaceholderText(tr("Your prediction"));
  own_prediction_->setToolTip(tr("What you expect, kept with the session; it cannot be changed afterwards"));
  own_prediction_->setTabChangesFocus(true);
  predict_->setToolTip(tr("Write the prediction down and set up the window with the lesson"));
  predict_->setEnabled(false);
  layout->addWidget(predict_text_);
  layout->addWidget(own_prediction_);
  layout->addWidget(predict_, 0, Qt::AlignLeft);
  layout->addStretch(1);
  return page;
}

QWidget* LessonView::make_transfer() {
  auto* page = new QWidget(this);
  auto* layout = new QVBoxLayout(page);
  layout->setContentsMargins(0, 0, 0, 0);
  transfer_->setAccessibleName(tr("On my control"));
  transfer_->setToolTip(tr("Complete the sentence; kept with the session and printed on the hand-out"));
  transfer_->setTabChangesFocus(true);
  layout->addWidget(transfer_);
  layout->addStretch(1);
  return page;
}

bool LessonView::shows_list() const {
  return pages_->currentWidget() == list_;
}

void LessonView::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  desk_.list();
}

void LessonView::resizeEvent(QResizeEvent* event) {
  Panel::resizeEvent(event);
  sharing_.start();
}

void LessonView::offer_return(bool there) {
  return_action_->setEnabled(there);
  return_->setVisible(there);
}

void LessonView::show_list() {
  QString contents;
  QStringList half_day;
  for (std::size_t i = 0; i < desk_.entries().size(); ++i) {
    const LessonEntry& entry = desk_.entries()[i];
    if (entry.half_day) {
      half_day.append(QString::number(i + 1));
    }
    const QString title =
        tr("%1. %2 (%3 min)").arg(i + 1).arg(entry.title, QLocale().toString(entry.minutes));
    contents += QStringLiteral("[**%1**](%2)\n\n%3\n\n").arg(title).arg(i).arg(entry.learn);
  }
  const QString courses = tr("A course of half a day: %1. Of two days: all.").arg(half_day.join(", "));
  list_->setHtml(contents.isEmpty() ? QString() : as_html(courses + "\n\n" + contents));
  show_lesson();
}

void LessonView::show_lesson() {
  const bool open = desk_.lesson() != nullptr;
  list_action_->setEnabled(open);
  pages_->setCurrentIndex(open ? 1 : 0);
  if (own_prediction_->toPlainText() != desk_.draft()) {
    own_prediction_->setPlainText(desk_.draft());
  }
  at_transfer_ = false;
  reading_ = true;
  show_cover();
}

/// Ends the lesson's text with the prediction once it is written.
void LessonView::show_text() {
  const Lesson* lesson = desk_.lesson();
  if (lesson == nullptr) {
    return;
  }
  const QString task =
      lesson->predict.empty()
          ? QString()
          : QStringLiteral("**%1**\n\n%2").arg(tr("Before you look"), desk_.filled(lesson->predict));
  const bool covered = desk_.awaits_prediction();
  predict_text_->setHtml(as_html(task));
  const QString shown =
      as_html(QStringLiteral("### %1\n\n*%2*\n\n%3\n\n%4")
                  .arg(QString::fromStdString(lesson->title), QString::fromStdString(lesson->learn),
                       desk_.filled(lesson->text), covered ? QString() : task));
  const QString predicted = desk_.prediction().toHtmlEscaped().replace('\n', QStringLiteral("<br>"));
  const QString written =
      predicted.isEmpty()
          ? QString()
          : QStringLiteral("<p><b>%1</b> <i>%2</i></p>").arg(tr("Your prediction:"), predicted);
  text_->setHtml(shown + written);
}

void LessonView::show_cover() {
  const bool covered = desk_.awaits_prediction();
  set_up_action_->setEnabled(desk_.lesson() != nullptr && !covered);
  lower_->setCurrentIndex(covered ? 0 : 1);
  unlock_action_->setChecked(desk_.unlocked());
  show_text();
  show_question();
}

void LessonView::set_presenting(bool on) {
  presenting_ = on;
  show_question();
}

void LessonView::read_text(bool on) {
  reading_ = on;
  show_question();
}

void LessonView::fold() {
  halves_->widget(0)->setVisible(!presenting_ || reading_);
  halves_->widget(1)->setVisible(!shows_text_alone());
  next_->setVisible(presenting_);
}

void LessonView::step(bool forward) {
  const Lesson* lesson = desk_.lesson();
  if (lesson == nullptr) {
    return;
  }
  const bool covered = desk_.awaits_prediction();
  const bool in_text = presenting_ ? shows_text_alone() : covered;
  QScrollBar& bar = *(in_text ? text_->verticalScrollBar() : work_->verticalScrollBar());
  if (forward && (in_text || answer_action_->isChecked()) && bar.value() < bar.maximum()) {
    bar.triggerAction(QAbstractSlider::SliderPageStepAdd);  // a class reads it to its end first
  } else if (shows_text_alone()) {
    read_text(!forward);
  } else if (covered) {
    forward ? desk_.reveal() : read_text(true);
  } else if (!at_transfer_ && answer_action_->isChecked() != forward) {
    answer_action_->setChecked(forward);
  } else if ((forward ? after_action_ : before_action_)->isEnabled()) {
    go(forward);
    answer_action_->setChecked(!forward && !shows_text_alone());
  }
}

void LessonView::go(bool forward) {
  const Lesson* lesson = desk_.lesson();
  const bool last = lesson != nullptr && desk_.question() + 1 == lesson->questions.size();
  if (!forward && !at_transfer_ && desk_.question() == 0) {
    read_text(true);
  } else if (forward ? last : at_transfer_) {
    at_transfer_ = forward;
    show_question();
  } else {
    desk_.choose_question(forward ? desk_.question() + 1 : desk_.question() - 1);
  }
}

void LessonView::show_question() {
  const Lesson* lesson = desk_.lesson();
  const std::size_t count = lesson == nullptr || desk_.awaits_prediction() ? 0 : lesson->questions.size();
  const bool asks = count > 0 && !at_transfer_;
  reading_ = reading_ && !at_transfer_ && desk_.question() == 0;
  fold();
  before_action_->setEnabled(count > 0 && (at_transfer_ || desk_.question() > 0 || presenting_));
  after_action_->setEnabled(asks && (desk_.question() + 1 < count || !lesson->transfer.empty()));
  hint_action_->setEnabled(asks && !lesson->questions[desk_.question()].hint.empty());
  answer_action_->setEnabled(asks);
  hint_action_->setChecked(false);
  answer_action_->setChecked(false);
  number_->setText(count == 0 ? QString()
                              : QStringLiteral("<b>%1</b>")
                                    .arg(at_transfer_
                                             ? tr("On my control")
                                             : tr("Question %1 of %2").arg(desk_.question() + 1).arg(count)));
  work_->setVisible(!at_transfer_);
  transfer_page_->setVisible(at_transfer_);
  show_texts();
  show_control();
  show_value();
  show_work();
  sharing_.start();
}

void LessonView::show_texts() {
  const Lesson* lesson = desk_.lesson();
  if (lesson == nullptr) {
    question_->clear();
    expected_->hide();
    return;
  }
  const Question& question = lesson->questions[desk_.question()];
  question_->setHtml(as_html(desk_.filled(question.text)));
  QStringList below;  // in view of the buttons, which stay where they are
  const auto add = [&](const QAction& action, const QString& title, const std::string& text) {
    if (action.isChecked()) {
      below.append(QStringLiteral("**%1** %2").arg(title, desk_.filled(text)));
    }
  };
  add(*hint_action_, tr("Hint:"), question.hint);
  add(*answer_action_, tr("Answer:"), question.answer);
  expected_->setVisible(!below.isEmpty());
  expected_->setHtml(below.isEmpty() ? QString() : as_html(below.join(QStringLiteral("\n\n"))));
}

void LessonView::show_expected() {
  settle_heights();
  const QRect shown = expected_->geometry();
  const int room = work_->viewport()->height();
  if (shown.height() > room) {
    work_->verticalScrollBar()->setValue(shown.top());
  } else {
    work_->ensureVisible(0, shown.bottom(), 0, std::min(shown.height(), room / 2));
  }
}

void LessonView::show_control() {
  qDeleteAll(values());
  const Lesson* lesson = desk_.lesson();
  control_->setVisible(lesson != nullptr);
  if (lesson == nullptr) {
    return;
  }
  const Control& control = lesson->questions[desk_.question()].control;
  const QString key = setting_title(control.key);
  const QString with_unit = setting_title_with_unit(control.key);
  key_->setToolTip(QString::fromStdString(control.key));
  key_->setText(control.range ? tr("Vary <b>%1</b> between").arg(with_unit)
                              : tr("Set <b>%1</b> to").arg(with_unit));
  show_setting_->setVisible(is_setting(control.key));
  for (const std::string& value : control.values) {
    auto* button = new QToolButton(values_);
    button->setText(control_value_text(value));
    button->setMinimumWidth(3 * button->sizeHint().height());
    button->setToolTip(tr("Set %1 to this value in the current run").arg(key));
    connect(button, &QToolButton::clicked, this, [this, value] { desk_.move_control(value); });
    values_->layout()->addWidget(button);
  }
  own_->setVisible(takes_numbers(control));
  values_->layout()->removeWidget(own_);
  values_->layout()->addWidget(own_);  // after the buttons
  if (takes_numbers(control)) {
    const QString unit = setting_unit(control.key);
    own_value_->setSuffix(unit.isEmpty() ? QString() : QChar(QChar::Nbsp) + unit);
    own_value_->setValue(*typed_number(control.values.front()).value);
  }
}

void LessonView::try_own_value() {
  own_value_->interpretText();  // a button without focus does not end typing
  desk_.move_control(
      QLocale::c().toString(own_value_->value(), 'g', QLocale::FloatingPointShortest).toStdString());
}

void LessonView::show_work() {
  const Lesson* lesson = desk_.lesson();
  const bool open = lesson != nullptr;
  own_answer_->setVisible(open);
  const QuestionWork work = desk_.work();
  for (QAction* action : {copy_action_, csv_action_, clear_action_}) {
    action->setEnabled(!work.tries.empty());
  }
  if (open) {
    tries_->show_work(lesson->questions[desk_.question()], desk_.watched(), work);
  }
  tried_->setVisible(!work.tries.empty());
  if (own_answer_->toPlainText() != work.answer) {
    const QSignalBlocker quiet(own_answer_);
    own_answer_->setPlainText(work.answer);
  }
  if (transfer_->toPlainText() != desk_.transfer()) {
    const QSignalBlocker quiet(transfer_);
    transfer_->setPlainText(desk_.transfer());
  }
  if (tried_->isVisible()) {
    settle_heights();  // before a long drawing shows the first row beneath the buttons
  }
}

void LessonView::copy_csv() const {
  QGuiApplication::clipboard()->setText(QString::fromStdString(tries_csv(desk_.work())));
}

QList<QToolButton*> LessonView::values() const {
  return values_->findChildren<QToolButton*>(Qt::FindDirectChildrenOnly);
}

QString LessonView::measured() const {
  return measured_;
}

void LessonView::show_value() {
  const Lesson* lesson = desk_.lesson();
  value_->setVisible(lesson != nullptr);
  if (lesson != nullptr) {
    measured_ = tr("In the current run: %1 <b>%2</b>")
                    .arg(desk_.watched(), desk_.value().isEmpty() ? QStringLiteral("–") : desk_.value());
    value_->setText(with_whole_units(measured_));
  }
}

}  // namespace feedscope::ui
