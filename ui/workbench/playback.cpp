#include "ui/workbench/playback.h"

#include <algorithm>
#include <chrono>

namespace feedscope::ui {

Playback::Playback(Cursor& cursor, QObject* parent) : QObject(parent), cursor_(cursor) {
  timer_.setInterval(std::chrono::milliseconds(20));
  timer_.setTimerType(Qt::PreciseTimer);
  connect(&timer_, &QTimer::timeout, this,
          [this] { advance(static_cast<double>(clock_.nsecsElapsed()) * 1e-9); });
}

void Playback::set_speed(double speed) {
  speed_ = std::clamp(speed, slowest, fastest);
}

void Playback::set_duration(double duration) {
  duration_ = duration;
  if (duration_ <= 0) {
    pause();
  }
}

void Playback::set_loop(const std::optional<Loop>& loop) {
  loop_ = loop && loop->to > loop->from ? loop : std::nullopt;
}

void Playback::play() {
  if (playing() || duration_ <= 0) {
    return;
  }
  const double start = loop_ ? loop_->from : 0;
  const double end = loop_ ? std::min(loop_->to, duration_) : duration_;
  if (cursor_.state().time >= end || cursor_.state().time < start) {
    cursor_.set_time(start);
  }
  clock_.start();
  timer_.start();
  emit playing_changed(true);
}

void Playback::pause() {
  if (playing()) {
    timer_.stop();
    emit playing_changed(false);
  }
}

void Playback::advance(double elapsed) {
  clock_.start();
  const double time = cursor_.state().time + elapsed * speed_;
  if (loop_ && time >= std::min(loop_->to, duration_)) {
    cursor_.set_time(loop_->from);
    return;
  }
  cursor_.set_time(std::min(time, duration_));
  if (time >= duration_) {
    pause();
  }
}

}  // namespace feedscope::ui
