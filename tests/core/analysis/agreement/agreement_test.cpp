#include "core/analysis/agreement/agreement.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/analysis/agreement/feed_share.h"
#include "core/analysis/agreement/trace_alignment.h"
#include "core/base/error.h"
#include "tests/core/analysis/agreement/recorded_runs.h"

namespace feedscope {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::Field;
using testing::HasSubstr;
using testing::IsEmpty;

using test::has_remark;
using test::part_of;
using test::run_of;
using test::trace_of;

/// Out and back along one line, round a closed circle, a pause, and a line that is run twice.
constexpr const char* program_text =
    "G21 G90 G17\nG1 X60 F6000\nX0\nG1 X20 Y10\nG3 X20 Y10 I0 J8\nG4 P0.3\nG1 X50 Y40\nX20 Y10\nX50 "
    "Y40\nM30\n";

void change(Trace& trace, std::size_t axis, double factor, double offset) {
  for (double& value : trace.place[axis]) {
    value = factor * value + offset;
  }
}

struct Compared {
  TraceOnProgram found;
  Agreement agreement;
};

Compared compare(const Trace& trace, const Run& run) {
  const ProgrammedCourse course(*run.path, {trace.has(0), trace.has(1), trace.has(2)});
  const TraceOnProgram found = find_on_program(trace, course, deviation_of(*run.trajectory, course, 1e-3));
  return {found, agreement_of(found, course, run)};
}

TEST(Agreement, OfATraceWithItsOwnRunIsExact) {
  const auto run = run_of(program_text);
  const auto [found, agreement] = compare(trace_of(run, 1e-3), run);
  EXPECT_THAT(found.remarks, IsEmpty());
  EXPECT_TRUE(agreement.whole);
  EXPECT_NEAR(agreement.measured_time, run.trajectory->duration(), 2e-3);
  EXPECT_NEAR(agreement.simulated_time, agreement.measured_time, 1e-3);
  EXPECT_LT(agreement.feed_rms, 0.05);
  EXPECT_NEAR(found.share, 1, 1e-4);
}

/// A control that cuts a right angle within 0.02 mm: not the distance from the line before, to its end.
TEST(Agreement, IsAsFarFromTheProgramAsTheContourErrorOfTheRun) {
  for (const char* text : {"G21 G90 G17 G64 P0.02\nG1 X30 F6000\nY30\nX10 Y40\nM30\n",
                           "G21 G90 G17 G64 P0.02\nG1 Z-10 F1000\nX50 F6000\nM30\n"}) {
    const auto run = run_of(text);
    const double error = run.summary.max_contour_error;
    ASSERT_GT(error, 0.01);
    const auto [found, agreement] = compare(trace_of(run, 1e-3), run);
    EXPECT_LE(agreement.distance, error + 1e-4);
    EXPECT_GE(agreement.distance, 0.8 * error) << "between two samples it is a little more";
    EXPECT_NEAR(agreement.simulated_distance, agreement.distance, 2e-3);
  }
}

/// The corners of a wave are cut on its crests alone, which moves all of its reach.
TEST(Agreement, FindsNoOffsetThatCutCornersMakeButATrueOne) {
  std::string text = "G21 G90 G17 G64 P0.02\n";
  for (int i = 1; i <= 30; ++i) {
    text += fmt::format("G1 X{} Y{} F6000\n", i, i % 2);
  }
  const auto run = run_of(text);
  Trace trace = trace_of(run, 1e-3, 2e-4);
  const auto [found, agreement] = compare(trace, run);
  EXPECT_EQ(found.pose.offset, Vec3(Vec3::Zero()));
  EXPECT_TRUE(agreement.whole);
  change(trace, 1, 1, 0.05);
  EXPECT_NEAR(compare(trace, run).found.pose.offset.y(), -0.05, 5e-3);
}

TEST(Agreement, ToleratesNoiseAndACoarseRate) {
  const auto run = run_of(program_text);
  const Agreement agreement = compare(trace_of(run, 4e-3, 1e-3), run).agreement;
  EXPECT_NEAR(agreement.measured_time / run.trajectory->duration(), 1, 2e-3);
  EXPECT_LT(agreement.feed_rms, 0.02 * 100);
}

TEST(Agreement, SaysByHowMuchAnotherMachineIsOff) {
  const auto slow = run_of(program_text, {"X.acceleration=0.4", "Y.acceleration=0.4"});
  const auto run = run_of(program_text);
  const Agreement agreement = compare(trace_of(slow, 1e-3), run).agreement;
  EXPECT_NEAR(agreement.measured_time, slow.trajectory->duration(), 3e-3);
  EXPECT_NEAR(agreement.simulated_time, run.trajectory->duration(), 3e-3);
  EXPECT_GT(agreement.feed_rms, 2);
  ASSERT_FALSE(agreement.worst.empty());
  EXPECT_GT(agreement.worst.front().lost, 0);
}

TEST(Agreement, FindsOffsetsMirroredAxesAndInches) {
  const auto run = run_of(program_text);
  Trace moved = trace_of(run, 1e-3);
  change(moved, 0, 1, 123.4);
  change(moved, 1, 1, -0.6);
  const Compared shifted = compare(moved, run);
  EXPECT_NEAR(shifted.found.pose.offset.x(), -123.4, 0.02);
  EXPECT_NEAR(shifted.found.pose.offset.y(), 0.6, 0.02);
  EXPECT_LT(shifted.agreement.feed_rms, 0.5);

  Trace mirrored = trace_of(run, 1e-3);
  change(mirrored, 1, -1, 0);
  const Compared turned = compare(mirrored, run);
  EXPECT_THAT(turned.found.remarks, has_remark("trace-mirrored", "axis Y of the trace is mirrored"));
  EXPECT_LT(turned.agreement.feed_rms, 0.5);

  Trace inches = trace_of(run, 1e-3);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    change(inches, axis, 1 / 25.4, 0);
  }
  const Compared scaled = compare(inches, run);
  EXPECT_THAT(scaled.found.remarks, has_remark("trace-inches", "in inches"));
  EXPECT_LT(scaled.agreement.feed_rms, 0.5);
}

