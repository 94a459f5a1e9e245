#include "tests/app/command_line.h"
#include "tests/support/folders.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>
#include <sstream>

namespace feedscope::test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

/// Long enough that a signal arrives while it runs.
std::string long_program() {
  std::string text = "G1 F6000\n";
  for (int i = 0; i < 20000; ++i) {
    text += "X" + std::to_string(i % 7) + " Y" + std::to_string(i % 5) + "\n";
  }
  return text;
}

TEST_F(CommandLine, HasHelpForEveryCommand) {
  const Result all = run("--help");
  EXPECT_EQ(all.code, 0);
  for (const std::string command : {"simulate", "check", "machines", "models"}) {
    EXPECT_THAT(all.out, HasSubstr(command));
    const Result one = run(command + " --help");
    EXPECT_EQ(one.code, 0);
    EXPECT_THAT(one.out, HasSubstr("Usage: feedscope " + command));
  }
  EXPECT_THAT(run("--version").out, StartsWith("feedscope "));
}

TEST_F(CommandLine, NamesUnknownOptionAndArgument) {
  expect_wrong_use("simulate corner.nc --tolerence 0.1",
                   "unknown option '--tolerence'; did you mean '--tolerance'?");
  expect_wrong_use("simulate corner.nc --qqqqqq=1", "unknown option '--qqqqqq'; known: ");
  expect_wrong_use("simulate corner.nc wrong.nc", "unexpected argument 'wrong.nc'");
  expect_wrong_use(
      "circular --radius 30 --feed 2000 4000 6000",
      "unexpected argument '6000'; repeat an option to give it several values: --feed 2000 --feed 6000");
  expect_wrong_use("simulate", "FILE is required");
  expect_wrong_use("simulate corner.nc --csv", "--csv has no value; write --csv FILE");
  expect_wrong_use("compare corner.nc --json", "--json has no value; write --json FILE");
  expect_wrong_use("simulate corner.nc --csv ''", "--csv is empty; give a value or omit it");
  expect_wrong_use("check corner.nc --json=", "--json");
}

TEST_F(CommandLine, SimulateSumsUpForPeople) {
  const Result result = run("simulate corner.nc");
  EXPECT_EQ(result.code, 0);
  EXPECT_EQ(result.err, "");
  for (const std::string text :
       {"corner.nc on Spinner MVC 850", "model essid", "cycle time", "programmed time   0.800 s",
        "peak feed         3000.0 mm/min", "axis X", "of 15; 10 on blends", "1 corner blends",
        "Time by limiting cause", "programmed feed", "jerk of axis X"}) {
    EXPECT_THAT(result.out, HasSubstr(text));
  }
}

TEST_F(CommandLine, TheProgrammedTimeOfACycleIsTheSameInTextAndJson) {
  write("back.nc", "G21 G90 G17\nG0 Z9\nG98 G87 X10 Y0 Z-5 R-20 Q1 F100\nG80\nM30\n");
  const std::string simulate = "simulate back.nc --dialect fanuc";
  const json report = json::parse(run(simulate + " --json -").out);
  ASSERT_TRUE(report["programmed_time_s"].is_number());
  EXPECT_THAT(run(simulate).out, HasSubstr(fmt::format("programmed time   {:.3f} s",
                                                       report["programmed_time_s"].get<double>())));
}

TEST_F(CommandLine, SimulateHasNoRowForACauseWithoutATime) {
  const std::string slot = FEEDSCOPE_SOURCE_DIR "/resources/programs/trochoidal_slot.nc";
  const std::string out = run("simulate '" + slot + "' --model tapie").out;
  const std::string causes = out.substr(out.find("Time by limiting cause"));
  EXPECT_THAT(causes, HasSubstr("programmed feed"));
  EXPECT_THAT(causes, Not(HasSubstr("0.000 s")));
}

