#include "ui/lessons/lesson_view.h"

#include <QAbstractTextDocumentLayout>
#include <QAction>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QScrollArea>
#include <QSplitter>
#include <QTextBrowser>
#include <QToolButton>
#include <QUrl>
#include <QVBoxLayout>
#include <cmath>

#include "core/base/markdown.h"
#include "core/base/typed_number.h"
#include "core/lessons/handout.h"
#include "ui/fields/focus_outline.h"
#include "ui/language/core_texts.h"
#include "ui/language/texts.h"
#include "ui/shared/flow_layout.h"
#include "ui/shared/panel_action.h"

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

/// As high as its text, without a scroll bar of its own.
void fit_to_text(QTextBrowser& browser) {
  browser.setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  const auto fit = [&browser](const QSizeF& text) {
    browser.setFixedHeight(static_cast<int>(std::ceil(text.height())) + 2 * browser.frameWidth());
  };
  QObject::connect(browser.document()->documentLayout(), &QAbstractTextDocumentLayout::documentSizeChanged,
                   &browser, fit);
  fit(browser.document()->size());
}

/// A button that can be pressed and shows that it is.
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

/// Markdown; unlike that of QTextDocument with room between paragraphs.
QString as_html(const QString& markdown) {
  return QString::fromStdString(markdown_as_html(markdown.toStdString()));
}

bool is_setting(const std::string& key) {
  return key != "program" && key != "machine" && key != "model";
}

/// A number with the decimal sign of the window, a choice in its language.
QString value_text(const std::string& value) {
  const auto number = typed_number(value).value;
  return number ? QLocale().toString(*number, 'g', QLocale::FloatingPointShortest) : core_text(value);
}

}  // namespace

LessonView::LessonView(LessonDesk& desk, QWidget* parent)
    : Panel({QStringLiteral("lesson"), tr("Lesson"), Qt::RightDockWidgetArea, false}, parent),
      desk_(desk),
      lessons_(new QComboBox(this)),
      text_(make_browser(tr("Text of the lesson"), this)),
      number_(new QLabel(this)),
      question_(make_browser(tr("Question"), this)),
      control_(new QWidget(this)),
      key_(new QLabel(control_)),
      values_(new QWidget(control_)),
      show_setting_(new QToolButton(control_)),
      value_(new QLabel(this)) {
  make_actions();
  set_up_ = make_button(set_up_action_, this);
  return_ = make_button(return_action_, this);
  before_ = make_arrow(before_action_, Qt::LeftArrow, this);
  after_ = make_arrow(after_action_, Qt::RightArrow, this);
  hint_ = make_button(hint_action_, this);
  answer_ = make_button(answer_action_, this);
  lessons_->setAccessibleName(tr("Lesson"));
  lessons_->setToolTip(tr("Choose a lesson"));
  lessons_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  value_->setTextFormat(Qt::RichText);
  value_->setWordWrap(true);
  key_->setWordWrap(true);
  fit_to_text(*question_);
  show_setting_->setText(tr("Show setting"));
  show_setting_->setToolTip(tr("Show the setting in the tables of axis limits and control settings"));
  lay_out();
  offer_return(false);

  connect(lessons_, &QComboBox::activated, this, [this](int row) {
    if (row > 0) {
      desk_.open(desk_.entries()[static_cast<std::size_t>(row - 1)].file);
    }
  });
  connect(text_, &QTextBrowser::anchorClicked, this,
          [this](const QUrl& link) { desk_.open(desk_.entries()[link.path().toULongLong()].file); });
  connect(show_setting_, &QToolButton::clicked, this, [this] {
    emit setting_wanted(QString::fromStdString(desk_.lesson()->questions[desk_.question()].control.key));
  });
  connect(&desk_, &LessonDesk::listed, this, &LessonView::show_list);
  connect(&desk_, &LessonDesk::opened, this, &LessonView::show_lesson);
  connect(&desk_, &LessonDesk::question_changed, this, &LessonView::show_question);
  connect(&desk_, &LessonDesk::value_changed, this, &LessonView::show_value);
  show_list();
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
  actions_ = {set_up_action_, before_action_, after_action_, hint_action_, answer_action_, return_action_};
  connect(set_up_action_, &QAction::triggered, &desk_, &LessonDesk::set_up_window);
  connect(return_action_, &QAction::triggered, this, &LessonView::return_wanted);
  connect(before_action_, &QAction::triggered, this, [this] { desk_.choose_question(desk_.question() - 1); });
  connect(after_action_, &QAction::triggered, this, [this] { desk_.choose_question(desk_.question() + 1); });
  connect(hint_action_, &QAction::toggled, this, &LessonView::show_texts);
  connect(answer_action_, &QAction::toggled, this, &LessonView::show_texts);
}