TEST(Agreement, MarksWhatDoesNotFitAndComparesTheRest) {
  const auto run = run_of(program_text);
  Trace trace = trace_of(run, 1e-3);
  const std::size_t half = trace.size() / 2;
  for (std::size_t i = half; i < half + 200; ++i) {
    trace.place[2][i] += 30;
  }
  const Compared lost = compare(trace, run);
  EXPECT_EQ(lost.found.matched.lost, 200U);
  EXPECT_THAT(lost.found.remarks, has_remark("trace-off-path", "farther than"));
  EXPECT_THAT(lost.found.remarks, has_remark("trace-off-path", "s on at line"));
  EXPECT_NEAR(lost.agreement.measured_time, run.trajectory->duration(), 3e-3);

  const Trace beginning = part_of(trace_of(run, 1e-3), 0, half);
  const Compared part = compare(beginning, run);
  EXPECT_FALSE(part.agreement.whole);
  EXPECT_THAT(part.found.remarks, has_remark("trace-part", "of the path of the program, lines 2 to "));
  EXPECT_TRUE(part.found.belongs());
  EXPECT_NEAR(part.agreement.measured_time, part.agreement.simulated_time, 3e-3);
}

TEST(Agreement, ComparesTheFirstOfSeveralPasses) {
  const std::string there_and_back = "G21 G90 G17\nG1 X60 F6000\nX60 Y20\nX0\nY0\n";
  const auto twice = run_of(there_and_back + "G4 P0.5\n" + there_and_back + "M30\n");
  const auto once = run_of(there_and_back + "M30\n");
  const Compared compared = compare(trace_of(twice, 1e-3), once);
  ASSERT_EQ(compared.found.pass_times.size(), 2U);
  // The second pass, 0.15 mm aside, is not compared: nor is its distance.
  Trace aside = trace_of(twice, 1e-3);
  for (std::size_t i = aside.size() / 2; i < aside.size(); ++i) {
    aside.place[0][i] += 0.15;
  }
  const Compared first = compare(aside, once);
  EXPECT_NEAR(first.agreement.distance, compared.agreement.distance, 1e-3);
  EXPECT_LT(compared.agreement.distance, 0.1);
  EXPECT_NEAR(compared.agreement.measured_time, once.trajectory->duration(), 0.01);
}

