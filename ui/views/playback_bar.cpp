#include "ui/views/playback_bar.h"

#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QSignalBlocker>
#include <QSlider>
#include <QStyle>
#include <QToolButton>
#include <cmath>

namespace feedscope::ui {

namespace {

constexpr int slider_steps = 10000;

/// "12.345 s", from a minute on "3:05.2".
QString clock_text(double seconds) {
  if (seconds < 60) {
    return PlaybackBar::tr("%1 s").arg(QLocale().toString(seconds, 'f', 3));
  }
  const int minutes = static_cast<int>(seconds / 60);
  const double rest = std::floor((seconds - 60 * minutes) * 10) / 10;
  const QString padding = rest < 10 ? QStringLiteral("0") : QString();
  return QStringLiteral("%1:%2%3").arg(minutes).arg(padding, QLocale().toString(rest, 'f', 1));
}

}  // namespace

PlaybackBar::PlaybackBar(Cursor& cursor, Playback& playback, QWidget* parent)
    : QWidget(parent),
      cursor_(cursor),
      playback_(playback),
      play_(new QToolButton(this)),
      slider_(new QSlider(Qt::Horizontal, this)),
      time_(new QLabel(this)),
      speed_(new QDoubleSpinBox(this)) {
  play_->setIcon(style()->standardIcon(QStyle::SP_MediaPlay));
  play_->setToolTip(tr("Play or pause (Space)"));
  play_->setAccessibleName(tr("Play or pause"));
  slider_->setRange(0, slider_steps);
  slider_->setToolTip(tr("Time within the cycle"));
  slider_->setAccessibleName(tr("Time within the cycle"));
  time_->setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("0000:00.0 / 0000:00.0")));
  time_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  speed_->setRange(Playback::slowest, Playback::fastest);
  speed_->setDecimals(1);
  speed_->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  speed_->setPrefix(QStringLiteral("× "));
  speed_->setValue(playback_.speed());
  speed_->setToolTip(tr("Playback speed; 1 is true time"));

  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(6, 2, 6, 2);
  layout->addWidget(play_);
  layout->addWidget(slider_, 1);
  layout->addWidget(time_);
  layout->addWidget(speed_);

  connect(play_, &QToolButton::clicked, this, &PlaybackBar::toggle);
  connect(speed_, &QDoubleSpinBox::valueChanged, &playback_, &Playback::set_speed);
  connect(slider_, &QSlider::valueChanged, this,
          [this](int value) { cursor_.set_time(duration_ * value / slider_steps); });
  connect(&cursor_, &Cursor::changed, this, &PlaybackBar::show_cursor);
  connect(&playback_, &Playback::playing_changed, this, [this](bool playing) {
    play_->setIcon(style()->standardIcon(playing ? QStyle::SP_MediaPause : QStyle::SP_MediaPlay));
  });
  set_duration(0);
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
