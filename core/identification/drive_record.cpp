#include "core/identification/drive_record.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/error.h"
#include "core/drives/drive_law.h"
#include "core/drives/drive_step.h"

namespace feedscope {
namespace {

constexpr std::size_t degree = 3;
constexpr std::size_t around = 4;      // samples per cubic
constexpr double gap_share = 1.75;     // of the period, as in TraceBuilder
constexpr double same_time = 1e-3;     // share of the period: rounding of written times
constexpr double settling_time = 0.3;  // [s]: several time constants of the slowest drives
constexpr double window_time = 8;      // [s] of the parts taken from long traces
constexpr double standing = 1e-9;      // [mm]
constexpr std::size_t standing_samples = 5;
constexpr std::size_t least_samples = 50;  // of a stretch
constexpr double most_shift = 9.5;         // periods; actual positions may be nine late or early

/// Derivatives at `t[at]` of the cubic through four points.
std::array<double, 3> cubic_derivatives(const double* t, const double* x, std::size_t at) {
  // Newton's form for the samples in order, then expanded at t[at].
  std::array<double, around> c{x[0], x[1], x[2], x[3]};
  for (std::size_t order = 1; order < around; ++order) {
    for (std::size_t i = around - 1; i >= order; --i) {
      c[i] = (c[i] - c[i - 1]) / (t[i] - t[i - order]);
    }
  }
  const double a = t[at] - t[0];
  const double b = t[at] - t[1];
  const double d = t[at] - t[2];
  return {c[1] + c[2] * (a + b) + c[3] * (a * b + a * d + b * d), 2 * c[2] + 2 * c[3] * (a + b + d),
          6 * c[3]};
}

struct MotorPlace {
  double time = 0;      ///< since the start of a stretch [s]
  double place = 0;     ///< [mm]
  double velocity = 0;  ///< [mm/s]
};

/// Steps of a drive within cubics. Between missing samples a few durations alternate.
class StepsByTime {
 public:
  explicit StepsByTime(const DriveLaw& law) : law_(law) {}
  const DriveStep& within(double time) {
    if (steps_[used_].time() != time) {
      used_ = static_cast<std::size_t>(std::ranges::find(steps_, time, &DriveStep::time) - steps_.begin());
      if (used_ == steps_.size()) {
        used_ = oldest_;
        oldest_ = (oldest_ + 1) % steps_.size();
        steps_[used_] = DriveStep(law_, time, degree);
      }
    }
    return steps_[used_];
  }