/// The last half millimetre, in which the axes slow down, is not in the recording: its time is not known.
TEST(Agreement, IsOfAPartWhereTheEndWasNotRecorded) {
  const auto run = run_of("G21 G90 G17\nG1 X60 F6000\nY40\nM30\n");
  const Trace whole = trace_of(run, 1e-3);
  std::size_t end = whole.size();
  while (whole.place[1][end - 1] > 39.5) {
    --end;
  }
  const auto [found, agreement] = compare(part_of(whole, 0, end), run);
  EXPECT_FALSE(agreement.whole);
  EXPECT_LE(agreement.measured_time, whole.time[end - 1]);
  EXPECT_NEAR(agreement.measured_time, agreement.simulated_time, 2e-3);
  EXPECT_TRUE(compare(whole, run).agreement.whole);
}

TEST(Agreement, CountsNoPauseToAStretchBesideIt) {
  const auto run = run_of(
      "G21 G90 G17\nF3000\nG1 X30\nG4 P0.3\nY20\nG4 P0.3\nG4 P0.3\nX0\nG4 P0.3\nX30\nG4 "
      "P0.3\nY0\nX60\nM30\n");
  for (const double noise : {0.0, 3e-4, 2e-3}) {
    const Agreement agreement = compare(trace_of(run, 4e-3, noise), run).agreement;
    ASSERT_FALSE(agreement.worst.empty());
    EXPECT_LT(std::abs(agreement.worst.front().lost), 0.02) << "noise " << noise;
  }
}

TEST(Agreement, TimesAtPlacesAndDistancesThereAreThoseOfTheRecord) {
  MatchedRecord matched;
  matched.s = {0, 1, 1, 1, 2, 4};
  matched.distance = {0, 0.1F, 0.3F, 0.2F, 0.4F, 0};
  matched.end = matched.s.size();
  const TimeLaw law({0, 1, 2, 3, 4, 5}, matched);
  EXPECT_DOUBLE_EQ(law.at(1), 1);
  EXPECT_DOUBLE_EQ(law.at(1, 1), 3);
  EXPECT_DOUBLE_EQ(law.at(1.001, 0.5, 0.01), 2);
  EXPECT_DOUBLE_EQ(law.place_at(2).s, 1);
  EXPECT_DOUBLE_EQ(law.place_at(2).share, 0.5);
  EXPECT_DOUBLE_EQ(law.place_at(4.5).s, 3);
  EXPECT_NEAR(law.farthest(0, 1.5).distance, 0.3, 1e-6);
  EXPECT_DOUBLE_EQ(law.farthest(1.5, 4).s, 2);
  EXPECT_NEAR(law.distance_at(3), 0.2, 1e-6);
}

