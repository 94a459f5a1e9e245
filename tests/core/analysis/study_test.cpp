#include "core/analysis/study/study.h"

#include <gmock/gmock.h>

#include "core/analysis/study/heading.h"
#include "core/base/error.h"

namespace feedscope {
namespace {

using ::testing::AllOf;
using ::testing::DoubleEq;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

LoadedProgram program_of(const std::string& text) {
  return load_program(std::make_shared<const SourceText>("part.nc", text));
}

void expect_refused(const std::string& text, const std::vector<std::string>& parts) {
  try {
    parse_sweep(text);
    ADD_FAILURE() << text << " is taken";
  } catch (const InputError& error) {
    for (const std::string& part : parts) {
      EXPECT_THAT(error.what(), HasSubstr(part));
    }
  }
}

TEST(Sweep, HasEqualRatiosOrSteps) {
  EXPECT_THAT(parse_sweep("tolerance=0.01:0.16:log5").values, ElementsAre(0.01, 0.02, 0.04, 0.08, 0.16));
  EXPECT_TRUE(parse_sweep("tolerance=0.01:0.16:log5").logarithmic);
  EXPECT_THAT(parse_sweep("X.jerk=10:40:lin4").values, ElementsAre(10, 20, 30, 40));
  EXPECT_THAT(parse_sweep("X.jerk=40:10:lin4").values, ElementsAre(40, 30, 20, 10));
  EXPECT_THAT(parse_sweep("filters=2;3").values, ElementsAre(2, 3));
  EXPECT_THAT(parse_sweep("tolerance=0.01 0.02;0.05 ; 0.1").values, ElementsAre(0.01, 0.02, 0.05, 0.1));
  EXPECT_EQ(parse_sweep("a=1").values.size(), 1u);
  const Sweep log = parse_sweep("tolerance=0.005:0.1:log12");
  ASSERT_EQ(log.values.size(), 12u);
  EXPECT_EQ(log.values.front(), 0.005);
  EXPECT_EQ(log.values.back(), 0.1);
  for (std::size_t i = 1; i < log.values.size(); ++i) {
    EXPECT_NEAR(log.values[i] / log.values[i - 1], std::pow(20, 1.0 / 11), 2e-4);
  }
}

TEST(Sweep, SaysWhatIsWrong) {
  expect_refused("tolerance", {"'tolerance'", "KEY= is missing", "log12"});
  expect_refused("=1", {"KEY= is missing"});
  expect_refused("a=0:1:log3", {"above 0", "not 0"});
  expect_refused("a=1:1:lin3", {"from 1 to 1 is not a range"});
  expect_refused("a=1:2:lin1", {"1 values", "2 to 1000"});
  expect_refused("a=1:2:lin2.5", {"whole number"});
  expect_refused("a=1:2:lin2000", {"2000 values"});
  expect_refused("a=1:2:cub3", {"'cub3' is neither logN nor linN"});
  expect_refused("a=1:2", {"three parts, not 2"});
  expect_refused("a=1;2;1", {"1 is listed twice"});
  expect_refused("a=1;x", {"'x' is not a number"});
  expect_refused("a=", {"the value is missing"});
  expect_refused("reading=strict", {"'strict' is not a number, and only numbers can be swept"});
  expect_refused("a=1:inf:lin3", {"a=1:inf:lin3", "'inf' is not a number"});
  expect_refused("tolerance=0,05", {"'0,05' has a comma", "0.05 for one value", "\"0;05\" in quotes"});
  expect_refused("tolerance=0,005:0,1:log12", {"'0,005' has a comma", "write 0.005"});
  expect_refused("filters=2, 3", {"'2,' has a comma"});
}

TEST(Sweep, KnowsTheUnitOfItsKey) {
  EXPECT_EQ(sweep_unit("tolerance"), "mm");
  EXPECT_EQ(sweep_unit("X.jerk"), "m/s3");
  EXPECT_EQ(sweep_unit("interpolation_period_s"), "s");
  EXPECT_EQ(sweep_unit("alpha"), "");
}

StudyRequest request_of(const std::vector<std::string>& sweeps, const std::vector<std::string>& models) {
  StudyRequest request;
  request.models = models;
  for (const std::string& sweep : sweeps) {
    request.sweeps.push_back(parse_sweep(sweep));
  }
  return request;
}

TEST(StudySetups, AreAllCombinationsOfEveryModelThatKnowsTheKeys) {
  const auto setups = setups_to_study(request_of({"tolerance=0.01;0.02", "X.jerk=20;30;40"}, {}));
  const auto with_tolerance = std::ranges::count_if(
      all_models(), [](const ControlModel* m) { return sweep_keys(*m).front() == "tolerance"; });
  ASSERT_EQ(setups.size(), 6u * static_cast<std::size_t>(with_tolerance));
  EXPECT_THAT(setups[0].swept, ElementsAre(0.01, 20));
  EXPECT_THAT(setups[1].swept, ElementsAre(0.02, 20));
  EXPECT_THAT(setups[2].swept, ElementsAre(0.01, 30));
  EXPECT_EQ(setups[3].setup.settings.number("contour_tolerance_mm"), 0.02);
  EXPECT_EQ(setups[3].setup.settings.text("program_tolerance"), "off");
  EXPECT_THAT(setups[3].setup.machine.axes[0].jerk, DoubleEq(30'000));
}

TEST(StudySetups, RefuseWhatNoModelKnowsAndWhatStandsTwice) {
  const auto message = [](StudyRequest request) {
    try {
      setups_to_study(request);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_THAT(message(request_of({"X.jerck=1;2"}, {"essid"})),
              AllOf(HasSubstr("X.jerck"), HasSubstr("X.jerk")));
  EXPECT_THAT(message(request_of({"tolerance=1;2"}, {"cam"})), HasSubstr("unknown to the models cam"));
  EXPECT_THAT(message(request_of({"alpha=1;2", "alpha=3"}, {"essid"})), HasSubstr("swept twice"));
  EXPECT_THAT(message(request_of({"tolerance=0.1;20"}, {"essid"})), HasSubstr("10"));
  StudyRequest set = request_of({"alpha=1;2"}, {"essid"});
  set.assignments = {"alpha=2"};
  EXPECT_THAT(message(set), HasSubstr("both swept and set"));
  StudyRequest given = request_of({"tolerance=0.1;0.2"}, {"essid"});
  given.tolerances = {0.1};
  EXPECT_THAT(message(given), HasSubstr("omit --tolerance"));
  EXPECT_THAT(message(request_of({"alpha=1:3:lin1000", "beta=0.1:1:lin1000"}, {"essid"})),
              HasSubstr("10000"));
}

TEST(Study, FindsTheFastestWithinABound) {
  const LoadedProgram program = program_of("G1 X20 F3000\nY20\nX40\nY40\n");
  StudyRequest request = request_of({"tolerance=0.005:0.08:log5"}, {"ward"});
  request.within = 0.02;
  const Study study = run_study(program, request);
  ASSERT_EQ(study.curves().size(), 1u);
  const auto curve = study.curves()[0];
  for (std::size_t i = 1; i < curve.size(); ++i) {
    EXPECT_LT(curve[i].summary.cycle_time, curve[i - 1].summary.cycle_time);
    EXPECT_GT(curve[i].summary.max_contour_error, curve[i - 1].summary.max_contour_error);
  }
  const StudyRun* best = fastest(curve, study.within);
  ASSERT_NE(best, nullptr);
  EXPECT_LE(best->summary.max_contour_error, 0.02);
  EXPECT_GT((best + 1)->summary.max_contour_error, 0.02);
  EXPECT_EQ(fastest(curve, 1e-6), nullptr);
  EXPECT_EQ(fastest(curve, std::nullopt), &curve.back());
}

TEST(Study, MarksAllValuesThatAreEquallyFastAndNoneWhereAllAre) {
  const LoadedProgram program = program_of("G1 X20 F3000\nY20\n");
  const Study study = run_study(program, request_of({"X.velocity=1;40;50"}, {"essid"}));
  EXPECT_THAT(fastest_marks(study.runs, std::nullopt), ElementsAre(false, true, true));
  EXPECT_EQ(fastest(study.runs, std::nullopt), &study.runs[1]);
  const Study equal = run_study(program, request_of({"X.velocity=40;50"}, {"essid"}));
  EXPECT_TRUE(makes_no_difference(equal.runs, std::nullopt));
  EXPECT_THAT(fastest_marks(equal.runs, std::nullopt), ElementsAre(false, false));
}

/// As the recommendation has it.
TEST(Study, WithDrivesTheBoundIsOnTheActualContourError) {
  std::vector<StudyRun> runs(2);
  for (StudyRun& run : runs) {
    run.setup = make_setup({});
    run.summary.cutting_contour_error = 0.01;
    run.summary.actual.emplace().worst.error = 0.02;
  }
  runs[0].summary.cycle_time = 1;
  runs[1].summary.cycle_time = 2;
  runs[0].summary.actual->worst.error = 0.05;
  EXPECT_EQ(fastest(runs, std::nullopt), &runs[0]);
  EXPECT_EQ(fastest(runs, 0.03), &runs[1]);
  EXPECT_EQ(fastest(runs, 0.015), nullptr);
}

TEST(Study, RecommendsTheSmallestErrorWithinOnePercentOfTheFastest) {
  std::vector<StudyRun> runs(4);
  const std::vector<double> times{120, 100.5, 100.05, 100};
  const std::vector<double> errors{0.002, 0.01, 0.019, 0.03};
  for (std::size_t i = 0; i < runs.size(); ++i) {
    runs[i].setup = make_setup({});
    runs[i].summary.cycle_time = times[i];
    runs[i].summary.cutting_contour_error = errors[i];
  }
  EXPECT_THAT(recommended_marks(runs, std::nullopt), ElementsAre(false, true, false, false));
  EXPECT_THAT(recommended_marks(runs, 0.02), ElementsAre(false, true, false, false));
  EXPECT_THAT(recommended_marks(runs, 0.005), ElementsAre(true, false, false, false));
  EXPECT_THAT(recommended_marks(runs, 0.001), ElementsAre(false, false, false, false));
  EXPECT_EQ(recommended(runs, 0.02), &runs[1]);
  EXPECT_EQ(recommended(runs, 0.001), nullptr);
  runs[0] = runs[1];  // equal in both
  EXPECT_THAT(recommended_marks(runs, std::nullopt), ElementsAre(true, true, false, false));
}

TEST(Study, CausesAddUpToTheCycleTime) {
  const Study study = run_study(program_of("G1 X20 F3000\nY20\n"), request_of({"X.jerk=5;50"}, {"essid"}));
  for (const StudyRun& run : study.runs) {
    double sum = 0;
    for (const CauseShare& cause : limiting_causes(run.summary)) {
      EXPECT_NE(cause.cause.kind, CauseKind::ramp_down) << "that is due to the slower place";
      sum += cause.share;
    }
    EXPECT_NEAR(sum, 1, 1e-9);
  }
}

TEST(Study, IsStoppedByItsProgress) {
  Progress progress;
  progress.cancel();
  EXPECT_THROW(run_study(program_of("G1 X20 F3000\n"), request_of({"X.jerk=5;50"}, {"essid"}), &progress),
               Cancelled);
}

std::vector<std::string> titles(const std::vector<Operation>& operations) {
  std::vector<std::string> titles;
  for (const Operation& operation : operations) {
    titles.push_back(operation.title);
  }
  return titles;
}

std::vector<Operation> operations_of(const LoadedProgram& program, OperationSplit split) {
  return split_operations(*program.program, *program.toolpath, split);
}

TEST(Operations, OfToolsBeginWhereTheToolComesIn) {
  const LoadedProgram program =
      program_of("G0 X1\nT1 M6\nT2\nG1 X10 F500\nX20\nM6 (T7)\nG1 Y10\nT1\nY20\nM6\nG1 X0\n");
  const auto operations = operations_of(program, OperationSplit::tool);
  EXPECT_THAT(titles(operations), ElementsAre("start", "tool 1", "tool 2", "tool 1"));
  EXPECT_EQ(operations[1].line, 2u) << "the time of the change is that of the tool that comes in";
  EXPECT_EQ(operations[2].line, 6u);
  EXPECT_EQ(operations.back().last, program.toolpath->segments.size());
}

TEST(Operations, OfToolsWithoutM6BeginWhereTheyAreAskedFor) {
  EXPECT_THAT(titles(operations_of(program_of("T1\nG1 X1 F100\nT2\nX2\n"), OperationSplit::tool)),
              ElementsAre("tool 1", "tool 2"));
  const auto heidenhain = load_program(std::make_shared<const SourceText>(
      "part.h",
      "0 BEGIN PGM A MM\n1 TOOL CALL 5 Z S1000\n2 L X+10 R0 F500\n3 TOOL CALL 6 Z S1000\n"
      "4 L X+20\n5 END PGM A MM\n"));
  EXPECT_THAT(titles(operations_of(heidenhain, OperationSplit::tool)), ElementsAre("tool 5", "tool 6"));
}

TEST(Operations, OfCommentsHaveTheirLastHeading) {
  const LoadedProgram program = program_of(
      "(part 7)\n(by post 3)\nG21\nN10 (----)\nN20 (rough pocket)\nN30 (TOOL 1)\nN40 G1 X10 F500 (no "
      "heading)\n"
      "X20\n(finish)\nY10\nY20\n");
  const auto operations = operations_of(program, OperationSplit::comment);
  EXPECT_THAT(titles(operations), ElementsAre("rough pocket", "finish"));
  EXPECT_EQ(operations[0].line, 5u);
  EXPECT_EQ(operations[1].first, operations[0].last);
  EXPECT_THAT(titles(operations_of(program_of("G1 X1 F100\n"), OperationSplit::comment)),
              ElementsAre("start"));
}

/// A comment that only closes what is before is the heading of nothing behind it.
TEST(Operations, AreNotCalledAfterWhatEndsBeforeThem) {
  const LoadedProgram program = program_of(
      "(-- slot 1 --)\nG1 X10 F500\n(-- slot 1 END --)\n(-- slot 2 --)\nX20\n(10 mm ball end)\nY10\n"
      "(-- slot 2 end --)\nY20\n");
  EXPECT_THAT(titles(operations_of(program, OperationSplit::comment)),
              ElementsAre("slot 1", "slot 2", "10 mm ball end", "line 8"));
}

TEST(Operations, BeginAgainWhereALoopComesBackToTheirHeading) {
  const LoadedProgram program =
      program_of("#1=0\nWHILE [#1 LT 2] DO1\n(LEFT)\nG1 X10 F3000\n(RIGHT)\nX0\nY1\n#1=[#1+1]\nEND1\nM30\n");
  const auto operations = operations_of(program, OperationSplit::comment);
  EXPECT_THAT(titles(operations), ElementsAre("LEFT", "RIGHT", "LEFT", "RIGHT"));
  EXPECT_EQ(operations[2].line, operations[0].line);
}

TEST(Operations, KnowTheHeadingsOfTheDialects) {
  EXPECT_EQ(operation_heading("; Schruppen"), "Schruppen");
  EXPECT_EQ(operation_heading("12 * - Taschen"), "Taschen");
  EXPECT_EQ(operation_heading("N5 MSG(\"ROUGH\")"), "ROUGH");
  EXPECT_EQ(operation_heading("  /N7 (a b) "), "a b");
  EXPECT_EQ(operation_heading("(MSG,change the tool, then go on)"), "change the tool, then go on");
  EXPECT_EQ(operation_heading("(debug, x is #1)"), "x is #1");
  EXPECT_EQ(operation_heading("(pocket, message)"), "pocket, message");
  EXPECT_EQ(operation_heading("(======)"), "");
  EXPECT_EQ(operation_heading("(--- Operation   1)"), "Operation 1");
  EXPECT_EQ(operation_heading("(*** side -X ***)"), "side -X");
  EXPECT_EQ(operation_heading("(- #1 pocket -)"), "#1 pocket");
  EXPECT_EQ(operation_heading("(-X side)"), "-X side");
  EXPECT_FALSE(operation_heading("(a) G1 X1"));
  EXPECT_FALSE(operation_heading("(a) (b)"));
  EXPECT_FALSE(operation_heading("G1 X1 (a)"));
  EXPECT_FALSE(operation_heading(""));
  EXPECT_FALSE(operation_heading("("));
}

/// LinuxCNC rounds corners between rapids, too.
TEST(Operations, KnowTheContourErrorOfTheirFeedMotions) {
  const LoadedProgram program =
      program_of("G64 P1\n(air)\nG0 X50\nY50\n(part)\nG0 X0\nY0\nG64 P0.01\nG1 X40 F3000\nY40\nX0\n");
  StudyRequest request = request_of({"X.velocity=30"}, {"linuxcnc"});
  request.split = OperationSplit::comment;
  const Study study = run_study(program, request);
  ASSERT_EQ(study.runs.size(), 1U);
  const std::vector<OperationFigures>& operations = study.runs[0].operations;
  ASSERT_EQ(operations.size(), 2U);
  EXPECT_GT(operations[0].contour_error, 0.05);
  EXPECT_EQ(operations[0].cutting_contour_error, 0);
  EXPECT_GT(operations[1].contour_error, 0.05);
  EXPECT_GT(operations[1].cutting_contour_error, 0.001);
  EXPECT_LE(operations[1].cutting_contour_error, 0.01 + 1e-9);
  EXPECT_EQ(operations[1].cutting_contour_error, study.runs[0].summary.cutting_contour_error);
}

TEST(Operations, AddUpToTheRun) {
  const LoadedProgram program =
      program_of("G0 Z5\n(one)\nG1 X20 F3000\nY20\nX0\n(two)\nG0 Z9\nG1 X9 Y9 F6000\nX0 Y0\nG4 P1\n");
  StudyRequest request = request_of({"tolerance=0.05;0.1"}, {"essid", "ward", "msaddek"});
  request.split = OperationSplit::comment;
  const Study study = run_study(program, request);
  ASSERT_EQ(study.operations.size(), 3u);
  for (const StudyRun& run : study.runs) {
    double time = 0;
    double error = 0;
    double cutting = 0;
    for (const OperationFigures& operation : run.operations) {
      time += operation.time;
      error = std::max(error, operation.contour_error);
      cutting = std::max(cutting, operation.cutting_contour_error);
      EXPECT_LE(operation.cause_time, operation.time);
      EXPECT_LE(operation.cutting_time, operation.time);
    }
    EXPECT_NEAR(time, run.summary.cycle_time, 1e-9 * time);
    EXPECT_NEAR(error, run.summary.max_contour_error, 2e-6);
    EXPECT_NEAR(cutting, run.summary.cutting_contour_error, 2e-6);
    EXPECT_EQ(run.operations[0].cutting_length, 0) << "a rapid does not cut";
    EXPECT_NEAR(run.operations[1].cutting_length, 60, 0.5);
    EXPECT_GT(run.operations[1].mean_feed(), 0);
    EXPECT_LT(run.operations[1].mean_feed(), 50.001);
  }
}

}  // namespace
}  // namespace feedscope
