#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <optional>

#include "ui/shared/cursor.h"

namespace feedscope::ui {

/// Moves the cursor through the cycle time by the clock.
class Playback : public QObject {
  Q_OBJECT

 public:
  /// A stretch of the run [s].
  struct Loop {
    double from, to;
  };

  static constexpr double slowest = 0.01;
  static constexpr double fastest = 10'000;

  /// `cursor` outlives this.
  explicit Playback(Cursor& cursor, QObject* parent = nullptr);

  bool playing() const { return timer_.isActive(); }
  double speed() const { return speed_; }  ///< 1: true time
  /// Clamped to [slowest, fastest].
  void set_speed(double speed);
  /// Cycle time of the run that is played [s]; 0 stops.
  void set_duration(double duration);
  /// Plays a stretch over and over; none: to the end of the run, once.
  void set_loop(const std::optional<Loop>& loop);
  /// At the end of the run it begins again at the start.
  void play();
  void pause();
  /// Moves the cursor on by `elapsed` of the clock [s]; stops at the end of the run, or goes round.
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
