#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/models/control_model.h"
#include "tests/app/command_line.h"
#ifdef FEEDSCOPE_WITH_UI
#include "ui/scene/picture.h"
#endif

namespace feedscope::test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class CompareCommand : public CommandLine {
 protected:
  json runs_of(const std::string& arguments) const {
    return json::parse(run("compare " + arguments + " --json -").out)["runs"];
  }
};

TEST_F(CompareCommand, SumsUpForPeople) {
  const Result result =
      run("compare corner.nc --model cam --model msaddek --tolerance 0.01 --tolerance 0,05");
  EXPECT_EQ(result.code, 0);
  EXPECT_EQ(result.err, "");
  for (const std::string text :
       {"corner.nc, path 40.000 mm", "Spinner MVC 850 (spinner-mvc850)", "x programmed", " 1.000",
        "msaddek        0.01", "msaddek        0.05", "Largest values", "Time by limiting cause",
        "cam               -   100 % programmed feed"}) {
    EXPECT_THAT(result.out, HasSubstr(text));
  }
}

TEST_F(CompareCommand, SaysFirstWhichRunToTake) {
  std::string zigzag = "G21 G1 X0 Y0 F3000\n";
  for (int i = 1; i <= 20; ++i) {
    zigzag += fmt::format("X{} Y{}\n", i, i % 2 == 0 ? 0 : 0.5);
  }
  write("corners.nc", zigzag);
  const std::string arguments =
      "compare corners.nc --model essid --tolerance 0.01 --tolerance 0.05 --tolerance 0.2";
  const json written = json::parse(run(arguments + " --json -").out);
  const json& taken = written["recommendation"];
  ASSERT_EQ(taken["run"], 2);
  EXPECT_EQ(taken["reason"], "fastest");
  EXPECT_EQ(taken["against"], 0);
  const auto time = [&](std::size_t i) { return written["runs"][i]["cycle_time_s"].get<double>(); };
  EXPECT_NEAR(taken["gain_s"].get<double>(), time(0) - time(2), 1e-9);
  EXPECT_NEAR(taken["gain_percent"].get<double>(), 100 * (time(0) - time(2)) / time(0), 1e-9);
  EXPECT_EQ(taken["max_contour_error_mm"], written["runs"][2]["max_contour_error_cutting_mm"]);
  EXPECT_THAT(run(arguments).out,
              AllOf(StartsWith("0.2 mm: "), HasSubstr(" less than 0.01 mm, contour error ")));
  const std::string within = run(arguments + " --within 0.05").out;
  EXPECT_THAT(within, StartsWith("0.05 mm: "));
  EXPECT_THAT(run(arguments + " --within 0.0001").out, StartsWith("No run keeps a contour error of 0.1 um."));
}

TEST_F(CompareCommand, ChoosesBetweenSettingsOfTheControlThatTheMachineHas) {
  const json taken = json::parse(run("compare corner.nc --tolerance 0.01 --tolerance 0.2 --json -").out);
  const json& run_taken = taken["runs"][taken["recommendation"]["run"].get<std::size_t>()];
  EXPECT_EQ(run_taken["model"]["id"], "essid") << "of the Spinner";
  EXPECT_EQ(json::parse(run("compare corner.nc --model cam --model tapie --json -").out)["recommendation"],
            nullptr);
}

TEST_F(CompareCommand, RefusesASessionBesideAnotherProgram) {
  write("a.feedscope", "{}");
  expect_wrong_use("compare a.feedscope corner.nc", "'a.feedscope' is a session");
  expect_wrong_use("compare corner.nc a.feedscope", "'a.feedscope' is a session");
}

TEST_F(CompareCommand, FitsInto120ColumnsWithEveryModelAndTwoTolerances) {
  std::istringstream text(run("compare corner.nc --tolerance 0.0025 --tolerance 0.125 --machine huron-kx10 "
                              "--machine mikron-ucp710")
                              .out);
  std::size_t lines = 0;
  for (std::string line; std::getline(text, line); ++lines) {
    EXPECT_LE(line.size(), 120U) << line;
  }
  EXPECT_GT(lines, 3 * 2 * all_models().size());
}