TEST_F(CommandLine, SimulateWritesJsonToStandardOutputAndNothingElse) {
  const Result result = run("simulate corner.nc --json -");
  EXPECT_EQ(result.code, 0);
  const json report = json::parse(result.out);
  EXPECT_EQ(report["program"]["blocks"], 2);
  EXPECT_EQ(report["machine"]["id"], "spinner-mvc850");
  EXPECT_EQ(report["model"]["id"], "essid");
  EXPECT_DOUBLE_EQ(report["programmed_time_s"], 0.8);
  double sum = 0;
  for (const auto& [cause, seconds] : report["time_by_cause_s"].items()) {
    sum += seconds.get<double>();
  }
  EXPECT_NEAR(sum, report["cycle_time_s"].get<double>(), 1e-12);
  double slowing = 0;
  for (const auto& [place, seconds] : report["ramp_down_by_slower_place_s"].items()) {
    slowing += seconds.get<double>();
  }
  EXPECT_NEAR(slowing, report["time_by_cause_s"]["ramp_down"].get<double>(), 1e-12);
  EXPECT_GT(report["ramp_down_by_slower_place_s"]["exact_stop"].get<double>(), 0);
}

TEST_F(CommandLine, SimulateReadsStandardInput) {
  const Result result = run("simulate - --model cam --json - < corner.nc");
  EXPECT_EQ(result.code, 0);
  EXPECT_DOUBLE_EQ(json::parse(result.out)["cycle_time_s"], 0.8);
}

TEST_F(CommandLine, SimulateWritesItsFiles) {
  const Result result = run("simulate corner.nc --csv a.csv --step 0,01 --json a.json --blends b.csv");
  EXPECT_EQ(result.code, 0);
  EXPECT_THAT(result.out, HasSubstr("cycle time"));
  const std::string csv = contents(folder_ / "a.csv");
  EXPECT_THAT(csv, AllOf(StartsWith("time_s,path_mm,line,"), HasSubstr("\n0.01,")));
  EXPECT_EQ(json::parse(contents(folder_ / "a.json"))["machine"]["id"], "spinner-mvc850");
  EXPECT_THAT(contents(folder_ / "b.csv"),
              AllOf(StartsWith("line,kind,"), HasSubstr("\n1,cubic,20,0,0,90,")));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 6) << "a temporary file was left behind";
}

TEST_F(CommandLine, SimulateListsTheWorstContourErrors) {
  const Result result = run("simulate corner.nc --contour places.csv --json a.json --tolerance 0.05");
  EXPECT_EQ(result.code, 0);
  const json report = json::parse(contents(folder_ / "a.json"));
  ASSERT_EQ(report["contour_places"].size(), 1U);
  const json& place = report["contour_places"][0];
  EXPECT_EQ(place["error_mm"], report["max_contour_error_mm"]);
  EXPECT_EQ(place["at"], "corner");
  EXPECT_NEAR(place["turn_deg"].get<double>(), 90, 1e-9);
  EXPECT_EQ(place["tolerance_mm"], 0.05);
  EXPECT_TRUE(place["inside"]);
  for (const char* kind : {"distance", "side"}) {
    const json& histogram = report["contour_histogram"][kind];
    EXPECT_EQ(histogram["edges_mm"].size(), histogram["length_mm"].size() + 1);
  }
  const std::string csv = contents(folder_ / "places.csv");
  EXPECT_THAT(csv, AllOf(StartsWith("rank,line,block,"), HasSubstr("\n1,1,"), HasSubstr(",corner,")));
  EXPECT_EQ(std::ranges::count(csv, '\n'), 2);
}

TEST_F(CommandLine, SimulateKnowsNoPlacesUnlessAsked) {
  const json report = json::parse(run("simulate corner.nc --json -").out);
  EXPECT_FALSE(report.contains("contour_places"));
  EXPECT_EQ(run("simulate corner.nc --contour-places 3").code, 2);
  EXPECT_EQ(run("simulate corner.nc --contour - --contour-places 0").code, 2);
}

TEST_F(CommandLine, SimulateTakesTheInterpolationPeriodAsStep) {
  EXPECT_THAT(run("simulate corner.nc --csv -").out, HasSubstr("\n0.001,"));
  EXPECT_THAT(run("simulate corner.nc --csv - --model cam --machine mikron-ucp710").out,
              HasSubstr("\n0.012,"));
}

TEST_F(CommandLine, SimulateChangesToleranceSettingsAndLimits) {
  const auto blends = [this](const std::string& options) {
    return run("simulate corner.nc --blends - " + options).out;
  };
  EXPECT_THAT(blends("--tolerance 0.05"), HasSubstr(",0.04,"));
  EXPECT_EQ(blends("--tolerance 0,05"), blends("--tolerance 0.05"));
  const json report =
      json::parse(run("simulate corner.nc --json - --set alpha=2 --set X.jerk=5 --set beta=1").out);
  EXPECT_EQ(report["settings"]["alpha"], 2);
  EXPECT_NEAR(report["peaks"]["axes"]["X"]["jerk_m_s3"].get<double>(), 5, 5);
  EXPECT_NEAR(report["max_corner_distance_mm"].get<double>(), 0.1, 1e-9);
}