void LessonView::lay_out() {
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
  auto* help = new FlowLayout;
  help->setSpacing(4);
  help->addWidget(hint_);
  help->addWidget(answer_);

  auto* upper = new QWidget(this);
  auto* above = new QVBoxLayout(upper);
  above->setContentsMargins(0, 0, 0, 0);
  above->addWidget(text_, 1);
  above->addWidget(set_up_);
  above->addWidget(return_);
  auto* content = new QWidget(this);
  auto* below = new QVBoxLayout(content);
  below->setContentsMargins(0, 0, 0, 0);
  below->addLayout(steps);
  below->addWidget(question_);
  below->addWidget(control_);
  below->addWidget(value_);
  below->addLayout(help);
  below->addStretch(1);
  auto* lower = new QScrollArea(this);
  lower->setFrameShape(QFrame::NoFrame);
  lower->setWidgetResizable(true);
  lower->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  lower->setFocusPolicy(Qt::NoFocus);
  lower->setWidget(content);
  auto* halves = new QSplitter(Qt::Vertical, this);
  halves->addWidget(upper);
  halves->addWidget(lower);
  halves->setStretchFactor(0, 1);
  halves->setStretchFactor(1, 1);
  halves->setChildrenCollapsible(false);

  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 6, 6, 6);
  layout->setSpacing(4);
  layout->addWidget(lessons_);
  layout->addWidget(halves, 1);
}

void LessonView::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  desk_.list();
}

void LessonView::offer_return(bool there) {
  return_action_->setEnabled(there);
  return_->setVisible(there);
}

void LessonView::show_list() {
  lessons_->clear();
  lessons_->addItem(desk_.entries().empty() ? tr("Loading lessons …") : tr("Choose a lesson"));
  for (const LessonEntry& entry : desk_.entries()) {
    lessons_->addItem(
        tr("%1. %2 (%3 min)").arg(lessons_->count()).arg(entry.title, QLocale().toString(entry.minutes)));
    lessons_->setItemData(lessons_->count() - 1, entry.learn, Qt::ToolTipRole);
  }
  show_lesson();
}

void LessonView::show_contents() {
  QString contents;
  for (std::size_t i = 0; i < desk_.entries().size(); ++i) {
    contents += QStringLiteral("[**%1**](%2)\n\n%3\n\n")
                    .arg(lessons_->itemText(static_cast<int>(i) + 1))
                    .arg(i)
                    .arg(desk_.entries()[i].learn);
  }
  text_->setHtml(as_html(contents));
}

void LessonView::show_lesson() {
  const Lesson* lesson = desk_.lesson();
  set_up_action_->setEnabled(lesson != nullptr);
  if (lesson != nullptr) {
    for (std::size_t i = 0; i < desk_.entries().size(); ++i) {
      if (desk_.entries()[i].file == lesson->file) {
        lessons_->setCurrentIndex(static_cast<int>(i) + 1);
      }
    }
    text_->setHtml(as_html(QStringLiteral("### %1\n\n*%2*\n\n%3")
                               .arg(QString::fromStdString(lesson->title),
                                    QString::fromStdString(lesson->learn), desk_.filled(lesson->text))));
  } else {
    show_contents();
  }
  show_question();
}

void LessonView::show_question() {
  const Lesson* lesson = desk_.lesson();
  const std::size_t count = lesson == nullptr ? 0 : lesson->questions.size();
  before_action_->setEnabled(desk_.question() > 0);
  after_action_->setEnabled(desk_.question() + 1 < count);
  hint_action_->setEnabled(count > 0 && !lesson->questions[desk_.question()].hint.empty());
  answer_action_->setEnabled(count > 0);
  hint_action_->setChecked(false);
  answer_action_->setChecked(false);
  number_->setText(
      count == 0
          ? QString()
          : QStringLiteral("<b>%1</b>").arg(tr("Question %1 of %2").arg(desk_.question() + 1).arg(count)));
  show_texts();
  show_control();
  show_value();
}

void LessonView::show_texts() {
  const Lesson* lesson = desk_.lesson();
  if (lesson == nullptr) {
    question_->clear();
    return;
  }
  const Question& question = lesson->questions[desk_.question()];
  QString text = desk_.filled(question.text);
  if (hint_action_->isChecked()) {
    text += QStringLiteral("\n\n**%1** %2").arg(tr("Hint:"), desk_.filled(question.hint));
  }
  if (answer_action_->isChecked()) {
    text += QStringLiteral("\n\n**%1** %2").arg(tr("Answer:"), desk_.filled(question.answer));
  }
  question_->setHtml(as_html(text));
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
  key_->setToolTip(QString::fromStdString(control.key));
  key_->setText(control.range ? tr("Vary <b>%1</b> between").arg(key) : tr("Set <b>%1</b> to").arg(key));
  show_setting_->setVisible(is_setting(control.key));
  for (const std::string& value : control.values) {
    auto* button = new QToolButton(values_);
    button->setText(value_text(value));
    button->setMinimumWidth(3 * button->sizeHint().height());
    button->setToolTip(tr("Set %1 to this value in the current run").arg(key));
    connect(button, &QToolButton::clicked, this, [this, value] { desk_.move_control(value); });
    values_->layout()->addWidget(button);
  }
}

QList<QToolButton*> LessonView::values() const {
  return values_->findChildren<QToolButton*>(Qt::FindDirectChildrenOnly);
}

QString LessonView::measured() const {
  return value_->text();
}

void LessonView::show_value() {
  const Lesson* lesson = desk_.lesson();
  value_->setVisible(lesson != nullptr);
  if (lesson != nullptr) {
    value_->setText(tr("In the current run: %1 <b>%2</b>")
                        .arg(desk_.watched(), desk_.value().isEmpty() ? QStringLiteral("–") : desk_.value()));
  }
}

}  // namespace feedscope::ui