TEST_F(CompareCommand, ShowsNoShareOfAnEmptyProgram) {
  write("empty.nc", "");
  const Result result = run("compare empty.nc");
  EXPECT_EQ(result.code, 1);
  EXPECT_THAT(result.out, AllOf(HasSubstr("0:00:00"), Not(HasSubstr("nan")), Not(HasSubstr("inf"))));
}

/// grbl wants a feed before the first motion; other models run the axes as fast as they can.
TEST_F(CompareCommand, SaysThatAControlRefusesTheProgramInsteadOfATime) {
  write("no_feed.nc", "G21 G90\nG1 X10\nG1 Y10\n");
  const std::string arguments = "compare no_feed.nc --machine grbl-router --model grbl --model cam";
  const Result result = run(arguments + " --json part.json --csv part.csv");
  EXPECT_THAT(result.out, AllOf(HasSubstr("grbl            -      refused         -"),
                                HasSubstr("refused by the control: none of its feed motions is run"),
                                HasSubstr("cam             -        0.240"), Not(HasSubstr(" 0.000 "))));
  const json runs = json::parse(contents(folder_ / "part.json"))["runs"];
  for (const char* key : {"cycle_time_s", "programmed_time_s", "against_cam", "mean_feed_mm_min",
                          "max_contour_error_mm", "max_corner_distance_mm"}) {
    EXPECT_TRUE(runs[0][key].is_null()) << key;
    EXPECT_TRUE(runs[1][key].is_number()) << key;
  }
  EXPECT_THAT(runs[0]["notes"].dump(), HasSubstr("refused by the control"));
  EXPECT_THAT(contents(folder_ / "part.csv"), HasSubstr("grbl-router,grbl,,,,,,,,,"));

  EXPECT_THAT(run(arguments + " --within 0.1").out, HasSubstr("Fastest within 0.1 mm: cam on"));
  const std::string swept =
      "compare no_feed.nc --machine grbl-router --model grbl --sweep "
      "'junction_deviation_mm=0.01;0.02' --within 0.1";
  EXPECT_THAT(run(swept).out, AllOf(HasSubstr("The control refuses the program"), Not(HasSubstr("*"))));
  EXPECT_THAT(run("compare no_feed.nc corner.nc --machine grbl-router").out,
              AllOf(HasSubstr("The control refuses no_feed.nc"), Not(HasSubstr("instead of 0.000 s"))));

  run("compare corner.nc --machine grbl-router --model grbl --model cam --json other.json");
  const Result merged = run("compare --merge part.json other.json --within 1 --json merged.json");
  EXPECT_EQ(merged.code, 0) << merged.err;
  EXPECT_THAT(merged.out, HasSubstr("refused"));
  const json sums = json::parse(contents(folder_ / "merged.json"))["sums"];
  EXPECT_EQ(sums[0]["model"], "grbl");
  EXPECT_EQ(sums[0]["programs"], 1);
  EXPECT_EQ(sums[1]["fastest"], true) << "only the model that runs both can be the fastest of all";
}

/// Rapids and dwells that are left of it take time, but nothing is made.
TEST_F(CompareCommand, AControlThatRunsNoFeedMotionRefusesTheProgram) {
  write("dwell.nc", "G21 G90\nG4 P2\nG1 X10\nG1 Y10\n");
  write("rapid.nc", "G21 G90\nG0 X10\nG1 X100\nG1 Y100\nG1 X0\nG1 Y0\n");
  for (const std::string program : {"dwell.nc", "rapid.nc"}) {
    const std::string arguments = "compare " + program + " --machine grbl-router --model grbl --model cam";
    EXPECT_THAT(run(arguments).out, HasSubstr("grbl            -      refused         -")) << program;
    EXPECT_THAT(run(arguments + " --within 0.1").out, HasSubstr("Fastest within 0.1 mm: cam on")) << program;
  }
}