TEST_F(CommandLine, SimulateNotesAToleranceWithoutEffect) {
  const Result result = run("simulate corner.nc --model cam --tolerance 0.1");
  EXPECT_EQ(result.code, 0);
  EXPECT_THAT(result.err, HasSubstr("model 'cam' does not use a contour tolerance"));
}

TEST_F(CommandLine, SimulateRunsEveryMachineWithEveryModel) {
  for (const std::string machine :
       {"spinner-mvc850", "mikron-ucp710", "huron-kx10", "hermle-c800u", "dmg-mori-evo40"}) {
    for (const std::string model : {"cam", "essid", "msaddek"}) {
      const Result result = run("simulate corner.nc --json - --machine " + machine + " --model " + model);
      EXPECT_EQ(result.code, 0) << result.err;
      EXPECT_GE(json::parse(result.out)["cycle_time_s"].get<double>(), 0.8 - 1e-12);
    }
  }
}

TEST_F(CommandLine, SimulateTakesAMachineFile) {
  std::string text = contents(fs::path(FEEDSCOPE_SOURCE_DIR) / "machines" / "spinner-mvc850.toml");
  write("mine.toml", text);
  EXPECT_EQ(run("simulate corner.nc --machine mine.toml").code, 0);
  const std::size_t at = text.find("velocity_m_min");
  write("mine.toml", text.replace(at, 14, "velocity_m_mim"));
  expect_wrong_use("simulate corner.nc --machine mine.toml",
                   "mine.toml:8:1: unknown key 'velocity_m_mim' in [axes.X]; did you mean 'velocity_m_min'?");
}

TEST_F(CommandLine, SimulateReportsAWrongProgramAndWritesTheRest) {
  const Result result = run("simulate wrong.nc --json -");
  EXPECT_EQ(result.code, 1);
  EXPECT_THAT(result.err, StartsWith("wrong.nc:2:1: error: "));
  const json report = json::parse(result.out);
  EXPECT_EQ(report["program"]["path_mm"], 40);
  EXPECT_EQ(report["diagnostics"][0]["line"], 2);
}

TEST_F(CommandLine, NamesAProgramThatCannotBeRead) {
  write("binary.nc", "G1" + std::string(100, '\0') + "X1");
  for (const std::string command : {"simulate", "check"}) {
    expect_wrong_use(command + " none.nc", "none.nc: does not exist");
    expect_wrong_use(command + " .", "directory");
    expect_wrong_use(command + " binary.nc", "binary.nc: is not a text file");
  }
}

TEST_F(CommandLine, ReadsAnEmptyProgramAsOneWithAnError) {
  write("empty.nc", "");
  for (const std::string command : {"simulate", "check"}) {
    const Result result = run(command + " empty.nc --json -");
    EXPECT_EQ(result.code, 1);
    EXPECT_THAT(result.err, StartsWith("empty.nc: error: "));
    EXPECT_EQ(json::parse(result.out)["program"]["segments"], 0);
  }
}

TEST_F(CommandLine, NamesAWrongSetup) {
  expect_wrong_use("simulate corner.nc --machine spiner", "did you mean 'spinner-mvc850'?");
  expect_wrong_use("simulate corner.nc --model esid", "did you mean 'essid'?");
  expect_wrong_use("simulate corner.nc --set X.jrek=1", "did you mean 'X.jerk'?");
  expect_wrong_use("simulate corner.nc --set alpha", "'alpha' has no value");
  EXPECT_THAT(run("simulate corner.nc --set foo=3").err,
              AllOf(HasSubstr("'foo' is unknown"), Not(HasSubstr("mean"))));
  expect_wrong_use("simulate corner.nc --set alpha=99", "alpha = 99 is out of bounds");
  expect_wrong_use("simulate corner.nc --set X.jerk=-1",
                   "X.jerk = -1 is out of bounds; it must be at least 0.000001 m/s3");
  expect_wrong_use("simulate corner.nc --set reading=quick",
                   "it must be one of: corrected, published, strict");
  expect_wrong_use("simulate corner.nc --tolerance wide", "--tolerance = 'wide' is not a number");
  expect_wrong_use("simulate corner.nc --tolerance -1",
                   "--tolerance = -1 is out of bounds; it must be at least 0 mm");
  expect_wrong_use("simulate corner.nc --csv a.csv --step 0",
                   "--step = 0 is out of bounds; it must be above 0 s");
  expect_wrong_use("simulate corner.nc --csv a.csv --step 1e-15", "use a larger step");
  EXPECT_FALSE(fs::exists(folder_ / "a.csv"));
}

