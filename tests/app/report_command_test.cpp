#include <regex>
#include <sstream>

#include "tests/app/command_line.h"
#include "tests/support/folders.h"

namespace feedscope::test {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;
using testing::UnorderedElementsAreArray;

class ReportCommand : public CommandLine {
 protected:
  Result report(const std::string& arguments) const { return run("report " + arguments, no_display); }
  std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_)) {
      names.push_back(entry.path().filename().string());
    }
    return names;
  }
};

TEST_F(ReportCommand, WritesPdfAndHtmlOfSeveralRuns) {
  const Result pdf = report("corner.nc --tolerance 0.01 --tolerance 0.05 --title Corner --out r.pdf");
  EXPECT_EQ(pdf.code, 0) << pdf.err;
  EXPECT_EQ(pdf.err, "");
  EXPECT_THAT(contents(folder_ / "r.pdf"), StartsWith("%PDF-"));
  EXPECT_EQ(report("corner.nc --tolerance 0.01 --tolerance 0.05 --title Corner --out r.html").code, 0);
  const std::string html = contents(folder_ / "r.html");
  EXPECT_THAT(html, HasSubstr("<title>Corner</title>"));
  EXPECT_THAT(html, HasSubstr(">0.05 mm<"));
  EXPECT_THAT(html, HasSubstr("feedscope report corner.nc --tolerance 0.01 --tolerance 0.05 --title Corner "
                              "--out r.html"));
  EXPECT_THAT(html, HasSubstr("feedscope simulate corner.nc --machine spinner-mvc850 --model essid "
                              "--tolerance 0.05"));
  EXPECT_THAT(html, Not(HasSubstr("<h2>Control models</h2>")));
}

TEST_F(ReportCommand, TheCommandThatMakesItAgainHasItsUnits) {
  ASSERT_EQ(report("corner.nc --display-units inch --out r.html").code, 0);
  EXPECT_THAT(contents(folder_ / "r.html"),
              HasSubstr("feedscope report corner.nc --display-units inch --out r.html"));
  ASSERT_EQ(report("corner.nc --display-units metric --out r.html").code, 0);
  EXPECT_THAT(contents(folder_ / "r.html"), HasSubstr("feedscope report corner.nc --out r.html"));
}

TEST_F(ReportCommand, LeavesNothingHalfWrittenOnAFullDisk) {
  // No file may grow beyond a block of 512 bytes, as if the disk were full there.
  const std::string full = "trap '' XFSZ; ulimit -f 1; ";
  ASSERT_EQ(run("--version").code, 0);  // leaves the file of what is said
  for (const std::string call :
       {"simulate corner.nc --csv full", "simulate corner.nc --json full", "compare corner.nc --csv full",
        "compare corner.nc --png full", "render corner.nc --view 3d --format png --out full",
        "render corner.nc --view charts --format svg --out full",
        "render corner.nc --view sheet --format pdf --out full", "report corner.nc --format pdf --out full",
        "report corner.nc --format html --out full", "lessons 1 --out full.html",
        "lessons 1 --out full.pdf"}) {
    const std::vector<std::string> before = files();
    const Result result = run(call, full + no_display);
    EXPECT_EQ(result.code, 2) << call;
    EXPECT_THAT(result.err, HasSubstr("cannot write 'full")) << call;
    EXPECT_THAT(files(), UnorderedElementsAreArray(before)) << call;
  }
}

TEST_F(ReportCommand, TheSameCallGivesTheSameBytes) {
  for (const std::string out : {"r.pdf", "r.html"}) {
    ASSERT_EQ(report("corner.nc --out " + out).code, 0);
    const std::string first = contents(folder_ / out);
    ASSERT_EQ(report("corner.nc --out " + out).code, 0);
    EXPECT_TRUE(contents(folder_ / out) == first) << out;
  }
}

TEST_F(ReportCommand, TheDesktopsLanguageChangesNoByte) {
  for (const std::string of : {"report corner.nc --brief --tolerance 0.1 --tolerance 0.02 --out ",
                               "render corner.nc --view sheet --out "}) {
    const std::string out = of.starts_with("report") ? "of.html" : "of.svg";
    EXPECT_EQ(run(of + out, no_display).code, 0);
    const std::string plain = contents(folder_ / out);
    EXPECT_EQ(run(of + out, std::string(no_display) + " LC_ALL=de_DE.UTF-8").code, 0);
    EXPECT_TRUE(plain == contents(folder_ / out)) << of;
  }
}

TEST_F(ReportCommand, CommandsOfAReportRun) {
  write("it's a part.nc", "G1 X20 F3000\nY20\n");
  ASSERT_EQ(report("\"it's a part.nc\" --set alpha=2 --out r.html").code, 0);
  EXPECT_THAT(contents(folder_ / "r.html"), HasSubstr("feedscope simulate 'it'\\''s a part.nc' --machine"));
}

