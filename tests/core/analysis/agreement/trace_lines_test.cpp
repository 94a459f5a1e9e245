#include "core/analysis/agreement/line_guide.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "core/analysis/agreement/block_numbers.h"
#include "core/analysis/agreement/trace_on_program.h"
#include "tests/core/analysis/agreement/recorded_runs.h"

namespace feedscope {
namespace {

using test::has_remark;
using test::part_of;
using test::run_of;
using test::trace_of;

/// Three rounds along the same path, lines 2 to 5, 6 to 9 and 10 to 13.
class RepeatedRounds : public testing::Test {
 protected:
  RepeatedRounds()
      : run_(run_of("G21 G90 G17 F3000\nG1 X40\nY20\nX0\nY0\nX40\nY20\nX0\nY0\nX40\nY20\nX0\nY0\nM30\n")),
        course_(*run_.path, {true, true, true}),
        whole_(trace_of(run_, 1e-3)) {
    const MatchedRecord matched = match_record(course_, record_of(whole_), {0.3, 0});
    constexpr std::size_t ahead = 6;  // samples that the line is of a later instant
    for (std::size_t i = 0; i < matched.s.size(); ++i) {
      s_.push_back(matched.s[i]);
      whole_.line.push_back(course_.line_at(matched.s[std::min(i + ahead, matched.s.size() - 1)]));
    }
  }
  std::size_t sample_at(double s) const {
    return static_cast<std::size_t>(std::ranges::lower_bound(s_, s) - s_.begin());
  }
  TraceOnProgram found(const Trace& trace) const { return find_on_program(trace, course_, 0.02); }

