#include "core/identification/section_case.h"

#include <algorithm>
#include <cmath>

#include "core/analysis/time/line_times.h"
#include "core/base/error.h"
#include "core/base/translatable.h"

namespace feedscope {
namespace {

constexpr double clock_share = 5e-4;  // of a time: accuracy of control clocks and the override
constexpr std::size_t rounds = 12;    // neighbours go to different ones

constexpr double most_apart = 20;  // largest possible ratio to a simulated time, either way

/// Interpretation of times that are `ratio` times the simulated ones, with advice.
Translatable remedy_of(double ratio) {
  constexpr double milliseconds = 1000;
  constexpr double minutes = 60;
  constexpr double roughly = 4;
  const auto is_about = [&](double factor) { return ratio > factor / roughly && ratio < factor * roughly; };
  return is_about(milliseconds) ? NC_("core", "they seem to be in ms: give their column the title ms")
         : is_about(1 / milliseconds)
             ? NC_("core", "they seem to be in s: give their column the title seconds")
         : is_about(1 / minutes)
             ? NC_("core", "they seem to be in minutes: write them in seconds")
             : NC_("core", "give the program that ran, and its times in seconds, or in ms under this title");
}

}  // namespace

SectionCase::SectionCase(std::vector<SectionTime> times, std::string name, const LoadedProgram& program)
    : times_(std::move(times)), name_(std::move(name)), program_(program) {
  const ProgramSections sections(*program_.program->source);
  for (const SectionTime& time : times_) {
    lines_.push_back(sections.lines_of(time, name_));
  }
}

void SectionCase::check_times(const Setup& start) const {
  const std::vector<double> as_simulated =
      simulated(start.model->simulate(program_.toolpath, start.machine, start.settings));
  std::vector<double> ratios;
  for (std::size_t i = 0; i < times_.size(); ++i) {
    if (as_simulated[i] > 0) {
      ratios.push_back(times_[i].seconds / as_simulated[i]);
    }
  }
  if (ratios.empty()) {
    return;
  }
  const auto middle = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2);
  std::ranges::nth_element(ratios, middle);
  if (*middle > most_apart || *middle < 1 / most_apart) {
    throw InputError(message(
        NC_("core", "{}: the sections take {:.4g} times what machine '{}' takes in the simulation; {}"),
        name_, *middle, start.machine.id, remedy_of(*middle)));
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

std::vector<double> SectionCase::residuals(const Setup& setup, Progress* progress) const {
  std::vector<double> off =
      simulated(setup.model->simulate(program_.toolpath, setup.machine, setup.settings, progress));
  for (std::size_t i = 0; i < off.size(); ++i) {
    const double rounded = times_[i].resolution / std::sqrt(6.0);  // at both ends
    off[i] = (off[i] - times_[i].seconds) / std::hypot(rounded, clock_share * times_[i].seconds);
  }
  return off;
}

std::size_t SectionCase::stretch_of(std::size_t residual) const {
  // The first rounds have one more if the sections do not divide evenly.
  const std::size_t round = residual % rounds;
  return round * (times_.size() / rounds) + std::min(round, times_.size() % rounds) + residual / rounds;
}

FitResult SectionCase::result(const Run& run, Progress* /*progress*/) const {
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
