#include "core/analysis/agreement/held_stretches.h"

#include <algorithm>

namespace feedscope {
namespace {

constexpr double shortest_hold = 0.5;  // [s]
constexpr double around_hold =
    0.5;  // [s] in which a control slows down before a hold and regains its feed after it
constexpr double still_way = 0.01;  // [mm]: less motion counts as standstill

/// Remark that a trace stops there; `hint`: consequence of that.
Diagnostic held_note(const HeldStretch& held, const ProgrammedCourse& course, const Message& hint) {
  return {
      .severity = Severity::warning,
      .line = 0,
      .column = 0,
      .code = "trace-held",
      .message = message(
          NC_("core",
              "the trace stands still for {:.3g} s from {:.4g} s on at line {}, where the program does not"),
          held.held, held.from, course.line_at((held.from_s + held.to_s) / 2)),
      .hint = hint};
}

}  // namespace

std::vector<HeldStretch> held_stretches(const TimeLaw& trace, const TimeLaw& run, double noise) {
  std::vector<HeldStretch> held;
  if (trace.empty() || run.empty()) {
    return held;
  }
  const std::vector<double>& s = trace.places();
  const std::vector<double>& t = trace.times();
  const double still = std::max(still_way, 6 * noise);
  std::size_t j = 0;
  for (std::size_t i = 0; i < s.size(); ++i) {
    j = std::max(j, i);
    while (j + 1 < s.size() && s[j + 1] - s[i] < still) {
      ++j;
    }
    if (s[i] < trace.first_s() + still || s[j] > trace.last_s() - still || t[j] - t[i] < shortest_hold) {
      continue;
    }
    const double longer = t[j] - t[i] - (run.at(s[j] + still) - run.at(s[i] - still));
    if (longer > shortest_hold) {
      held.push_back(
          {t[i], t[j], longer, trace.place_at(t[i] - around_hold).s, trace.place_at(t[j] + around_hold).s});
      i = j;
    }
  }
  return held;
}

void add_held_remarks(TraceOnProgram& trace, const ProgrammedCourse& course, const TimeLaw& run) {
  add_held_notes(
      trace.remarks, held_stretches(trace.law, run, trace.noise), course,
      NC_("core",
          "a feed hold, or a stop that the simulation does not know; its time is in that of the trace"));
}

void add_held_notes(std::vector<Diagnostic>& remarks, const std::vector<HeldStretch>& held,
                    const ProgrammedCourse& course, const Message& hint) {
  constexpr std::size_t most_listed = 5;
  double unlisted = 0;
  for (std::size_t i = 0; i < held.size(); ++i) {
    if (i < most_listed) {
      remarks.push_back(held_note(held[i], course, hint));
    } else {
      unlisted += held[i].held;
    }
  }
  if (held.size() > most_listed) {
    remarks.push_back(
        {.severity = Severity::warning,
         .line = 0,
         .column = 0,
         .code = "trace-held",
         .message = message(NC_("core", "the trace stands still in {} more places, for {:.3g} s in all"),
                            held.size() - most_listed, unlisted),
         .hint = hint});
  }
}

}  // namespace feedscope
