#include "core/analysis/agreement/trace_likeness.h"

#include <algorithm>
#include <utility>

#include "core/analysis/agreement/agreement.h"
#include "core/base/error.h"
#include "tests/core/analysis/agreement/recorded_runs.h"

namespace feedscope {
namespace {

using testing::AllOf;
using testing::HasSubstr;

using test::has_remark;
using test::run_of;
using test::trace_of;

void scale(Trace& trace, double factor) {
  for (const std::size_t axis : {0, 1}) {
    for (double& value : trace.place[axis]) {
      value *= factor;
    }
  }
}

/// What was recorded of a program, and what a wrong reading of its columns makes of it.
TEST(TraceLikeness, SaysHowATraceThatDoesNotFitWould) {
  const auto run = run_of("G21 G90 G17\nG1 X60 F6000\nX50 Y10\nY40\nX20 Y30\nX5 Y35\nM30\n");
  const Trace trace = trace_of(run, 1e-3);
  const auto remarks_on_it = [&](const Trace& changed) {
    const ProgrammedCourse course(*run.path, {true, true, true});
    return find_on_program(changed, course, 0.02).remarks;
  };
  Trace exchanged = trace;
  std::swap(exchanged.place[0], exchanged.place[1]);
  EXPECT_THAT(remarks_on_it(exchanged), has_remark("trace-columns", "its Y as X, its X as Y, its Z as Z"));
  Trace in_micrometres = trace;
  scale(in_micrometres, 1000);
  EXPECT_THAT(remarks_on_it(in_micrometres), has_remark("trace-columns", "1000 times as large"));
  for (double& x : in_micrometres.place[0]) {
    x += 5e6;
  }
  const ProgrammedCourse course(*run.path, {true, true, true});
  const TraceOnProgram nowhere = find_on_program(in_micrometres, course, 0.02);
  EXPECT_THAT(
      [&] { agreement_of(nowhere, course, run); },
      testing::ThrowsMessage<InputError>(HasSubstr("nowhere on this program: the trace has the shape")));
  Trace in_metres = exchanged;
  scale(in_metres, 1e-3);
  EXPECT_THAT(remarks_on_it(in_metres), AllOf(has_remark("trace-columns", "0.001 times as large"),
                                              has_remark("trace-columns", "its Y as X")));
  Trace small = trace;
  scale(small, 1e-3);
  EXPECT_EQ(remarks_on_it(small).front().code, "trace-columns") << "not that it stands still";
  EXPECT_THAT(remarks_on_it(small).front().hint.english(), HasSubstr("x=2:m,y=3:m"));
  Trace backwards = trace;
  for (auto& place : backwards.place) {
    std::ranges::reverse(place);
  }
  EXPECT_THAT(remarks_on_it(backwards), has_remark("trace-backwards", "from its end to its start"));
  const auto other = run_of("G21 G90 G17\nG1 X60 Y40 F6000\nY0\nX0 Y40\nX5 Y35\nM30\n");
  for (const Diagnostic& one : remarks_on_it(trace_of(other, 1e-3))) {
    EXPECT_NE(one.code, "trace-columns") << one.message.english();
  }
}

}  // namespace
}  // namespace feedscope