TEST_F(ReportCommand, ItsCommandReadsTheProgramInTheSameWay) {
  const std::vector<std::string> reading{"--dialect fanuc",         "--unit inch",    "--skip-deleted",
                                         "--repeat-limit 700",      "--call-depth 3", "--tool 1=5",
                                         "--offset G55=100,-2.5,0", "--wear-only",    "--tools-unit inch",
                                         "--simulate-cut-off"};
  std::string options;
  for (const std::string& option : reading) {
    options += " " + option;
  }
  const Result result = report("corner.nc" + options + " --out r.html");
  ASSERT_EQ(result.code, 0) << result.err;
  const std::string html = contents(folder_ / "r.html");
  for (const std::string& option : reading) {
    EXPECT_THAT(html, HasSubstr(option));
  }
}

TEST_F(ReportCommand, SaysWhatTheCycleTimeDoesNotContain) {
  write("tools.nc", "G21 G90 G17\nT1 M6\nG1 X20 Y0 Z0 F3000\nT2 M6\nM3 S100\nG28 G91 Z0\nG90 G0 X0 Y0\nZ5\n");
  const std::string call = "tools.nc --dialect fanuc --machine spinner-mvc850 --out r.html ";
  ASSERT_EQ(report(call).code, 0);
  EXPECT_THAT(contents(folder_ / "r.html"), HasSubstr("2 tool changes, 1 spindle start, 3 moves to or from"));
  const std::string zero = "--set part_zero_x_mm=0 --set part_zero_y_mm=0 --set part_zero_z_mm=0 ";
  ASSERT_EQ(report(call + zero + "--set tool_change_time_s=4 --set home_z_mm=300 --with all").code, 0);
  EXPECT_THAT(contents(folder_ / "r.html"), HasSubstr("1 spindle start"));
  EXPECT_THAT(contents(folder_ / "r.html"), Not(HasSubstr("moves to or from")));
  EXPECT_THAT(contents(folder_ / "r.html"), HasSubstr("tool change"));
}

/// What stands between `begin` and `end` is taken out, with both.
std::string without(std::string text, const std::string& begin, const std::string& end) {
  for (std::size_t at = text.find(begin); at != std::string::npos; at = text.find(begin, at)) {
    const std::size_t until = text.find(end, at);
    text.replace(at, until == std::string::npos ? until : until + end.size() - at, " ");
  }
  return text;
}

/// What a reader sees of an HTML report, without the papers that models come from.
std::string words_of(std::string html) {
  html = without(std::move(html), "<script", "</script>");
  html = without(std::move(html), "<style>", "</style>");
  html = without(std::move(html), "<span class=\"source\">", "</span>");
  return without(std::move(html), "<", ">");
}

TEST_F(ReportCommand, SpeaksFrenchThroughout) {
  const std::string samples = FEEDSCOPE_SOURCE_DIR "/resources/";
  const std::regex english(
      "\\b(the|of|and|is|are|with|at|from|in|by|to|line|lines|feed|time|none|axis|corner|block)\\b");
  for (const std::string& call :
       {samples + "programs/sinumerik_plate.mpf --model optimal --model ward --model tapie",
        samples + "programs/fanuc_bores.nc --model cam --model grbl --model linuxcnc",
        samples + "programs/trochoidal_slot.nc --load " + samples +
            "examples/trochoidal_slot_load.toml --set X.kv=60"}) {
    const Result result = report(
        call + " --language fr --date 2025-01-31 --without machines,messages,commands" + " --out r.html");
    ASSERT_EQ(result.code, 0) << result.err;
    const std::string html = contents(folder_ / "r.html");
    EXPECT_THAT(html, HasSubstr("<html lang=\"fr\">"));
    EXPECT_THAT(html, HasSubstr("31 janvier 2025"));
    std::istringstream lines(words_of(html));
    for (std::string line; std::getline(lines, line);) {
      std::smatch found;
      const bool source = line.find("Milling Force Model") != std::string::npos;  // of a material
      EXPECT_FALSE(!source && std::regex_search(line, found, english)) << found.str() << ": " << line;
    }
  }
  EXPECT_EQ(report("corner.nc --language en --out e.html").code, 0);
  EXPECT_EQ(report("corner.nc --out e2.html").code, 0);
  const auto said = [&](const char* file) {
    return without(contents(folder_ / file), "<p class=\"command\">", "</p>");
  };
  EXPECT_TRUE(said("e.html") == said("e2.html")) << "English, where nobody asks";
  EXPECT_THAT(contents(folder_ / "e.html"), HasSubstr("<html lang=\"en\">"));
}