/// What is not run takes no time.
TEST_F(CompareCommand, ARunOfAPartIsNotTheFastestOfTheWhole) {
  write("part.nc", "G21 G90\nG1 X10 F1000\nM6\nG1 X200 H1\nX10\n");
  const std::string arguments = "compare part.nc --machine grbl-router --within 1 --model grbl";
  EXPECT_THAT(run(arguments).out, AllOf(Not(HasSubstr("Fastest")), HasSubstr("they are not run."),
                                        ContainsRegex("grbl +- +[0-9.]+ +[0-9:.]+ +- ")))
      << "no ratio of a part to the whole";
  run("compare part.nc --machine grbl-router --model grbl --model cam --json part.json");
  const json runs = json::parse(contents(folder_ / "part.json"))["runs"];
  EXPECT_GT(runs[0]["lines_not_run"], 0);
  EXPECT_EQ(runs[1]["lines_not_run"], 0);
  run("compare corner.nc --machine grbl-router --model grbl --model cam --json other.json");
  run("compare --merge part.json other.json --within 1 --json merged.json");
  const json merged = json::parse(contents(folder_ / "merged.json"));
  EXPECT_EQ(merged["programs"][0]["runs"][0]["fastest"], false);
  EXPECT_EQ(merged["programs"][0]["runs"][1]["fastest"], true);
  EXPECT_EQ(merged["sums"][1]["fastest"], true);
}

TEST_F(CompareCommand, ExplainSaysWhatIsRefusedBeforeItsTimes) {
  write("rapid.nc", "G21 G90\nG0 X10\nG1 X100\n");
  const std::string machine = " --machine grbl-router --model grbl";
  EXPECT_THAT(run("explain rapid.nc" + machine).out,
              AllOf(HasSubstr("No feed motion is run"), HasSubstr("1 line of the program is refused"),
                    Not(HasSubstr("None of the changes"))));
  write("part.nc", "G21 G90\nG1 X10 F1000\nG1 X200 H1\nX10\n");
  std::string out = run("explain part.nc" + machine).out;
  std::ranges::replace(out, '\n', ' ');  // its lines are wrapped
  EXPECT_THAT(out, HasSubstr("1 line of the program is refused"));
}

/// Klipper needs a command on every line: a long program that leaves it out is refused line by line.
TEST_F(CompareCommand, RefusalsOfALongProgramFitOnAScreen) {
  std::string text = "G21 G90\nG1 X0 Y0 F1000\n";
  for (int i = 1; i <= 20000; ++i) {
    text += "X" + std::to_string(i % 500) + "." + std::to_string(i) + "\nY0\n";
  }
  write("modal.nc", text);
  const Result klipper = run("simulate modal.nc --machine huron-kx10 --model klipper --json modal.json");
  EXPECT_LT(klipper.err.size(), 4000U);
  EXPECT_THAT(
      klipper.err,
      AllOf(HasSubstr("40000 lines of the program are refused"),
            HasSubstr("(unknown command X1.1); it is not run"), HasSubstr("(unknown command Y0)"),
            HasSubstr("; 19989 more up to line 40002"), HasSubstr("19991 more of this kind up to line")));
  const json report = json::parse(contents(folder_ / "modal.json"));
  EXPECT_EQ(std::ranges::count(report["diagnostics"], "refused", [](const json& one) { return one["code"]; }),
            40000)
      << "files list them all";
}

TEST_F(CompareCommand, ExplainHasNoNumbersOfARefusedProgramInJsonEither) {
  write("rapid.nc", "G21 G90\nG0 X10\nG1 X100\n");
  const json report = json::parse(run("explain rapid.nc --machine grbl-router --model grbl --json -").out);
  for (const std::string key :
       {"cycle_time_s", "lost_s", "saved_by_path_s", "slow_other_s", "operations_by", "changes_together"}) {
    EXPECT_TRUE(report[key].is_null()) << key;
  }
  for (const std::string key : {"time_by_kind", "causes", "operations", "slow_groups", "changes"}) {
    EXPECT_EQ(report[key], json::array()) << key;
  }
  EXPECT_EQ(report["lines_not_run"], 1);
  EXPECT_THAT(report["notes"].dump(), HasSubstr("1 line of the program is refused"));
}

