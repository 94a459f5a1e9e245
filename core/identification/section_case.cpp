#include "core/identification/section_case.h"

#include <algorithm>
#include <cmath>

#include "core/analysis/line_times.h"

namespace feedscope {
namespace {

constexpr double clock_share = 5e-4;  // of a time: clocks of controls and the override
constexpr std::size_t rounds = 12;    // neighbours go to different ones

}  // namespace

SectionCase::SectionCase(std::vector<SectionTime> times, std::string name, const LoadedProgram& program)
    : times_(std::move(times)), name_(std::move(name)), program_(program) {
  const ProgramSections sections(*program_.program->source);
  for (const SectionTime& time : times_) {
    lines_.push_back(sections.lines_of(time, name_));
  }
}

std::vector<double> SectionCase::simulated(const Trajectory& run) const {
  const LineTimes by_line(run);
  std::vector<double> times;
  for (const SectionLines& lines : lines_) {
    times.push_back(by_line.of(lines.first, lines.last).time);
  }
  return times;
}

std::vector<double> SectionCase::residuals(const Setup& setup) const {
  std::vector<double> off =
      simulated(setup.model->simulate(program_.toolpath, setup.machine, setup.settings));
  for (std::size_t i = 0; i < off.size(); ++i) {
    const double rounded = times_[i].resolution / std::sqrt(6.0);  // at both ends
    off[i] = (off[i] - times_[i].seconds) / std::hypot(rounded, clock_share * times_[i].seconds);
  }
  return off;
}

std::size_t SectionCase::stretch_of(std::size_t residual) const {
  const std::size_t in_a_round = (times_.size() + rounds - 1) / rounds;
  return std::min(times_.size() - 1, (residual % rounds) * in_a_round + residual / rounds);
}

FitResult SectionCase::result(const Run& run) const {
  FitResult result;
  const std::vector<double> times = simulated(*run.trajectory);
  double squares = 0;
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double measured = times_[i].seconds;
    const double off = std::max(0.0, std::abs(times[i] - measured) - times_[i].resolution) / measured;
    squares += measured * off * off;
    result.agreement.measured_time += measured;
    result.agreement.simulated_time += times[i];
    result.sections.push_back({times_[i].section, measured, times[i]});
  }
  result.feed_error = std::sqrt(squares / result.agreement.measured_time);
  return result;
}

}  // namespace feedscope
