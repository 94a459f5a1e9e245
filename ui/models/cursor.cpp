#include "ui/models/cursor.h"

#include <utility>

namespace feedscope::ui {

void Cursor::set_trajectory(std::shared_ptr<const Trajectory> trajectory) {
  const double place = state_.path_length;
  const bool at_start = state_.time == 0;
  trajectory_ = std::move(trajectory);
  if (!valid()) {
    state_ = Trajectory().state(0);
  } else {
    state_ = at_start ? trajectory_->state(0) : trajectory_->state_at_path(place);
  }
  emit changed();
}

void Cursor::set_time(double time) {
  if (valid()) {
    move_to(trajectory_->state(time));
  }
}

void Cursor::set_path_length(double s) {
  if (valid()) {
    move_to(trajectory_->state_at_path(s));
  }
}

void Cursor::set_line(std::uint32_t line) {
  if (valid()) {
    move_to(trajectory_->state(trajectory_->time_of_line(line)));
  }
}

void Cursor::move_to(const State& state) {
  if (state.time != state_.time) {
    state_ = state;
    emit changed();
  }
}

}  // namespace feedscope::ui