/// What is held in a corner is neither the feed of the corner nor of a stretch; the whole time has it.
TEST(Agreement, LeavesAFeedHoldOutOfFeedsAndCorners) {
  const auto run = run_of("G21 G90 G17\nF3000\nG1 X60\nY40\nX0\nY0\nX60 Y20\nM30\n");
  Trace trace = trace_of(run, 1e-3);
  const auto at = trace.size() / 2;
  constexpr double hold = 3;
  const auto count = static_cast<std::size_t>(hold / trace.period);
  for (auto& axis : trace.place) {
    axis.insert(axis.begin() + static_cast<std::ptrdiff_t>(at), count, axis[at]);
  }
  trace.time.clear();
  for (std::size_t i = 0; i < trace.place[0].size(); ++i) {
    trace.time.push_back(static_cast<double>(i) * trace.period);
  }
  const Agreement agreement = compare(trace, run).agreement;
  EXPECT_NEAR(agreement.measured_time - agreement.simulated_time, hold, 0.01);
  EXPECT_NEAR(agreement.held_time, hold, 0.05);
  EXPECT_NEAR(agreement.time_error_without_holds(), 0, 0.01);
  EXPECT_LT(agreement.feed_rms, 0.5);
  EXPECT_LT(agreement.corner_rms(), 0.01);
}

TEST(FeedShare, IsThatOfAnOverrideAndNoneOfTheProgramAsItIs) {
  const std::string text = "G21 G90 G17\nF3000\nG1 X60\nY60\nX0\nY0\nX60 Y60\nM30\n";
  const auto run = run_of(text);
  const auto share = [&](const Trace& trace) {
    const ProgrammedCourse course(*run.path, {true, true, true});
    const TraceOnProgram found = find_on_program(trace, course, deviation_of(*run.trajectory, course, 1e-3));
    return feed_share(agreement_of(found, course, run), course, *run.path);
  };
  EXPECT_FALSE(share(trace_of(run, 1e-3)));
  const auto half = share(trace_of(run_of(text, {"feed_override_percent=50"}), 1e-3));
  ASSERT_TRUE(half);
  EXPECT_NEAR(*half, 0.5, 0.002);
  EXPECT_FALSE(share(trace_of(run_of(text, {"X.velocity=1.5"}), 1e-3))) << "one slow axis is no override";
}

/// As a trace without times whose rate is wrong: each `period` is counted as a millisecond.
Trace counted(Trace trace, double period, TraceClock clock = TraceClock::machine) {
  for (double& time : trace.time) {
    time *= 1e-3 / period;
  }
  trace.period = 1e-3;
  trace.clock = clock;
  return trace;
}

TraceOnProgram remarked(const Trace& trace, const Run& run) {
  const ProgrammedCourse course(*run.path, {true, true, true});
  TraceOnProgram found = find_on_program(trace, course, deviation_of(*run.trajectory, course, 1e-3));
  add_feed_remark(found, agreement_of(found, course, run), course, *run.path);
  return found;
}

/// Neither an override nor other limits make the same ratio at even speed and on ramps.
TEST(PaceRatio, IsThatOfAWrongRateAlone) {
  const std::string text =
      "G21 G90 G17 G61\nF6000\nG1 X60\nY60\nX0\nY0\nX5\nX10\nX15\nX20\nX60 Y60\nG0 X0 Y0\nM30\n";
  const auto run = run_of(text);
  for (const double period : {2e-3, 0.5e-3, 1.25e-3}) {
    const Trace trace = counted(trace_of(run, period), period);
    const auto ratio = pace_ratio(compare(trace, run).agreement);
    ASSERT_TRUE(ratio) << period;
    EXPECT_NEAR(*ratio, period / 1e-3, 0.01 * period / 1e-3);
    const TraceOnProgram found = remarked(trace, run);
    EXPECT_THAT(found.remarks, has_remark("trace-rate", fmt::format("runs at {:.3g} %", period * 1e5)));
    ASSERT_NE(wrong_rate_of(trace, found), nullptr);
    EXPECT_THAT(wrong_rate_of(trace, found)->hint.english(), HasSubstr("linuxcnc,rate="));
  }
  const auto none = [&](const std::vector<std::string>& settings) {
    return !pace_ratio(compare(trace_of(run_of(text, settings), 1e-3), run).agreement);
  };
  EXPECT_TRUE(none({}));
  EXPECT_TRUE(none({"feed_override_percent=50"}));
  EXPECT_TRUE(none({"X.acceleration=3", "Y.acceleration=3"}));
  EXPECT_TRUE(none({"X.velocity=3", "Y.velocity=3"}));
}