TEST_F(CompareCommand, WritesItsFiles) {
  EXPECT_EQ(
      run("compare wrong.nc --machine huron-kx10 --machine spinner-mvc850 --csv a.csv --json a.json").code,
      1);
  const json runs = json::parse(contents(folder_ / "a.json"))["runs"];
  ASSERT_GE(runs.size(), 6U);
  EXPECT_EQ(runs[0]["machine"]["id"], "huron-kx10");
  EXPECT_EQ(runs[0]["model"]["id"], "cam");
  const std::string csv = contents(folder_ / "a.csv");
  EXPECT_THAT(csv, StartsWith("machine,model,tolerance_mm,cycle_time_s,"));
  EXPECT_EQ(static_cast<std::size_t>(std::count(csv.begin(), csv.end(), '\n')), runs.size() + 1);
}

TEST_F(CompareCommand, GivesTheSameFiguresAsSimulate) {
  const json compared = runs_of("corner.nc --model essid")[0];
  const json alone = json::parse(run("simulate corner.nc --model essid --json -").out);
  for (const char* key : {"machine", "model", "settings", "cycle_time_s", "peaks", "time_by_cause_s"}) {
    EXPECT_EQ(compared[key], alone[key]) << key;
  }
}

TEST_F(CompareCommand, SetsWhatEachModelKnows) {
  const json runs = runs_of("corner.nc --model cam --model essid --set alpha=2 --set X.jerk=5");
  ASSERT_EQ(runs.size(), 2U);
  EXPECT_FALSE(runs[0]["settings"].contains("alpha"));
  EXPECT_EQ(runs[1]["settings"]["alpha"], 2);
  for (const json& run : runs) {
    EXPECT_DOUBLE_EQ(run["limits"]["axes"]["X"]["jerk_m_s3"], 5);
  }
  EXPECT_THAT(run("compare corner.nc --model essid --set alpha=2 --set X.jerk=5").out,
              StartsWith("corner.nc, path 40.000 mm, with alpha=2 X.jerk=5\n"));
}

TEST_F(CompareCommand, NamesWhatItDoesNotKnow) {
  expect_wrong_use("compare corner.nc --model cam --model esid", "did you mean 'essid'?");
  expect_wrong_use("compare corner.nc --tolerance wide", "--tolerance");
  expect_wrong_use("compare corner.nc --model cam --model essid --set alhpa=2",
                   "'alhpa' is unknown to the models cam, essid; did you mean 'alpha'?");
  expect_wrong_use("compare corner.nc --model cam --set alpha=2", "'alpha' is unknown to the models cam;");
  expect_wrong_use("compare corner.nc --set alpha=99", "alpha = 99 is out of bounds");
  expect_wrong_use("compare corner.nc --set alpha", "'alpha' has no value");
}

TEST_F(CompareCommand, NamesAnOutputThatCannotBeWritten) {
  expect_wrong_use("compare corner.nc --csv none/a.csv", "cannot write 'none/a.csv'");
  expect_wrong_use("compare corner.nc --csv a --json ./a", "two results would be written there");
}

#ifdef FEEDSCOPE_WITH_UI
TEST_F(CompareCommand, DrawsABarForEachRunWithoutADisplay) {
  const auto height = [&](const std::string& arguments) {
    const Result result = run("compare corner.nc --png a.png " + arguments, no_display);
    EXPECT_EQ(result.code, 0);
    EXPECT_EQ(result.err, "");
    EXPECT_THAT(result.out, HasSubstr("cycle time"));
    const auto picture = ui::read_png((folder_ / "a.png").string());
    EXPECT_EQ(picture.size.width, 1280);
    return picture.size.height;
  };
  EXPECT_GT(height("--model essid --tolerance 0.01 --tolerance 0.02"), height("--model essid"));
}

TEST_F(CompareCommand, DrawsInTheSizeAskedForAndToStandardOutput) {
  const Result result = run("compare corner.nc --model cam --size 800x400 --png - > a.png", no_display);
  EXPECT_EQ(result.code, 0) << result.err;
  const auto picture = ui::read_png((folder_ / "a.png").string());
  EXPECT_EQ(picture.size.width, 800);
  EXPECT_EQ(picture.size.height, 400);
}