  static constexpr double round = 120;  // [mm]
  feedscope::Run run_;
  ProgrammedCourse course_;
  Trace whole_;
  std::vector<double> s_;
};

TEST_F(RepeatedRounds, AreToldApartByTheProgramLinesOfTheTrace) {
  Trace second = part_of(whole_, sample_at(round + 10), sample_at(2 * round - 10));
  const TraceOnProgram by_line = found(second);
  EXPECT_NEAR(by_line.law.first_s(), round + 10, 0.2);
  EXPECT_NEAR(by_line.law.last_s(), 2 * round - 10, 0.2);
  second.line.clear();
  const TraceOnProgram by_place = found(second);
  EXPECT_NEAR(by_place.law.first_s(), 10, 0.2);  // as good as any
}

TEST_F(RepeatedRounds, OfWhichOneIsLostAreToldApartByTheLines) {
  const std::size_t from = sample_at(30);
  const std::size_t to = sample_at(2 * round + 30);
  Trace trace = part_of(whole_, 0, from);
  const Trace rest = part_of(whole_, to, whole_.size());
  trace.time.insert(trace.time.end(), rest.time.begin(), rest.time.end());
  trace.line.insert(trace.line.end(), rest.line.begin(), rest.line.end());
  for (std::size_t axis = 0; axis < 3; ++axis) {
    trace.place[axis].insert(trace.place[axis].end(), rest.place[axis].begin(), rest.place[axis].end());
  }
  const TraceOnProgram by_line = found(trace);
  EXPECT_NEAR(by_line.matched.s[from], 2 * round + 30, 0.5);
  EXPECT_NEAR(by_line.law.last_s(), 3 * round, 1e-2);
  EXPECT_NEAR(by_line.share, 1.0 / 3, 0.01);
  trace.line.clear();
  EXPECT_NEAR(found(trace).law.last_s(), round, 0.5);
}

TEST_F(RepeatedRounds, AreMatchedByPositionWhereTheLinesAreOfAnotherProgram) {
  Trace trace = whole_;
  for (std::uint32_t& line : trace.line) {
    line = 10 * line + 1000;  // block numbers
  }
  const TraceOnProgram by_place = found(trace);
  EXPECT_THAT(by_place.remarks, has_remark("trace-lines", "matched by position alone"));
  EXPECT_NEAR(by_place.share, 1, 1e-3);
  for (std::size_t i = 0; i < trace.size(); ++i) {
    trace.line[i] = 13 - whole_.line[i] % 12;  // of lines that it has, in another order
  }
  EXPECT_NEAR(found(trace).share, 1, 1e-3);
  EXPECT_NEAR(found(whole_).share, 1, 1e-3);
}

/// As controls do that join blocks: line 4 is named from the start of line 3 on.
TEST(FindOnProgram, ATraceThatNamesTheLastOfJoinedBlocksIsFoundOnTheFirst) {
  const auto run = run_of("G21 G90 G17 F3000\nG1 X20\nX40\nX60\nY30\nM30\n");
  const ProgrammedCourse course(*run.path, {true, true, true});
  Trace trace = trace_of(run, 1e-3);
  const MatchedRecord matched = match_record(course, record_of(trace), {0.3, 0});
  for (const double s : matched.s) {
    const std::uint32_t line = course.line_at(s);
    trace.line.push_back(line == 3 ? 4 : line);
  }
  const TraceOnProgram found = find_on_program(trace, course, 0.02);
  EXPECT_TRUE(found.lost.empty());
  EXPECT_NEAR(found.share, 1, 1e-3);
}

TEST(BlockNumbers, AreThoseThatLinesBeginWith) {
  const BlockNumbers numbers(
      SourceText("p", "N10 G0 X1\n  n20G1X2\n/2 N30 X3\n:40 X4\n50 L X5\n60X6\nG1 X7 N70\nN10 X8\n"));
  EXPECT_EQ(numbers.line_of(20), 2U);
  EXPECT_EQ(numbers.line_of(30), 3U);
  EXPECT_EQ(numbers.line_of(40), 4U);
  EXPECT_EQ(numbers.line_of(50), 5U);
  EXPECT_EQ(numbers.line_of(60), 0U) << "digits and a word are no Heidenhain block";
  EXPECT_EQ(numbers.line_of(70), 0U);
  EXPECT_EQ(numbers.line_of(10), 0U) << "two lines have it";
  EXPECT_THAT(numbers.lines_of({20, 20, 0, 50}), testing::ElementsAre(2, 2, 0, 5));
  EXPECT_TRUE(BlockNumbers(SourceText("p", "G1 X1\n")).empty());
}

/// Two rounds along the same path; the trace is of the second one, with block numbers.
TEST(FindOnProgram, ATraceWithBlockNumbersIsFoundByThem) {
  const char* text =
      "N100 G21 G90 G17 F3000\nN110 G1 X40\nN120 Y20\nN130 X0\nN140 Y0\nN150 X40\nN160 Y20\nN170 X0\nN180 "
      "Y0\nM30\n";
  const auto run = run_of(text);
  const ProgrammedCourse course(*run.path, {true, true, true});
  const Trace whole = trace_of(run, 1e-3);
  Trace second;
  second.period = whole.period;
  const double half = run.trajectory->duration() / 2;
  for (std::size_t i = 0; i < whole.size(); ++i) {
    if (whole.time[i] > half + 0.1 && whole.time[i] < 2 * half - 0.1) {
      second.time.push_back(whole.time[i]);
      second.line.push_back(90 + 10 * run.trajectory->state(whole.time[i]).line);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        second.place[axis].push_back(whole.place[axis][i]);
      }
    }
  }
  const SourceText& source = *run.input.program->source;
  const TraceOnProgram by_number = find_on_program(second, course, 0.02, &source);
  EXPECT_GT(by_number.law.first_s(), 120);
  EXPECT_THAT(by_number.remarks, testing::Not(has_remark("trace-lines", "matched by position")));
  const TraceOnProgram by_place = find_on_program(second, course, 0.02);
  EXPECT_LT(by_place.law.first_s(), 120);
}

/// A control stays on the line of a dwell as long as it lasts, here for most of the time.
TEST(FindOnProgram, LinesOfDwellsAreLinesOfTheProgram) {
  const auto run = run_of("G21 G90 G17 F6000\nG1 X20\nG4 P1\nX0\nG4 P1\nX20\nG4 P1\nX0\nM30\n");
  const ProgrammedCourse course(*run.path, {true, true, true});
  Trace trace = trace_of(run, 1e-3);
  for (const double time : trace.time) {
    trace.line.push_back(run.trajectory->state(time).line);
  }
  EXPECT_GT(std::ranges::count_if(trace.line, [](std::uint32_t line) { return line % 2 == 1; }),
            static_cast<std::ptrdiff_t>(trace.size() / 2));
  for (const Diagnostic& remark : find_on_program(trace, course, 0.02).remarks) {
    EXPECT_NE(remark.code, "trace-lines") << remark.message.english();
  }
}

}  // namespace
}  // namespace feedscope