TEST_F(CommandLine, NamesAnOutputThatCannotBeWritten) {
  expect_wrong_use("simulate corner.nc --csv none/a.csv",
                   "cannot write 'none/a.csv': No such file or directory");
  expect_wrong_use("simulate corner.nc --json .", "cannot write '.': it is a folder");
  expect_wrong_use("simulate corner.nc --json corner.nc", "it is the program itself");
  expect_wrong_use("simulate corner.nc --csv a --json ./a", "two results would be written there");
  expect_wrong_use("simulate corner.nc --csv - --json -", "two results would be written there");
  expect_wrong_use("simulate corner.nc --json /dev/full", "cannot write '/dev/full'");
  expect_wrong_use("simulate corner.nc --json - > /dev/full", "cannot write '-'");
  EXPECT_EQ(contents(folder_ / "corner.nc"), "G21 G1 X20 F3000\nY20\n");
}

TEST_F(CommandLine, KeepsAnOldFileWhenTheNewOneFails) {
  write("a.csv", "old");
  EXPECT_EQ(run("simulate corner.nc --csv a.csv --step 1e-15").code, 2);
  EXPECT_EQ(contents(folder_ / "a.csv"), "old");
}

TEST_F(CommandLine, CancelsOnSignalsAndLeavesNoFile) {
  write("long.nc", long_program());
  for (const auto& [signal, code] : {std::pair{"INT", 130}, {"HUP", 129}, {"TERM", 143}}) {
    const Result result = run("simulate long.nc --csv long.csv --step 0.00001",
                              std::string("timeout --preserve-status --signal=") + signal + " 0.7");
    EXPECT_EQ(result.code, code) << signal;
    EXPECT_FALSE(fs::exists(folder_ / "long.csv"));
    for (const auto& entry : fs::directory_iterator(folder_)) {
      EXPECT_THAT(entry.path().filename().string(), Not(HasSubstr(".part"))) << signal;
    }
  }
}

TEST_F(CommandLine, KeepsRunningWhereAHangUpIsIgnored) {
  write("long.nc", long_program());
  const Result result =
      run("simulate long.nc --csv long.csv --step 0.02",
          "timeout --preserve-status --signal=HUP 0.3 sh -c 'trap \"\" HUP; exec \"$0\" \"$@\"'");
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_TRUE(fs::exists(folder_ / "long.csv"));
}

/// What is printed and does not arrive is no success, whichever command prints it.
TEST_F(CommandLine, FailsWhereItsTextCannotBeWritten) {
  std::string trace = "time [s],x [mm],y [mm]\n";
  for (int i = 0; i < 20; ++i) {
    trace += fmt::format("{:.3f},{:.3f},0\n", 0.001 * i, 0.05 * i);
  }
  write("trace.csv", trace);
  const std::map<std::string, std::vector<std::string>> calls{
      {"simulate", {"simulate corner.nc", "simulate corner.nc --csv -"}},
      {"compare", {"compare corner.nc --model cam", "compare corner.nc --model cam --csv -"}},
      {"check", {"check corner.nc", "check corner.nc --json -"}},
      {"explain", {"explain corner.nc", "explain corner.nc --json -"}},
      {"trace", {"trace trace.csv", "trace trace.csv --json -"}},
      {"identify", {"identify --program --dialect iso"}},
      {"circular", {"circular --radius 5 --feed 500", "circular --radius 5 --feed 500 --json -"}},
      {"help", {"help", "help check"}},
      {"lessons", {"lessons", "lessons 1", "lessons 1 --out -"}},
      {"machines", {"machines", "machines huron-kx10"}},
      {"models", {"models", "models essid"}},
      {"render", {"render corner.nc --size 100x80 --out -"}},
      {"report", {"report corner.nc --out - --format html"}}};
  const std::string help = run("--help").out;
  std::istringstream lines(help.substr(help.find("Subcommands:")));
  std::vector<std::string> all{"--help", "--version"};
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line) && !line.empty()) {
    const std::string command =
        line.substr(0, line.find(' ', 2)).substr(std::min<std::size_t>(2, line.size()));
    if (!command.empty()) {
      ASSERT_TRUE(calls.contains(command)) << command << ": say how it is called";
      all.push_back(command + " --help");
      all.insert(all.end(), calls.at(command).begin(), calls.at(command).end());
    }
  }
  EXPECT_GT(all.size(), 12u);
  for (const std::string& call : all) {
    const Result result = run(call + " > /dev/full");
    EXPECT_EQ(result.code, 2) << call;
    EXPECT_THAT(result.err, HasSubstr("feedscope: cannot write '-'")) << call;
  }
}

