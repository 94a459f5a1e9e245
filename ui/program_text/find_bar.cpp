#include "ui/program_text/find_bar.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/program_text/program_view.h"
#include "ui/theme/theme.h"

namespace feedscope::ui {

namespace {

constexpr int typing_pause = 120;  // [ms]

}  // namespace

FindBar::FindBar(ProgramView& view, QWidget* parent)
    : InputBar(view, parent),
      view_(view),
      search_(this),
      input_(new QLineEdit(this)),
      match_case_(add_button(tr("Aa"), tr("Match upper and lower case"), true)),
      whole_word_(add_button(tr("W"), tr("Whole words only"), true)),
      regular_expression_(add_button(tr(".*"), tr("Regular expression"), true)),
      next_(add_button(QStringLiteral("↓"), tr("Next match (F3)"), false)),
      previous_(add_button(QStringLiteral("↑"), tr("Previous match (Shift+F3)"), false)),
      status_(new QLabel(this)) {
  QToolButton* close = add_button(QStringLiteral("×"), tr("Close (Esc)"), false);
  input_->setPlaceholderText(tr("Find in the program"));
  input_->setAccessibleName(tr("Find in the program"));
  input_->setClearButtonEnabled(true);
  take_keys_of(input_);
  status_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  status_->setAccessibleName(tr("Search result"));

  auto* first = new QHBoxLayout;
  first->addWidget(input_, 1);
  first->addWidget(close);
  auto* second = new QHBoxLayout;
  for (QToolButton* button : {match_case_, whole_word_, regular_expression_}) {
    second->addWidget(button);
    connect(button, &QToolButton::toggled, this, &FindBar::look_for_input);
  }
  second->addWidget(status_, 1);
  second->addWidget(previous_);
  second->addWidget(next_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(4, 4, 4, 4);
  layout->setSpacing(2);
  layout->addLayout(first);
  layout->addLayout(second);

  typing_.setSingleShot(true);
  typing_.setInterval(typing_pause);
  connect(&typing_, &QTimer::timeout, this, &FindBar::look_for_input);
  connect(input_, &QLineEdit::textChanged, &typing_, qOverload<>(&QTimer::start));
  connect(next_, &QToolButton::clicked, this, [this] { step(true); });
  connect(previous_, &QToolButton::clicked, this, [this] { step(false); });
  connect(close, &QToolButton::clicked, this, &FindBar::close_bar);
  connect(&search_, &TextSearch::changed, this, &FindBar::show_result);
  connect(&view_, &ProgramView::caret_moved, this, &FindBar::say_status);
  say_status();
}

QToolButton* FindBar::add_button(const QString& text, const QString& tip, bool checkable) {
  auto* button = new QToolButton(this);
  button->setText(text);
  button->setToolTip(tip);
  button->setAccessibleName(tip);
  button->setCheckable(checkable);
  button->setAutoRaise(true);
  return button;
}

void FindBar::open() {
  const TextRange selected = view_.selection();
  start_ = selected.begin;
  if (!selected.empty() && selected.begin.line == selected.end.line) {
    input_->setText(view_.selected_text());
  }
  show();
  input_->setFocus(Qt::ShortcutFocusReason);
  input_->selectAll();
  look_for_input();
}

void FindBar::close_bar() {
  typing_.stop();
  search_.set_query({});
  InputBar::close_bar();
}

void FindBar::look_for_input() {
  typing_.stop();
  const SearchQuery query{input_->text(), match_case_->isChecked(), whole_word_->isChecked(),
                          regular_expression_->isChecked()};
  if (query == search_.query()) {
    return;
  }
  reveal_ = true;
  step_later_.reset();
  search_.set_query(query);
}

void FindBar::step(bool forward) {
  if (!isVisible()) {
    show();
  }
  look_for_input();
  if (search_.busy()) {
    reveal_ = false;
    step_later_ = forward;
    return;
  }
  const TextRange selected = view_.selection();
  const auto hit = forward ? search_.at_or_after(selected.empty() ? selected.begin : selected.end)
                           : search_.before(selected.begin);
  if (hit) {
    view_.select(*hit);
    start_ = hit->begin;
  }
  say_status();
}

void FindBar::show_result() {
  if (!search_.busy() && step_later_) {
    const bool forward = *step_later_;
    step_later_.reset();
    step(forward);
  } else if (!search_.busy() && reveal_) {
    reveal_ = false;
    if (const auto hit = search_.at_or_after(start_)) {
      view_.reveal(*hit);
    }
  }
  say_status();
}

void FindBar::say_status() {
  QString text;
  const bool wrong = !search_.error().isEmpty();
  if (wrong) {
    text = search_.error();
  } else if (search_.busy()) {
    text = tr("searching …");
  } else if (search_.found() != nullptr) {
    const QLocale locale;
    const std::uint64_t number = search_.number_of(view_.selection());
    const QString count = locale.toString(static_cast<qulonglong>(search_.found()->count()));
    text = search_.found()->count() == 0 ? tr("not found")
           : number == 0                 ? tr("%1 found").arg(count)
                         : tr("%1 of %2").arg(locale.toString(static_cast<qulonglong>(number)), count);
  }
  QPalette colours = palette();
  if (wrong || (search_.found() != nullptr && search_.found()->count() == 0)) {
    colours.setColor(QPalette::WindowText, theme_colours(palette()).error);
  }
  status_->setPalette(colours);
  status_->setText(text);
  status_->setToolTip(text);
  const bool any = search_.found() != nullptr && search_.found()->count() > 0;
  next_->setEnabled(any || search_.busy());
  previous_->setEnabled(any || search_.busy());
}

QString FindBar::status() const {
  return status_->text();
}

bool FindBar::event(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) {
    say_status();
  }
  return QWidget::event(event);
}

void FindBar::enter(Qt::KeyboardModifiers modifiers) {
  step(!modifiers.testFlag(Qt::ShiftModifier));
}

}  // namespace feedscope::ui