/// On a machine that has other limits than those of the simulation, which never come to the feed.
TEST(FeedShare, AboveOneIsFoundWhereTheTraceExceedsTheFeed) {
  const std::string text = "G21 G90 G17 G61\nF3000\nG1 X60\nY60\nX0\nY0\nX60 Y60\nM30\n";
  const auto run = run_of(text, {"X.velocity=1.5", "Y.velocity=1.5"});
  const Trace trace = counted(trace_of(run_of(text), 2e-3), 2e-3);
  const TraceOnProgram found = remarked(trace, run);
  EXPECT_THAT(found.remarks, has_remark("trace-rate", "runs at 200 % of the programmed feed"));
  ASSERT_NE(wrong_rate_of(trace, found), nullptr);
  EXPECT_THAT(wrong_rate_of(trace, found)->hint.english(), HasSubstr("rate=500; or set the feed override"));
  const Trace timed = counted(trace_of(run_of(text), 2e-3), 2e-3, TraceClock::times);
  EXPECT_THAT(remarked(timed, run).remarks, has_remark("trace-override", "200 % of it"));
  EXPECT_EQ(wrong_rate_of(timed, remarked(timed, run)), nullptr);
}

/// On a machine with other limits than those of the simulation, whose feed is never reached: dwells alone say
/// it, and they do whatever the feed override.
TEST(DwellRatio, IsThatOfAWrongRateWhateverMachineAndFeed) {
  std::string text = "G21 G90 G17\nF60000\n";
  for (int i = 1; i <= 6; ++i) {
    text += fmt::format("G1 X{} Y{}\nG4 P0.2\n", 3 * i, i % 2);
  }
  const auto run = run_of(text + "M30\n");
  const auto ratio = [&](const Trace& trace) {
    const ProgrammedCourse course(*run.path, {true, true, true});
    const Compared compared = compare(trace, run);
    return dwell_ratio(compared.found.law, compared.agreement.simulated, course, *run.path);
  };
  const std::vector<std::string> other{"X.acceleration=1.3", "Y.acceleration=0.3", "X.velocity=20"};
  const auto fast = ratio(counted(trace_of(run_of(text + "M30\n", other), 2e-3), 2e-3));
  ASSERT_TRUE(fast);
  EXPECT_NEAR(*fast, 2, 0.1);
  EXPECT_FALSE(ratio(trace_of(run_of(text + "M30\n", other), 1e-3)));
  EXPECT_FALSE(ratio(trace_of(run_of(text + "M30\n", {"feed_override_percent=50"}), 1e-3)));
  const Trace trace = counted(trace_of(run_of(text + "M30\n", other), 2e-3), 2e-3);
  EXPECT_THAT(remarked(trace, run).remarks, has_remark("trace-rate", "% of the time of the dwells"));
}

TEST(Agreement, LearnsFromOneAxis) {
  const auto run = run_of(program_text);
  Trace trace = trace_of(run, 1e-3);
  trace.place[1].clear();
  trace.place[2].clear();
  const auto [found, agreement] = compare(trace, run);
  EXPECT_NEAR(agreement.measured_time, agreement.simulated_time, 5e-3);
  EXPECT_THAT(found.remarks, has_remark("trace-axes", "the trace does not have Y, which the program moves"));
}