TEST_F(CommandLine, TakesTheToleranceFromOnePlace) {
  const auto figures = [this](const std::string& options) {
    json report = json::parse(run("simulate corner.nc --json - " + options).out);
    report.erase("elapsed");
    return report;
  };
  EXPECT_EQ(figures("--set tolerance=0.05"), figures("--tolerance 0.05"));
  for (const std::string command : {"simulate", "compare"}) {
    expect_wrong_use(command + " corner.nc --tolerance 0.01 --set contour_tolerance_mm=0.05",
                     "--tolerance 0.01 and --set contour_tolerance_mm=0.05 both set the tolerance");
    expect_wrong_use(command + " corner.nc --tolerance 0.01 --set tolerance=0.05", "both set the tolerance");
    expect_wrong_use(command + " corner.nc --set tolerance=0.01 --set tolerance=0.05",
                     "both set the tolerance");
  }
}

TEST_F(CommandLine, NamesThePlaceOfAWrongModelInAMachineFile) {
  std::string text = contents(fs::path(FEEDSCOPE_SOURCE_DIR) / "machines" / "spinner-mvc850.toml");
  write("mine.toml", text.replace(text.find("\"essid\""), 7, "\"esid\""));
  for (const std::string call : {"simulate corner.nc --machine mine.toml", "machines mine.toml",
                                 "simulate corner.nc --machine mine.toml --model cam"}) {
    const Result result = run(call);
    EXPECT_EQ(result.code, 2) << call;
    EXPECT_THAT(result.err, testing::ContainsRegex("mine.toml:[0-9]+:[0-9]+: model = 'esid'.*essid")) << call;
  }
}

TEST_F(CommandLine, ListsAndShowsMachines) {
  const Result list = run("machines");
  EXPECT_EQ(list.code, 0);
  EXPECT_THAT(list.out, AllOf(HasSubstr("hermle-c800u"), HasSubstr("Heidenhain TNC 640")));
  const Result one = run("machines spinner-mvc850");
  EXPECT_EQ(one.code, 0);
  EXPECT_THAT(one.out,
              AllOf(HasSubstr("Essid 2019, table 2"), HasSubstr("assumed: "), HasSubstr("X.blend_jerk")));
  expect_wrong_use("machines hurn", "did you mean 'huron-kx10'?");
}

TEST_F(CommandLine, ListsAndShowsModels) {
  const Result list = run("models");
  EXPECT_EQ(list.code, 0);
  EXPECT_THAT(list.out, AllOf(HasSubstr("cam"), HasSubstr("essid")));
  const Result one = run("models essid");
  EXPECT_EQ(one.code, 0);
  EXPECT_THAT(one.out, AllOf(HasSubstr("alpha"), HasSubstr("corrected | published | strict"),
                             HasSubstr("Guarantees")));
  expect_wrong_use("models esid", "did you mean 'essid'?");
}

TEST_F(CommandLine, NamesADataFolderWithoutMachines) {
  const Result result = run("machines", "FEEDSCOPE_DATA=.");
  EXPECT_EQ(result.code, 2);
  EXPECT_THAT(result.err, HasSubstr("FEEDSCOPE_DATA is '.', which has no folder machines/"));
}

#ifdef FEEDSCOPE_WITH_UI
TEST_F(CommandLine, DrawsEveryViewWithoutADisplay) {
  for (const std::string view : {"3d", "charts", "window"}) {
    const Result result =
        run("render corner.nc --view " + view + " --size 900x700 --out " + view + ".png", no_display);
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(result.err, "");
    EXPECT_THAT(contents(folder_ / (view + ".png")), HasSubstr("PNG"));
  }
  expect_wrong_use("render corner.nc --view window --size 200x100 --out small.png", "at least");
  EXPECT_FALSE(fs::exists(folder_ / "small.png"));
  expect_wrong_use("render corner.nc --view 4d --out x.png", "4d");
}

