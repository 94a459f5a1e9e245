#pragma once

#include <QObject>
#include <cstdint>
#include <memory>

#include "core/analysis/time/line_times.h"
#include "core/trajectory/trajectory.h"

namespace feedscope::ui {

/// The place at which program text, 3D view and charts point together. All follow `changed`, whoever sets it.
class Cursor : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  /// Another run of the program: the cursor keeps its place on the path. Null: no place, and the next run
  /// starts at its beginning. `line_times`: of that run; without it, set_line() searches all blocks. Calling
  /// this again for the same run only adds them.
  void set_trajectory(std::shared_ptr<const Trajectory> trajectory,
                      std::shared_ptr<const LineTimes> line_times = nullptr);

  /// [s], clamped to the run
  void set_time(double time);
  /// Executed path length [mm], clamped to the run.
  void set_path_length(double s);
  /// 1-based source line; one without motion represents the next one with motion.
  void set_line(std::uint32_t line);

  /// Goes to the start of the next (1) or this or the previous (-1) block.
  void step_block(int direction);

  /// False without a run that moves.
  bool valid() const { return trajectory_ != nullptr && !trajectory_->pieces().empty(); }
  const State& state() const { return state_; }
  /// The run of the cursor; null for none.
  const std::shared_ptr<const Trajectory>& trajectory() const { return trajectory_; }

 signals:
  /// Emitted once per move, and once for a new run.
  void changed();

 private:
  void move_into_block(double time);
  void move_to(const State& state);

  std::shared_ptr<const Trajectory> trajectory_;
  std::shared_ptr<const LineTimes> line_times_;
  State state_ = Trajectory().state(0);
};

}  // namespace feedscope::ui
