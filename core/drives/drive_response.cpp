#include "core/drives/drive_response.h"

#include <algorithm>
#include <cmath>

namespace feedscope {
namespace {

constexpr std::size_t spans_per_start = 32;

/// First time at which the motor is within `window` [mm] of a set position at rest [s].
double settling_time_of(const DriveLaw& law, const MotorMotion& motor, double window) {
  const auto within = [&](double time) {
    return std::abs(DriveStep(law, time, 1).answer(SetCourse(), motor).error) <= window;
  };
  if (law.follows_exactly() || within(0)) {
    return 0;
  }
  constexpr double part = 0.2;  // of a time constant, so that no oscillation through the window is missed
  const double step = part / law.settling_rate();
  double late = step;
  while (!within(late)) {
    late += step;
  }
  double early = late - step;
  constexpr int halvings = 50;
  for (int i = 0; i < halvings; ++i) {
    const double middle = (early + late) / 2;
    (within(middle) ? late : early) = middle;
  }
  return late;
}

}  // namespace

AxisDrives::AxisDrives(const Machine& machine) {
  for (std::size_t axis = 0; axis < laws.size(); ++axis) {
    const char name = coordinate_names[axis];
    if (const AxisDrive* drive = machine.drives.find(name)) {
      laws[axis] = DriveLaw(*drive, name);
      slides[axis] = Reversal(*drive);
    }
  }
}

bool has_drives(const Machine& machine) {
  return std::any_of(machine.drives.begin(), machine.drives.end(), [](AxisDrive drive) {
    drive.steps_per_mm.reset();  // affects where the motor may stop, not how it follows
    return drive != AxisDrive();
  });
}

DriveResponse::DriveResponse(std::shared_ptr<const Trajectory> trajectory, const Machine& machine,
                             Progress* progress)
    : trajectory_(std::move(trajectory)), drives_(std::make_shared<const AxisDrives>(machine)) {
  std::size_t count = 0;
  for (ActualWalk walk(*trajectory_, *drives_); !walk.done(); walk.next_span(), ++count) {
    if (count % spans_per_start != 0) {
      continue;
    }
    starts_.push_back({walk.span().time, walk.motors_, walk.slides_});
    if (progress != nullptr && starts_.size() % 1024 == 0) {
      progress->report(walk.span().time / trajectory_->duration());
    }
  }
}

bool DriveResponse::is_rigid() const {
  return std::ranges::all_of(drives_->slides, &Reversal::is_rigid);
}

const DriveResponse::Start& DriveResponse::start_before(double time) const {
  const auto after = std::upper_bound(starts_.begin(), starts_.end(), time,
                                      [](double t, const Start& start) { return t < start.time; });
  return after == starts_.begin() ? *after : *(after - 1);
}

ActualMotion DriveResponse::at(double time) const {
  return ActualWalk(*this, time).at(time);
}

ActualWalk::ActualWalk(const DriveResponse& response, double from)
    : drives_(*response.drives_),
      set_(*response.trajectory_, response.starts_.empty() ? 0 : response.start_before(from).time) {
  if (!response.starts_.empty()) {
    const DriveResponse::Start& start = response.start_before(from);
    motors_ = start.motors;
    slides_ = start.slides;
  }
}

ActualWalk::ActualWalk(const Trajectory& trajectory, const AxisDrives& drives)
    : drives_(drives), set_(trajectory), slides_(drives.slides) {}

void ActualWalk::next_span() {
  const SetSpan& span = set_.span();
  const Vec3 start = span.start;
  const double duration = span.duration;
  whole_.set(drives_.laws, duration, span.degree());
  std::array<MotorMotion, 3> reached;
  for (std::size_t axis = 0; axis < reached.size(); ++axis) {
    const SetCourse& set = span.axes[axis];
    if (!slides_[axis].is_rigid()) {
      slides_[axis].follow({drives_.laws[axis], set, motors_[axis]}, drives_.laws[axis], seen_, duration);
    }
    reached[axis] = whole_.of(axis).answer(set, motors_[axis]).motor();
  }
  set_.next();
  if (set_.done()) {
    seen_ = duration;  // later instants use the last span
    return;
  }
  seen_ = 0;
  if (span.begins) {
    motors_ = {};
    slides_ = drives_.slides;
    return;
  }
  for (std::size_t axis = 0; axis < reached.size(); ++axis) {
    const auto i = static_cast<Eigen::Index>(axis);
    motors_[axis] = {reached[axis].offset + start[i] - span.start[i], reached[axis].velocity};
  }
}

double ActualWalk::settling_time(double window) const {
  AxisSteps whole;
  const SetSpan& span = set_.span();
  whole.set(drives_.laws, set_.done() ? span.duration : 0, span.degree());
  double time = 0;
  for (std::size_t axis = 0; axis < motors_.size(); ++axis) {
    const MotorMotion motor = whole.of(axis).answer(span.axes[axis], motors_[axis]).next_start();
    time = std::max(time, settling_time_of(drives_.laws[axis], motor, window));
  }
  return time;
}

void ActualWalk::rest(double time) {
  if (set_.done()) {
    return;
  }
  AxisSteps steps;
  steps.set(drives_.laws, time, 1);
  const SetCourse set;
  for (std::size_t axis = 0; axis < motors_.size(); ++axis) {
    if (!slides_[axis].is_rigid()) {
      slides_[axis].follow({drives_.laws[axis], set, motors_[axis]}, drives_.laws[axis], 0, time);
    }
    motors_[axis] = steps.of(axis).answer(set, motors_[axis]).next_start();
  }
}

ActualMotion ActualWalk::at(double time) {
  while (!set_.done() && set_.span().end() <= time) {
    next_span();
  }
  return within_span(time);
}

ActualMotion ActualWalk::within_span(double time) {
  ActualMotion actual;
  const SetSpan& span = set_.span();
  const double h = std::clamp(time - span.time, 0.0, span.duration);
  within_.set(drives_.laws, h, span.degree());
  for (std::size_t axis = 0; axis < motors_.size(); ++axis) {
    const auto i = static_cast<Eigen::Index>(axis);
    const SetCourse& set = span.axes[axis];
    if (!slides_[axis].is_rigid() && h > seen_) {
      slides_[axis].follow({drives_.laws[axis], set, motors_[axis]}, drives_.laws[axis], seen_, h);
    }
    const DriveStep::Answer motor = within_.of(axis).answer(set, motors_[axis]);
    const double lead = slides_[axis].lead();
    actual.position[i] = span.start[i] + motor.travel - motor.error + lead;
    actual.velocity[i] = motor.velocity;
    actual.following_error[i] = motor.error - lead;
  }
  seen_ = std::max(seen_, h);
  return actual;
}

}  // namespace feedscope