TEST_F(CommandLine, WithoutADisplayTheWindowTellsHowToGetAPicture) {
  for (const std::string place : {no_display, "DISPLAY=:12345 WAYLAND_DISPLAY= QT_QPA_PLATFORM=xcb"}) {
    const Result result = run("corner.nc", place);
    EXPECT_EQ(result.code, 2) << place;
    EXPECT_THAT(result.err, HasSubstr("feedscope render FILE --view window")) << place;
  }
}

TEST_F(CommandLine, TellsWhatIsWrongWithOptionsOfTheWindow) {
  expect_wrong_use("--machine huron-kx10 simulate corner.nc", "--machine before 'simulate'");
  expect_wrong_use("corner.nc --machine huron", "did you mean 'huron-kx10'?");
  expect_wrong_use("corner.nc --machine", "--machine has no value; write --machine ID|FILE");
  expect_wrong_use("corner.nc --unit cm", "--unit");
  expect_wrong_use("corner.nc --lesson 3", "FILE excludes --lesson");
  expect_wrong_use("corner.nc --tolerance 0.1 --set tolerance=0.2", "omit one");
  expect_wrong_use("--unit inch", "give the NC program too");
  EXPECT_THAT(run("corner.nc --machine huron-kx10 --unit inch", no_display).err, HasSubstr("display"));
}

TEST_F(CommandLine, NamesAWordThatIsNeitherCommandNorFile) {
  expect_wrong_use("simulat", "unknown command 'simulat'; did you mean 'simulate'?");
  expect_wrong_use("simulat corner.nc", "unknown command 'simulat'; did you mean 'simulate'?");
  expect_wrong_use("corner.nc other.nc", "unexpected argument 'other.nc'");
}
#else
TEST_F(CommandLine, RefusesToDrawInABuildWithoutPictures) {
  for (const std::string command : {"render", "report"}) {
    expect_wrong_use(command + " corner.nc --out corner.pdf",
                     "'" + command + "' needs pictures, which this build");
  }
}
#endif

/// A tolerance of the program is the one that every output tells.
TEST_F(CommandLine, TheToleranceInForceIsToldEverywhere) {
  write("own.mpf", "G71 G90\nCYCLE832(0.02,1)\nG1 X20 F3000\nY20\n");
  const Result result = run("simulate own.mpf --json run.json");
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("0.02 mm (program)"));
  const json report = json::parse(contents(folder_ / "run.json"));
  EXPECT_EQ(report["settings"]["contour_tolerance_mm"], 0.1);
  EXPECT_EQ(report["tolerance_in_force_mm"], (json{{"min", 0.02}, {"max", 0.02}}));
  EXPECT_EQ(report["tolerance_set_by"], "program");
  const json asked = json::parse(run("simulate own.mpf --tolerance 0.1 --json -").out);
  EXPECT_EQ(asked["tolerance_in_force_mm"], (json{{"min", 0.1}, {"max", 0.1}}));
  EXPECT_EQ(asked["tolerance_set_by"], "setting");
  const json cam = json::parse(run("simulate own.mpf --model cam --json -").out);
  EXPECT_TRUE(cam["tolerance_in_force_mm"].is_null());
  EXPECT_THAT(cam["notes"].dump(), HasSubstr("Tolerances and blend distances of the program are not used"));

  const Result table = run("compare own.mpf --model essid --csv own.csv");
  EXPECT_THAT(table.out, HasSubstr("essid        0.02"));
  EXPECT_THAT(contents(folder_ / "own.csv"), HasSubstr("spinner-mvc850,essid,0.02,"));
  write("two.mpf", "G71 G90\nCYCLE832(0.02,1)\nG1 X20 F3000\nY20\nCYCLE832(0.05,1)\nX0\n");
  EXPECT_THAT(run("compare two.mpf --model essid --csv two.csv").out, HasSubstr("0.02 ... 0.05"));
  EXPECT_THAT(contents(folder_ / "two.csv"), HasSubstr("spinner-mvc850,essid,,"));
  EXPECT_THAT(contents(folder_ / "two.csv"), HasSubstr(",0.02,0.05,program,"));
  EXPECT_THAT(run("compare own.mpf --model essid --sweep 'X.jerk=10;20'").out,
              HasSubstr("tolerance 0.02 mm (program)"));
}

