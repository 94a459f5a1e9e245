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

  /// Cycle time of the shown run [s]; 0: none.
  void set_duration(double duration);
  void toggle();
  /// Time between two samples of the control, for stepping [s].
  void set_sample_time(double time) { sample_time_ = time; }
  /// Play, steps, speed, loop, start and end; for menus.
  QList<QAction*> panel_actions() const { return actions_; }
  QToolButton* play_button() { return play_; }
  /// Without buttons that are also in menus; these are hidden if there is no room.
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
  /// Repeats the range of the charts, or stops that.
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
  QList<QWidget*> spare_;  ///< the first is hidden last
  QList<QAction*> actions_;
  double duration_ = 0;
  double sample_time_ = 0.001;
};

}  // namespace feedscope::ui