TEST_F(CompareCommand, RefusesAPictureThatCannotBeDrawnBeforeItSimulates) {
  expect_wrong_use("compare corner.nc --png a.png --size 800", "--size '800' is not a size");
  expect_wrong_use("compare corner.nc --png a.png --size 20x600", "64 to 8192");
  expect_wrong_use("compare corner.nc --png a.png --size 1280x100",
                   "1280 x 100 pixels is too small; it needs at least 640 x ");
  expect_wrong_use("compare corner.nc --png a.png --size 320x900", "it needs at least 640 x ");
  expect_wrong_use("compare corner.nc --size 800x600", "--png");
  std::string tolerances;
  for (int i = 1; i <= 500; ++i) {
    tolerances += " --tolerance " + std::to_string(0.001 * i);
  }
  expect_wrong_use("compare corner.nc --model essid --png a.png" + tolerances,
                   "500 runs are too many for one picture");
  EXPECT_FALSE(fs::exists(folder_ / "a.png"));
}

TEST_F(CompareCommand, NamesAPictureThatCannotBeWritten) {
  expect_wrong_use("compare corner.nc --png none/a.png", "cannot write 'none/a.png'");
  expect_wrong_use("compare corner.nc --png .", "cannot write '.': it is a folder");
  expect_wrong_use("compare corner.nc --png corner.nc", "it is the program itself");
  expect_wrong_use("compare corner.nc --png a --csv ./a", "two results would be written there");
  expect_wrong_use("compare corner.nc --png - --json -", "two results would be written there");
  write("old.png", "old");
  expect_wrong_use("compare corner.nc --png old.png --size 64x64", "too small");
  EXPECT_EQ(contents(folder_ / "old.png"), "old");
}
#else
TEST_F(CompareCommand, HasNoPictureWhereNoneCanBeDrawn) {
  expect_wrong_use("compare corner.nc --png a.png", "unknown option '--png'");
}
#endif

TEST_F(CompareCommand, SaysWhereTwoVersionsOfAProgramDiffer) {
  write("old.nc", "G21 G1 X20 F3000\nY20\nX40\n");
  write("new.nc", "G21 G1 X20 F3000\nX40 Y20\n");
  const Result text = run("compare old.nc new.nc");
  EXPECT_EQ(text.code, 0) << text.err;
  EXPECT_THAT(text.out, HasSubstr("new.nc instead of old.nc"));
  const Result same = run("compare old.nc old.nc");
  EXPECT_THAT(same.out, AllOf(HasSubstr(" 0.000 s"), Not(HasSubstr("+0.000")), Not(HasSubstr("-0.000"))));
  EXPECT_THAT(text.out, HasSubstr("2-3"));
  const Result json = run("compare old.nc new.nc --model cam --json -");
  const auto written = nlohmann::json::parse(json.out);
  EXPECT_EQ(written["model"], "cam");
  EXPECT_NEAR(written["gained_s"].get<double>(), (40 - std::hypot(20.0, 20.0)) / 50, 1e-9);
  EXPECT_NEAR(written["same_share"].get<double>(), 20 / (20 + std::hypot(20.0, 20.0)), 1e-9);
  expect_wrong_use("compare old.nc new.nc --machine spinner-mvc850 --machine huron-kx10",
                   "give --machine once, not 2 times");
  expect_wrong_use("compare old.nc new.nc --csv a.csv", "--csv has no effect on two programs");
  expect_wrong_use("compare old.nc missing.nc", "missing.nc");
  expect_wrong_use("compare old.nc new.nc --json new.nc", "it is the program itself");
}

TEST_F(CompareCommand, CancelsOnInterruptAndLeavesNoFile) {
  std::string text = "G1 F6000\n";
  for (int i = 0; i < 200000; ++i) {
    text += "X" + std::to_string(i % 7) + " Y" + std::to_string(i % 5) + "\n";
  }
  write("long.nc", text);
  const Result result = run("compare long.nc --csv long.csv", "timeout --preserve-status --signal=INT 0.7");
  EXPECT_EQ(result.code, 130);
  EXPECT_EQ(result.out, "");
  EXPECT_FALSE(fs::exists(folder_ / "long.csv"));
}

}  // namespace
}  // namespace feedscope::test