 private:
  const DriveLaw& law_;
  std::array<DriveStep, 8> steps_{};
  std::size_t used_ = 0;
  std::size_t oldest_ = 0;
};

/// Hermite's cubic, extrapolated beyond both ends.
double place_between(const MotorPlace& from, const MotorPlace& to, double time) {
  const double h = to.time - from.time;
  const double u = (time - from.time) / h;
  const double step = to.place - from.place;
  return from.place + u * (h * from.velocity + u * (3 * step - h * (2 * from.velocity + to.velocity) +
                                                    u * (h * (from.velocity + to.velocity) - 2 * step)));
}

}  // namespace

DriveRecord::DriveRecord(const std::vector<const Trace*>& traces, std::size_t axis, std::size_t most,
                         BetweenSamples between, Progress* progress)
    : between_(between) {
  std::size_t all = 0;
  for (const Trace* trace : traces) {
    all += trace->has_drive(axis) ? trace->size() : 0;
  }
  for (std::size_t i = 0; i < traces.size(); ++i) {
    if (progress != nullptr && progress->cancelled()) {
      throw Cancelled();
    }
    if (const Trace& trace = *traces[i]; trace.has_drive(axis)) {
      const auto share = static_cast<double>(trace.size()) / static_cast<double>(all);
      add(trace, axis, ends_.size(), static_cast<std::size_t>(share * static_cast<double>(most)));
      ends_.push_back(0);
    }
  }
  measured_.reserve(steps_.size());
  for (Stretch& stretch : stretches_) {
    leave_margins(stretch);
    for (std::size_t i = stretch.first + stretch.settling; i < stretch.last_compared; ++i) {
      measured_.push_back(steps_[i].set - steps_[i].actual);
    }
    std::fill(ends_.begin() + static_cast<std::ptrdiff_t>(stretch.trace), ends_.end(),
              static_cast<Eigen::Index>(measured_.size()));
  }
}

void DriveRecord::add(const Trace& trace, std::size_t axis, std::size_t number, std::size_t most) {
  const auto [low, high] = std::ranges::minmax_element(trace.place[axis]);
  reach_ = std::max(reach_, *high - *low);
  const std::size_t window =
      std::max(least_samples, static_cast<std::size_t>(window_time / std::max(trace.period, 1e-6)));
  const std::size_t pitch =  // of the windows; covers all of a short trace
      most == 0 || trace.size() <= most ? window : window * trace.size() / most;
  std::size_t begin = 0;
  for (std::size_t i = 1; i <= trace.size(); ++i) {
    const bool ends = i == trace.size() || trace.time[i] - trace.time[i - 1] > gap_share * trace.period;
    if (ends) {
      if (pitch == window) {
        add_stretch(trace, axis, number, begin, i);
      } else {
        for (std::size_t from = begin; from < i; from += pitch) {
          add_stretch(trace, axis, number, from, std::min(i, from + window));
        }
      }
      begin = i;
    }
  }
}

void DriveRecord::add_stretch(const Trace& trace, std::size_t axis, std::size_t number, std::size_t begin,
                              std::size_t end) {
  if (end - begin < least_samples) {
    return;
  }
  const std::vector<double>& set = trace.place[axis];
  Stretch stretch;
  stretch.first = steps_.size();
  stretch.trace = number;
  for (std::size_t i = begin; i + 1 < end; ++i) {
    const std::size_t first = std::min(std::max(i, begin + 1) - 1, end - around);
    double time = trace.time[i + 1] - trace.time[i];
    std::array<double, around> times{};
    if (std::abs(time - trace.period) <= same_time * trace.period) {
      time = trace.period;
    }
    for (std::size_t k = 0; k < around; ++k) {
      const double at = trace.time[first + k] - trace.time[i];
      const double even = (static_cast<double>(first + k) - static_cast<double>(i)) * trace.period;
      times[k] = std::abs(at - even) <= 2 * same_time * trace.period ? even : at;
    }
    Step step;
    step.time = time;
    step.set = set[i + 1];
    step.actual = trace.actual[axis][i + 1];
    step.derivative = between_ == BetweenSamples::line
                          ? std::array{(set[i + 1] - set[i]) / time, 0.0, 0.0}
                          : cubic_derivatives(times.data(), &set[first], i - first);
    steps_.push_back(step);
  }
  const auto stands = [&](std::size_t i) { return std::abs(set[i] - set[begin]) <= standing; };
  bool at_rest = true;
  for (std::size_t i = begin; i < begin + standing_samples; ++i) {
    at_rest = at_rest && stands(i);
  }
  stretch.last = steps_.size();
  period_ = std::max(period_, trace.period);
  stretch.begins_in_motion = !at_rest;
  stretches_.push_back(stretch);
}

void DriveRecord::leave_margins(Stretch& stretch) const {
  const double shift = most_shift * period_;
  const double settling = stretch.begins_in_motion ? std::max(shift, settling_time) : shift;
  double time = 0;
  std::size_t from = stretch.first;
  while (from < stretch.last && time < settling) {
    time += steps_[from++].time;
  }
  stretch.settling = from - stretch.first;
  time = 0;
  std::size_t to = stretch.last;
  while (to > from && time < shift) {
    time += steps_[--to].time;
  }
  stretch.last_compared = to;
}

Eigen::VectorXd DriveRecord::without_means(Eigen::VectorXd values) const {
  Eigen::Index begin = 0;
  for (const Eigen::Index end : ends_) {
    if (end > begin) {
      auto of_trace = values.segment(begin, end - begin);
      of_trace.array() -= of_trace.mean();
    }
    begin = end;
  }
  return values;
}

Eigen::VectorXd DriveRecord::following_errors() const {
  return without_means(
      Eigen::Map<const Eigen::VectorXd>(measured_.data(), static_cast<Eigen::Index>(measured_.size())));
}

double DriveRecord::lag_time() const {
  double squares = 0;
  double products = 0;
  double velocities = 0;
  double errors = 0;
  for (const Step& step : steps_) {
    const double velocity = step.derivative[0];
    squares += velocity * velocity;
    products += velocity * (step.set - step.actual);
    velocities += velocity;
    errors += step.set - step.actual;
  }
  const auto count = static_cast<double>(steps_.size());
  const double spread = squares - velocities * velocities / count;
  return spread > 0 ? (products - velocities * errors / count) / spread : 0;
}

Eigen::VectorXd DriveRecord::residuals(const AxisDrive& drive, double delay) const {
  const DriveLaw law(drive, '?');
  Eigen::VectorXd left(static_cast<Eigen::Index>(measured_.size()));
  std::vector<MotorPlace> course;
  StepsByTime steps(law);
  SetCourse set;
  set.degree = degree;
  Eigen::Index next = 0;
  for (const Stretch& stretch : stretches_) {
    MotorMotion motor;
    if (stretch.begins_in_motion) {
      // As if the set position had always continued like this.
      const auto& [v, a, j] = steps_[stretch.first].derivative;
      const double gain = *drive.gain;
      const double slow = (1 - drive.feedforward.value_or(0)) / gain;
      motor = {-(slow * v + (drive.lag.value_or(0) / gain - slow / gain) * a), v - slow * a};
    }
    course.clear();
    course.reserve(stretch.last - stretch.first);
    double time = 0;
    for (std::size_t i = stretch.first; i < stretch.last; ++i) {
      const Step& step = steps_[i];
      std::ranges::copy(step.derivative, set.derivative.begin() + 1);
      const DriveStep::Answer answer = steps.within(step.time).answer(set, motor);
      motor = answer.next_start();
      time += step.time;
      course.push_back({time, step.set - answer.error, answer.velocity});
    }
    std::size_t before = 0;
    const auto place_then = [&](std::size_t i) {
      const double wanted = course[i].time - delay;
      while (before + 2 < course.size() && course[before + 1].time <= wanted) {
        ++before;
      }
      return place_between(course[before], course[before + 1], wanted);
    };
    for (std::size_t i = stretch.settling; stretch.first + i < stretch.last_compared; ++i) {
      left[next++] = (delay == 0 ? course[i].place : place_then(i)) - steps_[stretch.first + i].actual;
    }
  }
  return without_means(std::move(left));
}

}  // namespace feedscope
