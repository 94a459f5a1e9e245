#include "ui/shared/cursor.h"

#include <algorithm>
#include <utility>

namespace feedscope::ui {

namespace {

constexpr double settled = 1e-9;  // a block counts as started this close to its start [s]

/// Start of `element` [s].
double start_of(const Trajectory& trajectory, std::uint32_t element) {
  const auto& pieces = trajectory.pieces();
  const auto own = std::ranges::lower_bound(pieces, element, {}, &Piece::element);
  const bool begins_with_it = own != pieces.end() && own->element == element && own->q <= 0;
  return begins_with_it ? own->time : trajectory.state_at_path(trajectory.path().s(element)).time;
}

}  // namespace

void Cursor::set_trajectory(std::shared_ptr<const Trajectory> trajectory,
                            std::shared_ptr<const LineTimes> line_times) {
  if (trajectory != nullptr && trajectory == trajectory_) {
    line_times_ = std::move(line_times);
    return;
  }
  const double place = state_.path_length;
  const bool at_start = state_.time == 0;
  trajectory_ = std::move(trajectory);
  line_times_ = std::move(line_times);
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
  if (!valid()) {
    return;
  }
  if (line_times_ == nullptr) {
    move_into_block(trajectory_->time_of_line(line));
    return;
  }
  const auto element = line_times_->first_element(line);
  move_into_block(element ? start_of(*trajectory_, *element) : trajectory_->duration());
}

void Cursor::step_block(int direction) {
  if (!valid()) {
    return;
  }
  const BlendedPath& path = trajectory_->path();
  const auto start_of_block = [&path](std::uint32_t element) {
    while (element > 0 && path.segment(element - 1) == path.segment(element)) {
      --element;
    }
    return element;
  };
  std::uint32_t element = state_.element;
  if (direction > 0) {
    const std::uint32_t block = path.segment(element);
    while (element < path.size() && path.segment(element) == block) {
      ++element;
    }
    const double time = element < path.size() ? start_of(*trajectory_, element) : trajectory_->duration();
    move_into_block(std::max(time, state_.time));
    return;
  }
  element = start_of_block(element);
  if (state_.time - start_of(*trajectory_, element) <= 2 * settled && element > 0) {
    element = start_of_block(element - 1);
  }
  move_into_block(start_of(*trajectory_, element));
}

/// Moves to `time`; of two blocks that meet there, to the one that begins, which rounding may miss.
void Cursor::move_into_block(double time) {
  const State at = trajectory_->state(time);
  const State after = trajectory_->state(time + settled);
  move_to(after.element > at.element ? after : at);
}

void Cursor::move_to(const State& state) {
  if (state.time != state_.time) {
    state_ = state;
    emit changed();
  }
}

}  // namespace feedscope::ui
