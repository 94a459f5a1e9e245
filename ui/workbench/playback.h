#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <optional>

#include "ui/shared/cursor.h"

namespace feedscope::ui {

/// Moves the cursor through the cycle time in real time.
class Playback : public QObject {
  Q_OBJECT

 public:
  /// A range of the run [s].
  struct Loop {
    double from, to;
  };

  static constexpr double slowest = 0.01;
  static constexpr double fastest = 10'000;

  /// `cursor` outlives this.
  explicit Playback(Cursor& cursor, QObject* parent = nullptr);

  bool playing() const { return timer_.isActive(); }
  double speed() const { return speed_; }  ///< 1: real time
  /// Clamped to [slowest, fastest].
  void set_speed(double speed);
  /// Cycle time of the played run [s]; 0 stops.
  void set_duration(double duration);
  /// Repeats a range; none: plays to the end of the run, once.
  void set_loop(const std::optional<Loop>& loop);
  /// At the end of the run, starts again from its beginning.
  void play();
  void pause();
  /// Advances the cursor by `elapsed` real time [s]; stops at the end of the run, or repeats.
  void advance(double elapsed);

 signals:
  void playing_changed(bool playing);

 private:
  Cursor& cursor_;
  QTimer timer_;
  QElapsedTimer clock_;
  double speed_ = 1;
  double duration_ = 0;
  std::optional<Loop> loop_;
};

}  // namespace feedscope::ui