TEST(Agreement, SaysThatATraceIsOfAnotherProgramAndDoesNotMoveIt) {
  const auto run = run_of(program_text);
  // Begins at the same place, and comes back to it.
  const auto other =
      run_of("G21 G90 G17\nG1 X10 Y20 F6000\nX40 Y45\nG3 X0 Y30 I-20 J0\nX33 Y5\nX7 Y7\nX0 Y0\nM30\n");
  const auto [found, agreement] = compare(trace_of(other, 1e-3), run);
  EXPECT_FALSE(found.belongs());
  EXPECT_FALSE(agreement.whole);
  EXPECT_LT(found.fit.trace_share, 0.3);
  EXPECT_THAT(found.remarks, has_remark("trace-other-program", "does not belong to this program"));
  EXPECT_TRUE(found.pose.plain());
  EXPECT_EQ(found.pose.offset, Vec3(Vec3::Zero()));
}

/// It reaches as far as the program does, so that its reach would give it an offset.
TEST(Agreement, KeepsATraceOfAnotherProgramOfTheSameReachWhereItIs) {
  const auto run = run_of(program_text);
  const auto other = run_of(
      "G21 G90 G17\nG0 X100 Y100\nG1 X160 Y140 F6000\nX160 Y100\nX100 Y140\nX100 "
      "Y100\nX130 Y120\nM30\n");
  Trace trace = trace_of(other, 1e-3);
  std::size_t begin = 0;
  while (trace.place[0][begin] < 100) {
    ++begin;
  }
  trace = part_of(trace, begin, trace.size());
  const ProgrammedCourse course(*run.path, {true, true, true});
  const TraceOnProgram found = find_on_program(trace, course, 0.02);
  EXPECT_FALSE(found.belongs());
  EXPECT_EQ(found.pose.offset, Vec3(Vec3::Zero()));
}

TEST(Agreement, FindsMirroredAxesAndInchesOfAPartOfTheProgram) {
  const auto run = run_of(program_text);
  const Trace whole = trace_of(run, 1e-3);
  const Trace part = part_of(whole, whole.size() / 5, 4 * whole.size() / 5);
  Trace mirrored = part;
  change(mirrored, 1, -1, 0);
  const Compared turned = compare(mirrored, run);
  EXPECT_TRUE(turned.found.belongs());
  EXPECT_THAT(turned.found.remarks, has_remark("trace-mirrored", "axis Y"));
  EXPECT_LT(turned.agreement.feed_rms, 0.5);
  Trace inches = part;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    change(inches, axis, 1 / 25.4, 0);
  }
  const Compared scaled = compare(inches, run);
  EXPECT_THAT(scaled.found.remarks, has_remark("trace-inches", "in inches"));
  EXPECT_LT(scaled.agreement.feed_rms, 0.5);
}

TEST(Agreement, SaysWhereNothingWasRecordedAndComparesNoFeedThere) {
  const auto run = run_of(program_text);
  Trace trace = trace_of(run, 1e-3);
  const std::size_t at = trace.size() / 8;  // on the first line, at its feed
  const Trace rest = part_of(trace, at + 150, trace.size());
  trace = part_of(trace, 0, at);
  trace.time.insert(trace.time.end(), rest.time.begin(), rest.time.end());
  for (std::size_t axis = 0; axis < 3; ++axis) {
    trace.place[axis].insert(trace.place[axis].end(), rest.place[axis].begin(), rest.place[axis].end());
  }
  const auto [found, agreement] = compare(trace, run);
  ASSERT_EQ(found.lost.size(), 1U);
  EXPECT_THAT(found.remarks, has_remark("trace-unknown", "at line 2"));
  for (const AgreementCell& cell : agreement.cells) {
    EXPECT_FALSE(found.loses(cell.s, cell.s + cell.length));
  }
  EXPECT_NEAR(agreement.measured_time, run.trajectory->duration(), 3e-3);
}

TEST(Agreement, SaysThatAnAxisDoesNotMoveInTheTrace) {
  const auto run = run_of(program_text);
  Trace trace = trace_of(run, 1e-3);
  change(trace, 1, 0, 0);
  const ProgrammedCourse course(*run.path, {true, true, true});
  const TraceOnProgram found = find_on_program(trace, course, 0.02);
  EXPECT_THAT(found.remarks, has_remark("trace-axis-still", "axis Y does not move in the trace"));
}

