#include "core/identification/trace_case.h"

#include <algorithm>
#include <cmath>

#include "core/analysis/agreement/feed_share.h"
#include "core/analysis/agreement/trace_likeness.h"
#include "core/analysis/run/run_stages.h"
#include "core/base/error.h"

namespace feedscope {
namespace {

constexpr double most_stretches = 1500;
constexpr double samples_a_stretch = 4;
constexpr double least_length = 5e-3;   // [mm]
constexpr double finest_step = 5e-4;    // [s]
constexpr double coarsest_step = 1e-3;  // [s]
constexpr double freedom = 0.5;  // [mm]: change of a control's distance from the path with another tolerance
constexpr double sampling_share = 0.03;  // of the period: uncertainty of a time due to sampling
constexpr double clear_distance = 6;     // times the noise
constexpr double least_distance = 3e-3;  // [mm]
constexpr double distance_unit = 1e-3;   // [mm]
constexpr double hopeless = 1e4;         // residual without anything to compare

}  // namespace

TraceCase::TraceCase(std::shared_ptr<const Trace> trace, const LoadedProgram& program, const Setup& start,
                     Progress* progress)
    : trace_(std::move(trace)), program_(program) {
  const Run run = simulate_motion(program, start, progress);
  course_ = std::make_shared<const ProgrammedCourse>(
      *run.path, SeenAxes{trace_->has(0), trace_->has(1), trace_->has(2)});
  found_ = find_on_program(*trace_, *course_,
                           freedom / 2 + deviation_of(*run.trajectory, *course_, coarsest_step, progress),
                           program.program->source.get(), progress);
  if (found_.law.empty() || !found_.belongs()) {
    const auto likeness = std::ranges::find_if(found_.remarks, says_likeness);
    if (likeness != found_.remarks.end()) {
      throw InputError(message(NC_("core", "{}: the trace does not belong to its program as it is: {}; {}"),
                               trace_->name, likeness->message, likeness->hint));
    }
    throw InputError(message(NC_("core",
                                 "{}: the trace does not belong to its program: {:.1f} % of its way runs "
                                 "along the path within {:.3g} mm, and along {:.1f} % of it; give the "
                                 "program that was recorded, with the zero point it ran with"),
                             trace_->name, 100 * found_.fit.trace_share, found_.tolerance,
                             100 * found_.fit.path_share));
  }
  step_ = std::clamp(trace_->period / 4, finest_step, coarsest_step);
  leave_out_holds(law_of(*run.trajectory, progress));
  try {
    const Agreement agreement = agreement_of(found_, *course_, run, progress);
    feed_share_ = feedscope::feed_share(agreement, *course_, *run.path);
    add_feed_remark(found_, agreement, *course_, *run.path);
  } catch (const InputError&) {
    // The initial machine does not complete the path: the search continues.
  }
  if (const Diagnostic* wrong = wrong_rate_of(*trace_, found_)) {
    throw InputError(message(NC_("core", "{}: no limits can be found from this trace: {}; {}"), trace_->name,
                             wrong->message, wrong->hint));
  }
  const double duration = found_.law.times().back() - found_.law.times().front();
  borders_ = cell_borders(found_.law, std::max(samples_a_stretch * trace_->period, duration / most_stretches),
                          std::max(least_length, 20 * found_.noise));
  const double margin = std::max(least_length, 6 * found_.noise);
  std::erase_if(borders_, [&](double s) {
    return s < found_.law.first_s() + margin || s > found_.law.last_s() - margin;
  });
  constexpr std::size_t least_borders = 10;
  if (borders_.size() < least_borders) {
    throw InputError(message(
        NC_("core", "{}: the trace holds too little of its program to find anything from it"), trace_->name));
  }
  for (std::size_t i = 0; i < borders_.size(); ++i) {
    times_.push_back(found_.law.at(borders_[i]));
    const std::size_t before = i > 0 ? i - 1 : 0;
    const std::size_t after = std::min(i + 1, borders_.size() - 1);
    const double speed = (borders_[after] - borders_[before]) /
                         std::max(1e-9, found_.law.at(borders_[after]) - found_.law.at(borders_[before]));
    time_noise_.push_back(
        std::hypot(sampling_share * trace_->period + trace_->jitter, found_.noise / std::max(speed, 1e-3)));
  }
  constexpr std::size_t several = 8;
  constexpr std::size_t many = 64;
  for (const std::size_t width : {std::size_t{1}, several, many, borders_.size() - 1}) {
    for (std::size_t i = 0; i + width < borders_.size(); i += width) {
      if (!found_.loses(borders_[i], borders_[i + width], true)) {
        add_span(i, i + width);
        short_ += width == 1 ? 1 : 0;
      }
    }
  }
  for (std::size_t i = 0; i + 1 < borders_.size(); ++i) {
    const TimeLaw::Farthest farthest = found_.law.farthest(borders_[i], borders_[i + 1]);
    if (farthest.distance > std::max(least_distance, clear_distance * found_.noise)) {
      farthest_.push_back(farthest);
      scale_.push_back(distance_unit + 2 * found_.noise + 0.02 * farthest.distance);
      stretch_.push_back(i);
    }
  }
}

TimeLaw TraceCase::law_of(const Trajectory& run, Progress* progress) const {
  const MotionRecord record = record_of(run, step_, progress);
  return {record.time, match_record(*course_, record, {found_.tolerance, found_.noise}, 0, progress)};
}

void TraceCase::leave_out_holds(const TimeLaw& run) {
  held_ = held_stretches(found_.law, run, found_.noise);
  for (const HeldStretch& one : held_) {
    found_.lost.push_back({one.from, one.to, one.from_s, one.to_s, true});
  }
  add_held_notes(found_.remarks, held_, *course_,
                 NC_("core",
                     "a feed hold, or a stop that the simulation does not know; half a second before and "
                     "after it is not compared, and its time not counted"));
  std::ranges::stable_sort(found_.lost, {}, &LostStretch::from);
}

void TraceCase::add_span(std::size_t first, std::size_t last) {
  spans_.push_back({first, last});
  scale_.push_back(std::hypot(time_noise_[first], time_noise_[last]));
  stretch_.push_back((first + last) / 2);
}

std::vector<double> TraceCase::residuals(const Setup& setup, Progress* progress) const {
  const Trajectory run = setup.model->simulate(program_.toolpath, setup.machine, setup.settings, progress);
  const TimeLaw law = law_of(run, progress);
  std::vector<double> off(size(), hopeless);
  if (law.empty() || law.last_s() < borders_.back() || law.first_s() > borders_.front()) {
    return off;
  }
  std::vector<double> times;
  times.reserve(borders_.size());
  for (const double s : borders_) {
    times.push_back(law.at(s));
  }
  std::size_t i = 0;
  for (const Span& span : spans_) {
    off[i] = ((times[span.last] - times[span.first]) - (times_[span.last] - times_[span.first])) / scale_[i];
    ++i;
  }
  for (const TimeLaw::Farthest& farthest : farthest_) {
    off[i] = (law.distance_at(farthest.s) - farthest.distance) / scale_[i];
    ++i;
  }
  return off;
}

AxisVector<AxisReach> TraceCase::reach() const {
  AxisVector<AxisReach> reach = reach_of(*trace_, found_.noise);
  const double scale = found_.pose.scale;
  for (std::size_t axis = 0; axis < reach.size(); ++axis) {
    reach[axis].velocity *= scale;
    reach[axis].acceleration *= scale;
    reach[axis].jerk *= scale;
  }
  return reach;
}

FitResult TraceCase::result(const Run& run, Progress* progress) const {
  FitResult result;
  result.agreement = agreement_of(found_, *course_, run, progress);
  const TimeLaw& law = found_.law;
  const TimeLaw& simulated = result.agreement.simulated;
  for (const HeldStretch& one : held_) {  // as if the control had passed there like the run
    result.agreement.measured_time -= law.at(one.to_s) - law.at(one.from_s);
    result.agreement.measured_time += simulated.at(one.to_s) - simulated.at(one.from_s);
  }
  result.agreement.held_time = 0;
  result.resolution = 2 * trace_->period;  // a motion begins and ends between two samples
  result.time_known = std::ranges::none_of(found_.lost, &LostStretch::jumps);
  const double length = found_.law.last_s() - found_.law.first_s();
  const double mean_feed = length / std::max(result.agreement.measured_time, 1e-9);
  const double cells = static_cast<double>(std::max<std::size_t>(1, result.agreement.cells.size()));
  const double by_jitter = trace_->jitter * cells / std::max(result.agreement.measured_time, 1e-9);
  const double share = result.agreement.feed_rms / mean_feed;
  result.feed_error = std::sqrt(std::max(0.0, share * share - by_jitter * by_jitter));
  return result;
}

}  // namespace feedscope