TEST_F(CommandLine, TheMeanFeedIsThatOfTheMotion) {
  write("pause.nc", "G21 G90 G1 X100 F3000\nG4 P1500\nX0\n");
  EXPECT_THAT(run("simulate pause.nc --model cam").out,
              AllOf(HasSubstr("cycle time        5.500 s"),
                    HasSubstr("mean feed         3000.0 mm/min with rapids, without pauses of 1.500 s")));
  EXPECT_THAT(run("simulate corner.nc --model cam").out, Not(HasSubstr("pauses")));
}

/// What the window shows below the figures.
TEST_F(CommandLine, WhatIsToBeKnownOfTheLargestValuesStandsBelowThem) {
  const auto words = [&](const std::string& arguments) {  // of a text in lines that fit
    std::istringstream text(run("simulate " + arguments).out);
    return std::accumulate(std::istream_iterator<std::string>(text), {}, std::string(),
                           [](const std::string& all, const std::string& word) { return all + word + ' '; });
  };
  const std::string jumps = "No jerk is limited: the acceleration jumps, and where blocks meet the velocity";
  EXPECT_THAT(words("corner.nc --machine grbl-router"), HasSubstr(jumps));
  EXPECT_THAT(words("corner.nc --model cam"), HasSubstr("Speed and acceleration jump"));
  EXPECT_THAT(words("corner.nc --model essid"), Not(HasSubstr("jump")));
  write("turn.mpf", "TRAORI\nG1 X0 Y0 Z0 A3=0 B3=0 C3=1 F3000\nX20 A3=1 B3=0 C3=5\n");
  const std::string turning = words("turn.mpf --machine five-axis-table-ac");
  EXPECT_THAT(turning,
              HasSubstr("Velocity, acceleration and jerk of X, Y and Z are those of the tool's tip"));
  write("index.nc", "G21 G90 G0 A30\nG1 X20 F3000\n");
  EXPECT_THAT(words("index.nc --machine spinner-mvc850"), HasSubstr("Choose a machine that has them"));
}

TEST_F(CommandLine, AProgramRunsOnAMachineWithItsControlAndOthersAreSaid) {
  write("part.h", "0 BEGIN PGM A MM\n1 L X+20 F3000\n2 L Y+20\n3 END PGM A MM\n");
  const Result fitting = run("simulate part.h --json -");
  EXPECT_EQ(json::parse(fitting.out)["machine"]["id"], "dmg-mori-evo40");
  EXPECT_EQ(fitting.err, "");
  EXPECT_EQ(json::parse(run("compare part.h --model cam --json -").out)["runs"][0]["machine"]["id"],
            "dmg-mori-evo40");
  for (const char* command : {"simulate", "compare"}) {
    const Result other = run(std::string(command) + " part.h --machine huron-kx10 --model cam");
    EXPECT_EQ(other.code, 0) << other.err;
    EXPECT_THAT(other.err, HasSubstr("written for Heidenhain, but Huron KX10 has a Siemens Sinumerik 840D"));
  }
  EXPECT_EQ(json::parse(run("simulate corner.nc --json -").out)["machine"]["id"], "spinner-mvc850");
}

TEST_F(CommandLine, TheUnitIsAskedForOrWarnedOf) {
  write("no_unit.nc", "G0 X0 Y0\nG1 X4 F80\nY3\n");
  const Result assumed = run("simulate no_unit.nc --json -");
  EXPECT_EQ(assumed.code, 0);
  EXPECT_THAT(assumed.err,
              HasSubstr("warning: the program does not define its unit; mm is used [unit-assumed]"));
  EXPECT_THAT(assumed.err, HasSubstr("4 x 3 x 0 mm cut at 80 mm/min"));
  EXPECT_EQ(json::parse(assumed.out)["program"]["unit"], (json{{"name", "mm"}, {"said_by", "nobody"}}));
  const Result inch = run("simulate no_unit.nc --unit inch --json -");
  EXPECT_EQ(inch.err, "");
  EXPECT_NEAR(json::parse(inch.out)["program"]["path_mm"].get<double>(), 7 * 25.4, 1e-9);
  EXPECT_THAT(run("check no_unit.nc --unit inch").out, HasSubstr("inch, by --unit"));
  expect_wrong_use("check no_unit.nc --unit cm", "--unit");
}

}  // namespace
}  // namespace feedscope::test
