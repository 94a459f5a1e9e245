#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "tests/app/command_line.h"

namespace feedscope::test {
namespace {

using testing::HasSubstr;

/// `render` and `report` of a session.
class SessionCommand : public CommandLine {
 protected:
  void SetUp() override {
    write("part.nc", "G21 G1 X20 F3000\nY20\nX40\n");
    write("part.feedscope", session("part.nc", ""));
  }

  static std::string session(const std::string& program, const std::string& hash) {
    return R"({"format": "feedscope-session", "version": 1,
      "program": {"file": ")" +
           program + R"(", "sha256": ")" + hash + R"("},
      "runs": [{"machine": "spinner-mvc850", "model": "essid", "name": "wide", "colour": "#0072b2",
                "set": {"contour_tolerance_mm": 0.05}},
               {"machine": "huron-kx10", "model": "msaddek", "colour": "#d55e00", "set": {}}],
      "annotations": [{"kind": "callout", "place": {"segment": 1, "share": 0}, "text": "second side"}]})";
  }
  Result quiet(const std::string& arguments) const { return run(arguments, no_display); }
};

TEST_F(SessionCommand, EveryViewIsDrawnAndTheSameElsewhere) {
  fs::create_directories(folder_ / "elsewhere");
  fs::copy(folder_ / "part.nc", folder_ / "elsewhere" / "part.nc");
  fs::copy(folder_ / "part.feedscope", folder_ / "elsewhere" / "part.feedscope");
  for (const std::string view : {"3d", "charts", "window"}) {
    const std::string options = " --view " + view + " --size 1280x800 --out ";
    const Result here = quiet("render part.feedscope" + options + "a.png");
    ASSERT_EQ(here.code, 0) << here.err;
    ASSERT_EQ(quiet("render elsewhere/part.feedscope" + options + "b.png").code, 0);
    EXPECT_TRUE(contents(folder_ / "a.png") == contents(folder_ / "b.png")) << view;
  }
}

/// The window with two views or a split one comes out as it was saved, in another folder too; what is
/// compared is seen in the picture.
TEST_F(SessionCommand, ComparedRunsAreDrawnAndTheSameElsewhere) {
  fs::create_directories(folder_ / "elsewhere");
  fs::copy(folder_ / "part.nc", folder_ / "elsewhere" / "part.nc");
  std::vector<std::string> pictures;
  for (const std::string compare : {R"({"mode": "one"})", R"({"mode": "side_by_side", "other_run": 1})",
                                    R"({"mode": "split", "split": 0.4, "reference_run": 0})"}) {
    std::string text = session("part.nc", "");
    text.insert(text.find("\"runs\""),
                "\"view\": {\"colouring\": \"time_lost\"}, \"compare\": " + compare + ",\n");
    write("part.feedscope", text);
    fs::copy(folder_ / "part.feedscope", folder_ / "elsewhere" / "part.feedscope",
             fs::copy_options::overwrite_existing);
    const std::string options = " --view window --size 1280x800 --out ";
    const Result here = quiet("render part.feedscope" + options + "a.png");
    ASSERT_EQ(here.code, 0) << here.err;
    EXPECT_EQ(here.err, "");
    ASSERT_EQ(quiet("render elsewhere/part.feedscope" + options + "b.png").code, 0);
    EXPECT_TRUE(contents(folder_ / "a.png") == contents(folder_ / "b.png")) << compare;
    pictures.push_back(contents(folder_ / "a.png"));
  }
  EXPECT_NE(pictures[0], pictures[1]);
  EXPECT_NE(pictures[0], pictures[2]);
  EXPECT_NE(pictures[1], pictures[2]);
}

TEST_F(SessionCommand, TheReportHasItsRunsByName) {
  const Result result = quiet("report part.feedscope --out r.html");
  ASSERT_EQ(result.code, 0) << result.err;
  const std::string html = contents(folder_ / "r.html");
  EXPECT_THAT(html, HasSubstr("wide"));
  EXPECT_THAT(html, HasSubstr("msaddek"));
  EXPECT_THAT(html, HasSubstr("feedscope report part.feedscope"));
}