TEST(Agreement, RefusesATraceOfAnotherProgram) {
  const auto run = run_of(program_text);
  const auto other = run_of("G21 G90\nG0 X200 Y200\nG1 X300 F3000\nY220\nM30\n");
  Trace trace = trace_of(other, 1e-3);
  for (auto& place : trace.place) {
    place.erase(place.begin(), place.begin() + 3000);
  }
  trace.time.resize(trace.place[0].size());
  EXPECT_THROW(compare(trace, run), InputError);
}

TEST(TraceAlignment, OfATraceWithItsOwnRunIsTheSameInstantPausesIncluded) {
  const auto run = run_of(program_text);
  Trace trace = trace_of(run, 1e-3);
  constexpr double late = 0.25;  // [s]
  for (double& time : trace.time) {
    time += late;
  }
  const auto [found, agreement] = compare(trace, run);
  const TraceAlignment alignment(found, agreement);
  for (double time = 0.05; time < run.trajectory->duration() - 0.05; time += 0.0137) {
    EXPECT_NEAR(alignment.at_time(time), time + late, 1e-3);
    EXPECT_NEAR(alignment.at_place(time), time + late, 3e-3) << time;
  }
  EXPECT_NEAR(alignment.run_time(60), alignment.at_place(alignment.run_time(60)) - late, 3e-3);
  EXPECT_NEAR(alignment.end_time(), run.trajectory->duration(), 0.01) << "but for the last micrometre";
}

TEST(TraceAlignment, EndsWithTheLastMotionOfASlowMachine) {
  const auto run = run_of(program_text);
  const auto slow = run_of(program_text, {"X.acceleration=0.2", "Y.acceleration=0.2"});
  Trace trace = trace_of(slow, 1e-3);
  constexpr int waiting = 5000;  // [ms]
  for (int i = 0; i < waiting; ++i) {
    trace.time.push_back(trace.time.back() + 1e-3);
    for (auto& place : trace.place) {
      if (!place.empty()) {
        place.push_back(place.back());
      }
    }
  }
  const auto [found, agreement] = compare(trace, run);
  const double end = TraceAlignment(found, agreement).end_time();
  EXPECT_GT(end, run.trajectory->duration());
  EXPECT_NEAR(end, slow.trajectory->duration(), 0.05) << "both begin to move together";
}

TEST(TraceAlignment, PutsASlowMachineAtTheSamePlaceAndStretchesNothingThatIsLost) {
  const auto run = run_of(program_text);
  const auto slow = run_of(program_text, {"X.acceleration=0.2", "Y.acceleration=0.2"});
  Trace trace = trace_of(slow, 1e-3);
  for (std::size_t i = 700; i < 900; ++i) {
    trace.place[1][i] += 50;
  }
  const auto [found, agreement] = compare(trace, run);
  const TraceAlignment alignment(found, agreement);
  std::size_t lost = 0;
  for (double time = 0.05; time < run.trajectory->duration() - 0.05; time += 0.002) {
    const double at = alignment.at_place(time);
    if (std::isnan(at)) {
      ++lost;
      continue;
    }
    EXPECT_TRUE(at <= 0.7 || at >= 0.899);
    const Vec3 off = slow.trajectory->state(at).position - run.trajectory->state(time).position;
    EXPECT_LT(off.norm(), 0.25) << time;
  }
  EXPECT_GT(lost, 20U);
}

