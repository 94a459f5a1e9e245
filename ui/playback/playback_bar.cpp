#include "ui/views/playback_bar.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>
#include <cmath>

#include "ui/fields/number_box.h"
#include "ui/models/panel_action.h"
#include "ui/models/texts.h"
#include "ui/theme/icons.h"

namespace feedscope::ui {

namespace {

constexpr int slider_steps = 10000;
constexpr double speed_step = 2;

}  // namespace

PlaybackBar::PlaybackBar(Cursor& cursor, Playback& playback, QWidget* parent)
    : QWidget(parent),
      cursor_(cursor),
      playback_(playback),
      play_(new QToolButton(this)),
      slider_(new QSlider(Qt::Horizontal, this)),
      time_(new QLabel(this)),
      speed_(new NumberBox(this)) {
  slider_->setRange(0, slider_steps);
  slider_->setToolTip(tr("Time within the cycle"));
  slider_->setAccessibleName(tr("Time within the cycle"));
  time_->setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("0000:00.0 / 0000:00.0")));
  time_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  speed_->setRange(Playback::slowest, Playback::fastest);
  speed_->setDecimals(2);
  speed_->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  speed_->setPrefix(QStringLiteral("× "));
  speed_->setValue(playback_.speed());
  speed_->setToolTip(tr("Playback speed; 1 is true time"));

  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(6, 2, 6, 2);
  make_actions();
  draw_icons();
  for (QAction* action : actions_) {
    if (action->data().isValid() || action->isCheckable()) {
      auto* button = action == actions_.first() ? play_ : new QToolButton(this);
      button->setDefaultAction(action);
      button->setAutoRaise(true);
      layout->addWidget(button);
    }
  }
  layout->addWidget(slider_, 1);
  layout->addWidget(time_);
  layout->addWidget(speed_);

  connect(speed_, &NumberBox::valueChanged, &playback_, &Playback::set_speed);
  connect(slider_, &QSlider::valueChanged, this,
          [this](int value) { cursor_.set_time(duration_ * value / slider_steps); });
  connect(&cursor_, &Cursor::changed, this, &PlaybackBar::show_cursor);
  connect(&playback_, &Playback::playing_changed, this, [this](bool playing) {
    actions_.first()->setData(static_cast<int>(playing ? MediaIcon::pause : MediaIcon::play));
    draw_icons();
  });
  set_duration(0);
}

void PlaybackBar::make_actions() {
  const auto add = [this](const QString& text, const QString& tip, const QKeySequence& key, auto call) {
    actions_.append(make_action(this, text, tip, key, call));
    return actions_.last();
  };
  add(tr("&Play or pause"), tr("Play or pause"), Qt::Key_Space, [this] {
    toggle();
  })->setData(static_cast<int>(MediaIcon::play));
  add(tr("Block b&ack"), tr("To the start of this or the previous block"), QKeySequence(tr("Ctrl+Left")),
      [this] { cursor_.step_block(-1); })
      ->setData(static_cast<int>(MediaIcon::back));
  add(tr("Block &on"), tr("To the start of the next block"), QKeySequence(tr("Ctrl+Right")), [this] {
    cursor_.step_block(1);
  })->setData(static_cast<int>(MediaIcon::on));
  add(tr("Sample &back"), tr("One interpolation period back"), QKeySequence(Qt::Key_Comma),
      [this] { step_sample(-1); });
  add(tr("Sample o&n"), tr("One interpolation period on"), QKeySequence(Qt::Key_Period),
      [this] { step_sample(1); });
  add(tr("&Faster"), tr("Play twice as fast"), QKeySequence(tr("Ctrl+Up")),
      [this] { change_speed(speed_step); });
  add(tr("&Slower"), tr("Play half as fast"), QKeySequence(tr("Ctrl+Down")),
      [this] { change_speed(1 / speed_step); });
  QAction* loop =
      add(tr("&Loop"), tr("Play what the charts show over and over"), QKeySequence(tr("Ctrl+L")), [] {});
  loop->setCheckable(true);
  connect(loop, &QAction::toggled, this, &PlaybackBar::loop_wanted);
}

void PlaybackBar::draw_icons() {
  for (QAction* action : actions_) {
    if (action->data().isValid()) {
      action->setIcon(media_icon(static_cast<MediaIcon>(action->data().toInt()), palette()));
    }
  }
}

void PlaybackBar::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) {
    draw_icons();
  }
  QWidget::changeEvent(event);
}

void PlaybackBar::step_sample(int direction) {
  cursor_.set_time(cursor_.state().time + direction * sample_time_);
}

void PlaybackBar::change_speed(double factor) {
  speed_->setValue(speed_->value() * factor);
}

void PlaybackBar::set_duration(double duration) {
  duration_ = duration;
  setEnabled(duration_ > 0);
  show_cursor();
}

void PlaybackBar::toggle() {
  if (playback_.playing()) {
    playback_.pause();
  } else {
    playback_.play();
  }
}

void PlaybackBar::show_cursor() {
  const QSignalBlocker blocker(slider_);
  const double time = cursor_.state().time;
  slider_->setValue(duration_ > 0 ? static_cast<int>(std::lround(time / duration_ * slider_steps)) : 0);
  time_->setText(duration_ > 0 ? tr("%1 / %2").arg(clock_text(time), clock_text(duration_)) : QString());
}

}  // namespace feedscope::ui
