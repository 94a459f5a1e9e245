#pragma once

#include <QWidget>

#include "ui/models/playback.h"

class QDoubleSpinBox;
class QLabel;
class QSlider;
class QToolButton;

namespace feedscope::ui {

/// Plays a run: play or pause, a slider over the cycle time, time, speed.
class PlaybackBar : public QWidget {
  Q_OBJECT

 public:
  /// Both outlive this.
  PlaybackBar(Cursor& cursor, Playback& playback, QWidget* parent = nullptr);

  /// Cycle time of the run that is shown [s]; 0: none.
  void set_duration(double duration);
  void toggle();
  QToolButton* play_button() { return play_; }

 private:
  void show_cursor();

  Cursor& cursor_;
  Playback& playback_;
  QToolButton* play_;
  QSlider* slider_;
  QLabel* time_;
  QDoubleSpinBox* speed_;
  double duration_ = 0;
};

}  // namespace feedscope::ui
