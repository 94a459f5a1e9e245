#include "ui/report/blocks/report_decision.h"

#include <gmock/gmock.h>

#include <QPainter>
#include <map>

#include "core/analysis/study/recommendation.h"
#include "core/base/data_folder.h"
#include "tests/ui/report/pdf_reading.h"
#include "tests/ui/report/recorded_text.h"
#include "tests/ui/report/report_fixture.h"
#include "ui/report/report.h"
#include "ui/report/report_numbers.h"
#include "ui/workbench/decision.h"

namespace feedscope::ui {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

std::string decision_page(const ReportInput& input, const char* page) {
  return make_report(input, ReportTemplate(QString::fromLatin1(page), "page.html", report_placeholders()),
                     ReportFormat::html);
}

/// A run of the program for each tolerance, with these assignments.
ReportInput decision_runs(const std::string& text, const std::vector<double>& tolerances,
                          const std::vector<std::string>& assignments = {},
                          const std::string& model = "essid") {
  const LoadedProgram program = load_program(std::make_shared<const SourceText>("part.nc", text));
  std::vector<std::shared_ptr<const ShownRun>> shown;
  for (const double tolerance : tolerances) {
    shown.push_back(make_shown(simulate_run(program, make_setup({"", model, tolerance, assignments}))));
  }
  ReportInput input;
  input.runs = report_runs(shown);
  return input;
}

/// Its many corners are rounded within the tolerance.
const std::string many_corners = [] {
  std::string text = "G21 G90 F6000\n";
  for (int i = 1; i <= 40; ++i) {
    text += "G1 X" + std::to_string(2 * i) + " Y" + std::to_string(i % 2 == 0 ? 0 : 2) + "\n";
  }
  return text + "M30\n";
}();

TEST(ReportDecision, TheHeadlineIsTheRecommendedRun) {
  const LoadedProgram program = load_program(data_folder() / "resources" / "programs" / "trochoidal_slot.nc");
  std::vector<std::shared_ptr<const ShownRun>> shown;
  for (const double tolerance : {0.01, 0.02}) {
    shown.push_back(make_shown(simulate_run(program, make_setup({"", "essid", tolerance, {}}))));
  }
  ReportInput input;
  input.runs = report_runs(shown);
  ASSERT_EQ(recommend(run_figures(input), {})->run, 1U);
  EXPECT_THAT(decision_page(input, "{{headline}}"),
              AllOf(HasSubstr("B (0.02 mm): "), HasSubstr("less than A (0.01 mm)")));
  EXPECT_EQ(decision_page(input, "{{lettered_run}}"), "B (0.02 mm)") << "pictures are of this run";
}

TEST(ReportDecision, NoDifferenceTakesTheSmallestError) {
  EXPECT_THAT(decision_page(test::two_runs(), "{{headline}}"),
              HasSubstr("No difference worth having: A (0.01 mm) takes "));
}

TEST(ReportDecision, ABoundTakesAnotherRun) {
  ReportInput input = decision_runs(many_corners, {0.01, 0.1});
  input.within = deciding_error(summary_of(input.runs[0]));
  EXPECT_THAT(decision_page(input, "{{headline}}"), HasSubstr("A (0.01 mm): "));
}

TEST(ReportDecision, WithoutARunWithinTheBoundPagesShowTheOneThatIsNamed) {
  ReportInput input = decision_runs(many_corners, {0.1, 0.01});
  input.within = 0.5 * deciding_error(summary_of(input.runs[1]));
  const std::string page = decision_page(input, "<h1>{{headline}}</h1>{{lettered_run}}{{summary}}");
  EXPECT_THAT(page, AllOf(HasSubstr("No run keeps a contour error of"),
                          HasSubstr("with B (0.01 mm).</h1>B (0.01 mm)"),
                          HasSubstr("Most of the time of B (0.01 mm)")));
}

TEST(ReportDecision, RunsWithoutAChoiceSaySo) {
  const LoadedProgram program = load_program(std::make_shared<const SourceText>("part.nc", many_corners));
  ReportInput input;
  input.runs = report_runs({make_shown(simulate_run(program, make_setup({"grbl-router", "essid", 0.01, {}}))),
                            make_shown(simulate_run(program, make_setup({"grbl-router", "cam", {}, {}})))});
  EXPECT_THAT(decision_page(input, "{{headline}}"), HasSubstr("No run has the model of its machine"));
}

TEST(ReportDecision, APathThatIsShortenedIsFasterThanProgrammed) {
  EXPECT_THAT(DecisionTexts::single({.cycle_time = 9, .programmed_time = 10}).toStdString(),
              HasSubstr("9.00\u00a0s, 1.00\u00a0s less than programmed (11\u00a0%); contour error"));
  EXPECT_THAT(DecisionTexts::single({.cycle_time = 10, .programmed_time = 10}).toStdString(),
              HasSubstr("10.0\u00a0s, as long as programmed; contour error"));
  EXPECT_THAT(DecisionTexts::single({.cycle_time = 10, .programmed_time = 9}).toStdString(),
              HasSubstr("10.0\u00a0s, of which 1.00\u00a0s are lost (10\u00a0%); contour error"));
}

TEST(ReportDecision, NothingLostHasNoHeading) {
  const LoadedProgram program = load_program(std::make_shared<const SourceText>("part.nc", many_corners));
  ReportInput input;
  input.runs = report_runs({make_shown(simulate_run(program, make_setup({"", "cam", {}, {}})))});
  EXPECT_THAT(decision_page(input, "{{losses}}"), Not(HasSubstr("Where time is lost")));
}

TEST(ReportDecision, OfARunAloneSaysWhetherItKeepsTheBound) {
  ReportInput input = decision_runs(many_corners, {0.1});
  const double error = deciding_error(summary_of(input.runs[0]));
  EXPECT_THAT(decision_page(input, "{{verdict}}"), Not(HasSubstr("bound")));
  input.within = 1.1 * error;
  EXPECT_THAT(decision_page(input, "{{verdict}}"), HasSubstr("keeps the bound"));
  input.within = 0.5 * error;
  EXPECT_THAT(decision_page(input, "{{verdict}}"), HasSubstr("is above the bound"));
}

TEST(ReportDecision, ARunThatCannotBeSimulatedIsNamed) {
  ReportInput input = test::two_runs();
  input.unmade = {
      {"optimal, path ward", Message::as_written("setting path: the path of ward needs more than 5 curves")}};
  EXPECT_THAT(decision_page(input, "{{verdict}}"),
              HasSubstr("<b>optimal, path ward could not be simulated.</b> setting path: the path of ward"));
}

TEST(ReportDecision, PlacesLeadToTheirFigures) {
  const ReportInput input = decision_runs(many_corners, {0.01, 0.1});
  const ReportTemplate page(QStringLiteral("{{losses}}{{cards}}"), "page.html", report_placeholders());
  test::PdfReading reading(make_report(input, page, ReportFormat::pdf));
  const auto links = reading.links();
  ASSERT_FALSE(links.empty());
  EXPECT_THAT(links[0].title, ::testing::StartsWith("Figure"));
  EXPECT_GE(links[0].to_page, 0);
  EXPECT_EQ(make_report(input, page, ReportFormat::html).find("\xEE\x80"), std::string::npos)
      << "no mark is left";
  const std::string without = decision_page(input, "{{losses}}");
  EXPECT_EQ(without.find("<a href"), std::string::npos) << "no card, no reference";
}

TEST(ReportDecision, PartsOfThePagesAreTaggedAndFiguresDescribed) {
  const ReportInput input = decision_runs(many_corners, {0.01, 0.1});
  test::PdfReading reading(make_report(input, load_report_template(), ReportFormat::pdf));
  std::size_t pieces = 0;
  std::map<std::string, int> types;
  for (const auto& tag : reading.tags()) {
    ++types[tag.type];
    pieces += tag.pieces;
    EXPECT_EQ(tag.type == "Figure", !tag.alternative.empty()) << tag.type;
  }
  EXPECT_EQ(types["H1"], 1) << "the headline";
  EXPECT_GE(types["H2"], 3) << "one for each page after it";
  EXPECT_GE(types["Figure"], 8);
  EXPECT_GE(types["Table"], 3);
  EXPECT_GT(types["TH"], types["Table"]);
  EXPECT_GT(types["TD"], types["TH"]);
  EXPECT_GT(types["P"], 10);
  EXPECT_EQ(pieces, reading.marked_contents());
}

TEST(ReportDecision, RotaryAxesHaveTheirLimits) {
  const LoadedProgram program = load_program(std::make_shared<const SourceText>("part.nc", many_corners));
  ReportInput input;
  input.runs = report_runs(
      {make_shown(simulate_run(program, make_setup({"five-axis-table-ac", "essid", std::nullopt, {}})))});
  const std::string trust = decision_page(input, "{{trust}}");
  EXPECT_THAT(trust,
              AllOf(HasSubstr("Rotary axis"), HasSubstr("[rev/min]"), HasSubstr(">A<"), HasSubstr(">C<")));
}

/// Their settings come from their files, which page 4 describes.
TEST(ReportDecision, RunsOnSeveralMachinesAreNamedByTheMachine) {
  const LoadedProgram program = load_program(std::make_shared<const SourceText>("part.nc", many_corners));
  std::vector<std::shared_ptr<const ShownRun>> shown;
  for (const char* machine : {"spinner-mvc850", "klipper-corexy"}) {
    shown.push_back(make_shown(simulate_run(program, make_setup({machine, "essid", 0.01, {}}))));
  }
  ASSERT_NE(shown[0]->run.setup.settings.number("lookahead_blocks"),
            shown[1]->run.setup.settings.number("lookahead_blocks"));
  const std::vector<ReportRun> runs = report_runs(shown);
  EXPECT_EQ(runs[0].name.toStdString(), "spinner-mvc850, essid, 0.01 mm");
  EXPECT_EQ(runs[1].name.toStdString(), "klipper-corexy, essid, 0.01 mm");
}

TEST(ReportDecision, PageFourHasTheLimitsAndSettingsOfEveryRun) {
  const LoadedProgram program = load_program(std::make_shared<const SourceText>("part.nc", many_corners));
  std::vector<std::shared_ptr<const ShownRun>> shown;
  for (const char* jerk : {"X.jerk=10", "X.jerk=20"}) {
    shown.push_back(make_shown(simulate_run(program, make_setup({"", "essid", 0.05, {jerk, "alpha=2"}}))));
  }
  ReportInput input;
  input.runs = report_runs(shown);
  const std::string trust = decision_page(input, "{{trust}}");
  EXPECT_THAT(trust, HasSubstr(">10 / 20<"));
  EXPECT_THAT(trust, HasSubstr("Contour tolerance 0.05 mm"));
  EXPECT_THAT(trust, Not(HasSubstr("contour_tolerance_mm"))) << "keys are for command lines";
}

TEST(ReportDecision, PagesOfLetterPaperAreAsLargeAsIt) {
  ReportInput input = test::two_runs();
  input.paper = letter_paper;
  test::PdfReading reading(make_report(input, load_report_template(), ReportFormat::pdf));
  EXPECT_EQ(reading.page_size(0), std::pair(612.0, 792.0));
}

TEST(ReportDecision, ASingleRunSaysWhatIsLost) {
  ReportInput input = test::two_runs();
  input.runs.resize(1);
  EXPECT_THAT(decision_page(input, "{{headline}}"),
              AllOf(HasSubstr(", of which "), HasSubstr("are lost"), HasSubstr("contour error")));
  EXPECT_THAT(decision_page(input, "{{subject}}"), HasSubstr("test.nc · Spinner MVC 850 · essid, 0.01 mm"));
}

TEST(ReportDecision, WithDrivesTheErrorIsThatOfTheAxes) {
  const ReportInput input =
      decision_runs(test::small_program, {0.01, 0.05}, {"X.kv=60", "Y.kv=60", "Z.kv=60"});
  const std::string table = decision_page(input, "{{runs_table}}");
  EXPECT_THAT(table, HasSubstr("Actual contour error"));
  for (const ReportRun& run : input.runs) {
    ASSERT_TRUE(summary_of(run).actual.has_value());
    ASSERT_GT(deciding_error(summary_of(run)), summary_of(run).cutting_contour_error);
    EXPECT_THAT(table, HasSubstr(error_number(deciding_error(summary_of(run))).toStdString()));
  }
  EXPECT_THAT(decision_page(input, "{{headline}}"), HasSubstr("actual contour error"));
}

TEST(ReportDecision, TheFirstErrorIsUnderTheHeadline) {
  const ReportInput input = decision_runs("G21 G90 F3000\nG1 X10\nG1 XA\nG1 X20\nG1 YB\n", {0.01});
  EXPECT_THAT(decision_page(input, "{{verdict}}"), AllOf(HasSubstr("2 errors"), HasSubstr("Line 3: ")));
  EXPECT_THAT(decision_page(test::two_runs(), "{{verdict}}"), Not(HasSubstr("class=\"fault\"")));
}

TEST(ReportDecision, TolerancesWithoutEffectAreNamed) {
  ReportInput input = decision_runs(test::small_program, {0.01}, {}, "cam");
  EXPECT_THAT(decision_page(input, "{{verdict}}"), Not(HasSubstr("uses no contour tolerance")));
  input.tolerances_asked = 2;
  EXPECT_THAT(decision_page(input, "{{verdict}}"),
              HasSubstr("The model cam uses no contour tolerance: it has one run for the 2"));
}

TEST(ReportDecision, NoTextOfThePicturesIsCut) {
  const ReportInput input = test::two_runs();
  const ReportPage page = report_page(input, load_report_template(), ReportFormat::pdf);
  for (const auto& [name, picture] : page.pictures.all()) {
    if (!picture.raster) {
      test::RecordedText paper;
      QPainter painter(&paper);
      page.pictures.paint(name, painter, 1);
      painter.end();
      EXPECT_TRUE(paper.texts().filter("…").isEmpty()) << name.toStdString();
    }
  }
}

TEST(ReportDecision, FourPagesAreTwoWhereTheyAreBrief) {
  const LoadedProgram program = load_program(data_folder() / "resources" / "programs" / "trochoidal_slot.nc");
  std::vector<std::shared_ptr<const ShownRun>> shown;
  for (const double tolerance : {0.01, 0.05}) {
    shown.push_back(make_shown(simulate_run(program, make_setup({"", "essid", tolerance, {}}))));
  }
  ReportInput input;
  input.runs = report_runs(shown);
  input.without = {"time_changes"};
  test::PdfReading whole(make_report(input, load_report_template(), ReportFormat::pdf));
  EXPECT_EQ(whole.page_count(), 4U);
  input.with.clear();
  test::PdfReading brief(make_report(input, load_report_template(), ReportFormat::pdf));
  EXPECT_EQ(brief.page_count(), 2U);
}

}  // namespace
}  // namespace feedscope::ui
