#include "ui/shared/view_range.h"

#include <algorithm>
#include <utility>

namespace feedscope::ui {

namespace {

constexpr double deepest_zoom = 1e-7;  // of the run; finer steps exceed the precision of doubles

}  // namespace

void ViewRange::set_trajectory(std::shared_ptr<const Trajectory> trajectory, bool keep) {
  const bool all = shows_all();
  trajectory_ = std::move(trajectory);
  if (keep && !all && lower_ < length()) {
    show(lower_, upper_);
  } else {
    fit();
  }
}

void ViewRange::set_end_beside(double end) {
  const bool all = shows_all();
  if (std::exchange(end_beside_, end) == end || trajectory_ == nullptr) {
    return;
  }
  if (all) {
    fit();
  } else if (upper_ > length()) {
    show(lower_, upper_);
  }
}

void ViewRange::show_rapids(bool shown) {
  if (std::exchange(rapids_shown_, shown) != shown) {
    emit rapids_shown_changed(shown);
  }
}

void ViewRange::set_abscissa(Abscissa abscissa) {
  if (abscissa == abscissa_) {
    return;
  }
  const double from = time_at(lower_);
  const double to = time_at(upper_);
  abscissa_ = abscissa;
  trajectory_ == nullptr ? fit() : show_times(from, to);
}

double ViewRange::length() const {
  if (trajectory_ == nullptr) {
    return 0;
  }
  return abscissa_ == Abscissa::time ? std::max(trajectory_->duration(), end_beside_)
                                     : trajectory_->path_length();
}

void ViewRange::fit() {
  show(0, length() > 0 ? length() : 1);
}

void ViewRange::zoom(double factor, double pivot) {
  show(pivot + (lower_ - pivot) * factor, pivot + (upper_ - pivot) * factor);
}

void ViewRange::pan(double distance) {
  const double allowed = std::clamp(distance, -lower_, std::max(length() - upper_, -lower_));
  show(lower_ + allowed, upper_ + allowed);
}

void ViewRange::show(double lower, double upper) {
  const double all = length() > 0 ? length() : 1;
  const double width = std::clamp(upper - lower, all * deepest_zoom, all);
  lower_ = std::clamp((lower + upper - width) / 2, 0.0, all - width);
  upper_ = lower_ + width;
  emit changed();
}

void ViewRange::show_times(double from, double to) {
  if (trajectory_ == nullptr) {
    return;
  }
  if (abscissa_ == Abscissa::time) {
    show(from, to);
  } else {
    show(trajectory_->state(from).path_length, trajectory_->state(to).path_length);
  }
}

double ViewRange::in_run(double time) const {
  return trajectory_ == nullptr ? time : std::min(time, trajectory_->duration());
}

double ViewRange::position_of(const State& state) const {
  return abscissa_ == Abscissa::time ? state.time : state.path_length;
}

double ViewRange::time_at(double position) const {
  if (trajectory_ == nullptr || abscissa_ == Abscissa::time) {
    return position;
  }
  return trajectory_->state_at_path(position).time;
}

std::vector<double> ViewRange::column_times(int count) const {
  std::vector<double> times;
  times.reserve(static_cast<std::size_t>(count) + 1);
  for (int i = 0; i <= count; ++i) {
    times.push_back(time_at(lower_ + (upper_ - lower_) * i / count));
  }
  return times;
}

}  // namespace feedscope::ui