TEST_F(ReportCommand, NamesItsLanguages) {
  expect_wrong_use("report corner.nc --language xx --out r.pdf", "--language: xx not in {en,fr}");
  EXPECT_FALSE(fs::exists(folder_ / "r.pdf"));
}

TEST_F(ReportCommand, FillsATemplateOfOnesOwn) {
  write("own.html", "<h1>{{title}}</h1>{{comparison_table}}");
  ASSERT_EQ(report("corner.nc --template own.html --out r.html").code, 0);
  EXPECT_THAT(contents(folder_ / "r.html"), HasSubstr("<h1>corner.nc</h1><table"));
  write("wrong.html", "\n{{charst}}\n");
  expect_wrong_use("report corner.nc --template wrong.html --out s.html",
                   "wrong.html:2: unknown placeholder '{{charst}}'; did you mean '{{charts}}'?");
  EXPECT_FALSE(fs::exists(folder_ / "s.html"));
}

TEST_F(ReportCommand, WritesPagesAsPictures) {
  ASSERT_EQ(report("corner.nc --out page.png --dpi 40 --without time_changes").code, 0);
  for (const char* name : {"page-1.png", "page-2.png"}) {
    EXPECT_THAT(contents(folder_ / name), StartsWith("\x89PNG")) << name;
  }
  EXPECT_FALSE(fs::exists(folder_ / "page.png"));
  expect_wrong_use("report corner.nc --format png --out -", "give --out FILE.png");
  expect_wrong_use("report corner.nc --dpi 100 --out r.pdf", "--dpi has no effect with pdf");
}

TEST_F(ReportCommand, HoldsWhatIsAskedForAndItsCommandSaysSo) {
  write("logo.svg", "<svg xmlns='http://www.w3.org/2000/svg' width='40' height='20'/>");
  ASSERT_EQ(
      report("corner.nc --remarks 'In short: <1 s' --logo logo.svg --without charts,machines --out r.html")
          .code,
      0);
  const std::string html = contents(folder_ / "r.html");
  EXPECT_THAT(html, HasSubstr("<p>In short: &lt;1 s</p>"));
  EXPECT_THAT(html, HasSubstr("<img src=\"data:image/svg+xml,"));
  EXPECT_THAT(html, HasSubstr("How far to trust it"));
  EXPECT_THAT(html, Not(HasSubstr("<h2>Machine</h2>")));
  EXPECT_THAT(html, HasSubstr("--without charts,machines"));
  expect_wrong_use("report corner.nc --with chart --out s.html", "did you mean 'charts'?");
  expect_wrong_use("report corner.nc --without chart --out s.html", "did you mean 'charts'?");
  expect_wrong_use("report corner.nc --logo none.png --out s.html", "picture 'none.png' cannot be read");
  expect_wrong_use("report corner.nc --logo corner.nc --out s.html", "'corner.nc' is not a picture");
  EXPECT_FALSE(fs::exists(folder_ / "s.html"));
}

TEST_F(ReportCommand, TellsItsProgressInLinesWhereAsked) {
  const Result result = report("corner.nc --progress --out r.html");
  EXPECT_EQ(result.code, 0);
  EXPECT_THAT(result.err, HasSubstr("progress: drawing "));
  EXPECT_THAT(contents(folder_ / "r.html"), Not(HasSubstr("--progress")));
}

TEST_F(ReportCommand, WritesTheRestOfAProgramWithErrors) {
  const Result result = report("wrong.nc --out r.html");
  EXPECT_EQ(result.code, 1);
  EXPECT_THAT(result.err, HasSubstr("wrong.nc:2:"));
  EXPECT_THAT(contents(folder_ / "r.html"), HasSubstr("Messages of the reader"));
}

TEST_F(ReportCommand, WrongUseLeavesNothingBehind) {
  const std::vector<std::string> before = files();
  expect_wrong_use("report corner.nc --out r.txt", "end it in .pdf, .html, .png, or add --format");
  expect_wrong_use("report corner.nc --out nowhere/r.pdf", "cannot write 'nowhere/r.pdf'");
  expect_wrong_use("report corner.nc --date yesterday --out r.pdf", "--date 'yesterday' is not a date");
  expect_wrong_use("report corner.nc --set alpah=2 --out r.pdf", "did you mean 'alpha'?");
  expect_wrong_use("report corner.nc --format pdf --out /dev/full", "cannot write '/dev/full'");
  expect_wrong_use("report missing.nc --out r.pdf", "missing.nc");
  std::vector<std::string> after = files();
  std::erase(after, "stderr");
  std::vector<std::string> expected = before;
  std::erase(expected, "stderr");
  EXPECT_THAT(after, testing::UnorderedElementsAreArray(expected));
}

}  // namespace
}  // namespace feedscope::test
