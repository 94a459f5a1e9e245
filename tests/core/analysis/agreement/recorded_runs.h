#pragma once

#include <gmock/gmock.h>

#include <memory>
#include <random>
#include <string>
#include <vector>

#include "core/analysis/agreement/trace_on_program.h"
#include "core/analysis/run/run.h"

namespace feedscope::test {

inline feedscope::Run run_of(const std::string& text, const std::vector<std::string>& settings = {}) {
  SetupRequest request;
  request.machine = "linuxcnc-mill";
  request.assignments = settings;
  const auto source = std::make_shared<const SourceText>(SourceText("p.ngc", text));
  return simulate_run(load_program(source), make_setup(request));
}

/// What a control would have recorded of a run.
inline Trace trace_of(const Run& run, double period, double noise = 0) {
  const MotionRecord record = record_of(*run.trajectory, period);
  std::mt19937 random(7);
  std::normal_distribution<double> error(0, 1);
  Trace trace;
  for (std::size_t i = 0; i < record.time.size(); ++i) {
    if (i > 0 && record.time[i] <= record.time[i - 1]) {
      break;
    }
    trace.time.push_back(record.time[i]);
    for (int axis = 0; axis < 3; ++axis) {
      trace.place[static_cast<std::size_t>(axis)].push_back(record.place[i][axis] + noise * error(random));
    }
  }
  trace.period = period;
  return trace;
}

/// Of the remarks on a trace.
inline auto has_remark(const std::string& code, const std::string& words) {
  return testing::Contains(testing::AllOf(
      testing::Field(&Diagnostic::code, code),
      testing::Field(&Diagnostic::message, testing::Property(&Message::english, testing::HasSubstr(words)))));
}

/// Samples from `begin` to before `end`.
inline Trace part_of(Trace trace, std::size_t begin, std::size_t end) {
  const auto cut = [&](std::vector<double>& values) {
    if (!values.empty()) {
      values = std::vector<double>(values.begin() + static_cast<std::ptrdiff_t>(begin),
                                   values.begin() + static_cast<std::ptrdiff_t>(end));
    }
  };
  cut(trace.time);
  if (!trace.line.empty()) {
    trace.line = std::vector<std::uint32_t>(trace.line.begin() + static_cast<std::ptrdiff_t>(begin),
                                            trace.line.begin() + static_cast<std::ptrdiff_t>(end));
  }
  for (auto& place : trace.place) {
    cut(place);
  }
  return trace;
}

}  // namespace feedscope::test
