#pragma once

#include <QList>
#include <QWidget>

#include "ui/workbench/workbench.h"

class QAction;
class QLabel;
class QSlider;
class QToolButton;

namespace feedscope::ui {

class NumberBox;

/// Plays a run: play or pause, steps by block and sample, a slider over the cycle time, time, speed.
class PlaybackBar : public QWidget {
  Q_OBJECT

 public:
  /// `workbench` outlives this.
  explicit PlaybackBar(Workbench& workbench, QWidget* parent = nullptr);

  /// Cycle time of the run that is shown [s]; 0: none.
  void set_duration(double duration);
  void toggle();
  /// Time between two samples of the control, for stepping [s].
  void set_sample_time(double time) { sample_time_ = time; }
  /// Play, steps, speed, loop, start and end; for menus.
  QList<QAction*> panel_actions() const { return actions_; }
  QToolButton* play_button() { return play_; }
  /// Without what menus have too, which goes where there is no room for it.
  QSize minimumSizeHint() const override;

 protected:
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void make_actions();
  void draw_icons();
  void fit_in();
  int needed_by(const QWidget& part) const;
  void show_run();
  /// What the charts show is played over and over, or no longer.
  void loop(bool on);
  void step_sample(int direction);
  void change_speed(double factor);
  void show_cursor();

  Workbench& workbench_;
  Cursor& cursor_;
  Playback& playback_;
  QToolButton* play_;
  QSlider* slider_;
  QLabel* time_;
  NumberBox* speed_;
  QList<QWidget*> spare_;  ///< the first goes last
  QList<QAction*> actions_;
  double duration_ = 0;
  double sample_time_ = 0.001;
};

}  // namespace feedscope::ui