TEST(CornerAgreement, HoldsTheFeedsOfBothThroughEachCorner) {
  const std::string square = "G21 G90 G64 P0.05\nG1 X30 F3000\nY30\nX0\nY0\nM30\n";
  const auto run = run_of(square);
  const auto own = compare(trace_of(run, 1e-3), run);
  ASSERT_EQ(own.agreement.corners.size(), 3U);
  EXPECT_LT(own.agreement.corner_rms(), 0.01);
  EXPECT_NEAR(own.agreement.corners[0].turn, 1.5708, 1e-3);
  EXPECT_EQ(own.agreement.corners[1].line, 3U);
  EXPECT_DOUBLE_EQ(own.agreement.corners[1].s, 60);
  const auto wide = run_of("G21 G90 G64 P0.5\nG1 X30 F3000\nY30\nX0\nY0\nM30\n");
  const auto other = compare(trace_of(wide, 1e-3), run);
  ASSERT_EQ(other.agreement.corners.size(), 3U);
  for (const CornerAgreement& corner : other.agreement.corners) {
    EXPECT_LT(corner.error(), -0.05) << "the control that rounds more is faster";
  }
}

TEST(PathMatcher, NeverGoesBackAndStaysDuringAPause) {
  const auto run = run_of(program_text);
  const ProgrammedCourse course(*run.path, {true, true, true});
  const MotionRecord record = record_of(*run.trajectory, 1e-3);
  const MatchedRecord matched = match_record(course, record, {0.3, 0});
  double before = 0;
  std::size_t still = 0;
  for (const double s : matched.s) {
    ASSERT_FALSE(std::isnan(s));
    ASSERT_GE(s, before);
    still += s == before ? 1 : 0;
    before = s;
  }
  EXPECT_GE(still, 290U);
  EXPECT_NEAR(before, course.length(), 1e-3);
}

/// Rounded to steps a motion runs beside the path, and near a sharp corner nearer to the way back.
TEST(PathMatcher, StaysOnTheWayToASharpCornerBesideThePath) {
  const auto run = run_of("G21 G90 G17\nG1 X30 Y2 F3000\nG4 P0.3\nX0 Y3\nM30\n");
  const ProgrammedCourse course(*run.path, {true, true, true});
  MotionRecord record = record_of(*run.trajectory, 4e-3);
  for (Vec3& place : record.place) {
    place.y() += 0.01;
  }
  const MatchedRecord matched = match_record(course, record, {0.3, 0});
  const double corner = std::hypot(30, 2);
  for (std::size_t i = 0; i < matched.s.size(); ++i) {
    const bool before = record.place[i].y() - 0.01 < 2 - 1e-3;
    if (before && !std::isnan(matched.s[i]) && i < matched.s.size() / 2) {
      ASSERT_LE(matched.s[i], corner + 1e-6) << i;
    }
  }
}

/// Where a line is left the way it came, noise makes the pause look like any later pass through there.
TEST(PathMatcher, StaysInANoisyPauseAtAPlaceThatIsPassedAgain) {
  const auto run = run_of(
      "G21 G90 G17\nG1 X0.6 F3000\nG4 P0.5\nG4 P0.5\nX0\nG4 P0.5\nX3\nG4 P0.5\nX0\nG4 P0.5\nX12\nM30\n");
  const ProgrammedCourse course(*run.path, {true, true, true});
  for (unsigned seed = 1; seed <= 20; ++seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> error(0, 3e-4);
    MotionRecord record = record_of(*run.trajectory, 4e-3);
    const MotionRecord clean = record;
    for (Vec3& place : record.place) {
      for (double& value : place) {
        value = 1e-3 * std::round(1e3 * (value + error(random)));
      }
    }
    const MatchedRecord matched = match_record(course, record, {0.3, noise_of(record)});
    const MatchedRecord exact = match_record(course, clean, {0.3, 0});
    for (std::size_t i = 0; i < matched.s.size() && !std::isnan(exact.s[i]); ++i) {
      ASSERT_NEAR(matched.s[i], exact.s[i], 0.01)
          << "seed " << seed << ", sample " << i << ", noise " << noise_of(record);
    }
  }
}

}  // namespace
}  // namespace feedscope
