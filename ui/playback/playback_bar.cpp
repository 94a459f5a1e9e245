#include "ui/playback/playback_bar.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>
#include <cmath>

#include "ui/fields/number_box.h"
#include "ui/language/texts.h"
#include "ui/shared/panel_action.h"
#include "ui/theme/icons.h"
#include "ui/theme/type_size.h"

namespace feedscope::ui {

namespace {

constexpr int slider_steps = 10000;
constexpr double speed_step = 2;
constexpr int least_slider = 24;  // [px]

}  // namespace

PlaybackBar::PlaybackBar(Workbench& workbench, QWidget* parent)
    : QWidget(parent),
      workbench_(workbench),
      cursor_(workbench.cursor()),
      playback_(workbench.playback()),
      play_(new QToolButton(this)),
      slider_(new QSlider(Qt::Horizontal, this)),
      time_(new QLabel(this)),
      speed_(new NumberBox(this)) {
  slider_->setRange(0, slider_steps);
  slider_->setMinimumWidth(type_pixels(least_slider));
  slider_->setToolTip(tr("Time within the cycle"));
  slider_->setAccessibleName(tr("Time within the cycle"));
  time_->setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("0000:00.0 / 0000:00.0")));
  time_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  speed_->setRange(Playback::slowest, Playback::fastest);
  speed_->setDecimals(2);
  speed_->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  speed_->setPrefix(QStringLiteral("× "));
  speed_->setValue(playback_.speed());
  speed_->setToolTip(tr("Playback speed; 1 is real time"));

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
      if (action->isCheckable()) {
        spare_.append(button);
      }
    }
  }
  layout->addWidget(slider_, 1);
  layout->addWidget(time_);
  layout->addWidget(speed_);
  spare_.append(speed_);

  connect(speed_, &NumberBox::valueChanged, &playback_, &Playback::set_speed);
  connect(slider_, &QSlider::valueChanged, this,
          [this](int value) { cursor_.set_time(duration_ * value / slider_steps); });
  connect(&cursor_, &Cursor::changed, this, &PlaybackBar::show_cursor);
  connect(&playback_, &Playback::playing_changed, this, [this](bool playing) {
    actions_.first()->setData(static_cast<int>(playing ? MediaIcon::pause : MediaIcon::play));
    draw_icons();
  });
  connect(&workbench_, &Workbench::drawn_changed, this, &PlaybackBar::show_run);
  show_run();
}

int PlaybackBar::needed_by(const QWidget& part) const {
  return part.minimumSizeHint().width() + layout()->spacing();
}

QSize PlaybackBar::minimumSizeHint() const {
  QSize least = layout()->minimumSize();
  for (const QWidget* part : spare_) {
    least.rwidth() -= part->isHidden() ? 0 : needed_by(*part);
  }
  return least;
}

void PlaybackBar::fit_in() {
  int room = width() - minimumSizeHint().width();
  for (QWidget* part : spare_) {
    const int needed = needed_by(*part);
    part->setVisible(room >= needed);
    room -= needed;
  }
}

void PlaybackBar::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  fit_in();
}

void PlaybackBar::make_actions() {
  const auto add = [this](const QString& text, const QString& tip, const QKeySequence& key, auto call) {
    actions_.append(make_action(this, text, tip, key, call));
    return actions_.last();
  };
  add(tr("&Play or pause"), tr("Play or pause"), Qt::Key_Space, [this] {
    toggle();
  })->setData(static_cast<int>(MediaIcon::play));
  add(tr("Pre&vious block"), tr("Go to the start of this or the previous block"),
      QKeySequence(tr("Ctrl+Left")), [this] { cursor_.step_block(-1); })
      ->setData(static_cast<int>(MediaIcon::back));
  add(tr("Ne&xt block"), tr("Go to the start of the next block"), QKeySequence(tr("Ctrl+Right")), [this] {
    cursor_.step_block(1);
  })->setData(static_cast<int>(MediaIcon::on));
  add(tr("P&revious sample"), tr("Go back one interpolation period"), QKeySequence(Qt::Key_Comma),
      [this] { step_sample(-1); });
  add(tr("&Next sample"), tr("Go forward one interpolation period"), QKeySequence(Qt::Key_Period),
      [this] { step_sample(1); });
  add(tr("&Faster"), tr("Play twice as fast"), QKeySequence(tr("Ctrl+Up")),
      [this] { change_speed(speed_step); });
  add(tr("&Slower"), tr("Play half as fast"), QKeySequence(tr("Ctrl+Down")),
      [this] { change_speed(1 / speed_step); });
  QAction* loop =
      add(tr("&Loop"), tr("Repeat the time range of the charts"), QKeySequence(tr("Ctrl+L")), [] {});
  loop->setCheckable(true);
  connect(loop, &QAction::toggled, this, &PlaybackBar::loop);
  add(tr("Go to s&tart"), tr("Go to the start of the run"), QKeySequence::MoveToStartOfDocument,
      [this] { cursor_.set_time(0); });
  add(tr("Go to &end"), tr("Go to the end of the run"), QKeySequence::MoveToEndOfDocument,
      [this] { cursor_.set_time(duration_); });
}

void PlaybackBar::show_run() {
  const auto shown = workbench_.drawn();
  set_duration(shown == nullptr ? 0 : shown->run.trajectory->duration());
  if (const auto period = workbench_.setup().interpolation_period()) {
    set_sample_time(*period);
  }
}

void PlaybackBar::loop(bool on) {
  const ViewRange& range = workbench_.view_range();
  playback_.set_loop(on ? std::optional(Playback::Loop{range.lower_time(), range.upper_time()})
                        : std::nullopt);
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
  fit_in();
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