/// A session gives every command what its program, import options and runs would give by hand.
TEST_F(SessionCommand, EveryCommandTakesOneAndDoesWhatItsOptionsWouldDo) {
  using nlohmann::json;
  std::string text = session("part.nc", "");
  text.insert(text.find("\"runs\""), R"("reading": {"unit": "inch"}, "current_run": 1, )");
  write("part.nc", "G1 X2 F30\nY2\nX4\n");
  write("part.feedscope", text);
  const std::string reading = " part.nc --unit inch ";
  const auto same = [&](const std::string& of_session, const std::string& by_hand) {
    const Result one = quiet(of_session + " --json -");
    const Result other = quiet(by_hand + " --json -");
    ASSERT_EQ(one.code, 0) << one.err;
    ASSERT_EQ(other.code, 0) << other.err;
    json a = json::parse(one.out);
    json b = json::parse(other.out);
    for (json* whole : {&a, &b}) {
      whole->erase("elapsed");
      (*whole)["program"].erase("file");
    }
    EXPECT_EQ(a, b) << of_session;
  };
  const std::string first = " --machine spinner-mvc850 --model essid --set contour_tolerance_mm=0.05";
  const std::string second = " --machine huron-kx10 --model msaddek";
  same("check part.feedscope", "check" + reading);
  same("simulate part.feedscope", "simulate" + reading + second);
  same("simulate part.feedscope --run 1", "simulate" + reading + first);
  EXPECT_THAT(quiet("simulate part.feedscope").err, HasSubstr("run 2 is simulated"));

  const json compared = json::parse(quiet("compare part.feedscope --json -").out);
  ASSERT_EQ(compared["runs"].size(), 2U);
  const auto time = [&](const std::string& options) {
    return json::parse(quiet("simulate" + reading + options + " --json -").out)["cycle_time_s"];
  };
  EXPECT_EQ(compared["runs"][0]["cycle_time_s"], time(first));
  EXPECT_EQ(compared["runs"][1]["cycle_time_s"], time(second));
  const json swept = json::parse(quiet("compare part.feedscope --sweep 'tolerance=0.01;0.02' --json -").out);
  EXPECT_EQ(swept["runs"].size(), 4U);
}

TEST_F(SessionCommand, OptionsThatItHasOfItsOwnAreRefusedByEveryCommand) {
  for (const char* command : {"simulate", "compare"}) {
    for (const char* option :
         {"--machine huron-kx10", "--model cam", "--tolerance 0.1", "--set X.jerk=3", "--unit inch",
          "--dialect iso", "--offset G55=1,2,3", "--wear-only", "--tools-unit inch", "--repeat-limit 7",
          "--call-depth 3", "--simulate-cut-off", "--skip-deleted", "--tool 1=5"}) {
      expect_wrong_use(fmt::format("{} part.feedscope {}", command, option),
                       "cannot be combined with session");
    }
  }
  expect_wrong_use("check part.feedscope --unit mm", "--unit cannot be combined with session");
  expect_wrong_use("simulate part.feedscope --run 3", "it has runs 1 to 2");
  expect_wrong_use("simulate corner.nc --run 1", "is not a session");
  expect_wrong_use("simulate part.feedscope --json part.nc", "it is the program itself");
  EXPECT_THAT(contents(folder_ / "part.nc"), HasSubstr("G1 X20"));
}

TEST_F(SessionCommand, AChangedProgramIsSaidAndTheRestGoesOn) {
  write("part.feedscope", session("part.nc", "0123"));
  const Result result = quiet("render part.feedscope --out a.png");
  EXPECT_EQ(result.code, 0);
  EXPECT_THAT(result.err, HasSubstr("has changed since session 'part.feedscope' was saved"));
}

TEST_F(SessionCommand, WhatCannotBeUsedIsNamedAndWritesNothing) {
  expect_wrong_use("render part.feedscope --model cam --out a.png",
                   "--model cannot be combined with session");
  expect_wrong_use("render part.feedscope --tool 1=5 --out a.png", "--tool cannot be combined with session");
  write("part.feedscope", session("gone.nc", ""));
  expect_wrong_use("render part.feedscope --out a.png", "gone.nc");
  std::string with_table = session("part.nc", "");
  with_table.insert(1, R"("reading": {"tool_table": "gone.tbl"},)");
  write("part.feedscope", with_table);
  expect_wrong_use("render part.feedscope --out a.png", "the tool table of session 'part.feedscope'");
  write("part.feedscope", "{\n\"format\" 1}");
  expect_wrong_use("report part.feedscope --out a.pdf", "line 2");
  EXPECT_FALSE(fs::exists(folder_ / "a.png"));
  EXPECT_FALSE(fs::exists(folder_ / "a.pdf"));
}

TEST_F(SessionCommand, ItsProgramIsNeverWrittenOver) {
  expect_wrong_use("render part.feedscope --format png --out part.nc", "it is the program itself");
  EXPECT_THAT(contents(folder_ / "part.nc"), HasSubstr("G1 X20"));
}

}  // namespace
}  // namespace feedscope::test
