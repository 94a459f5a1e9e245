#include <gmock/gmock.h>

#include "tests/ui/report/report_fixture.h"
#include "ui/report/blocks/report_decision.h"
#include "ui/report/report_tables.h"

namespace feedscope::ui {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// Runs of a program on a machine of grbl, by each of these models.
ReportInput runs_of_models(const std::string& text, const std::vector<std::string>& models) {
  QLocale::setDefault(QLocale::c());
  const LoadedProgram program = load_program(std::make_shared<const SourceText>("part.nc", text));
  std::vector<std::shared_ptr<const ShownRun>> shown;
  for (const std::string& model : models) {
    shown.push_back(make_shown(simulate_run(program, make_setup({"grbl-router", model, {}, {}}))));
  }
  ReportInput input;
  input.runs = report_runs(shown);
  return input;
}

std::string summary_of_models(const std::string& text, const std::vector<std::string>& models) {
  return summary_block(runs_of_models(text, models)).remove("<wbr>").toStdString();
}

TEST(ReportRefused, AProgramWithoutAFeedMotionHasNoTime) {
  const std::string program = "G21 G90\nG0 X10\nG1 X100\nG1 Y100\n";  // grbl wants a feed
  EXPECT_THAT(summary_of_models(program, {"grbl"}),
              AllOf(HasSubstr("The control refuses the program"), Not(HasSubstr(" lost"))));
  EXPECT_THAT(summary_of_models(program, {"grbl", "cam"}),
              HasSubstr("No run has the model of its machine: none is recommended."));
  EXPECT_THAT(summary_of_models(program, {"grbl", "grbl"}),
              HasSubstr("The control refuses the program in all"));
}

TEST(ReportRefused, TheTimeOfAPartSaysHowMuchOfItIsNotRun) {
  EXPECT_THAT(summary_of_models("G21 G90\nG1 X10 F1000\nG1 X200 H1\nX10\n", {"grbl"}),
              AllOf(HasSubstr("contour error"), HasSubstr("1 line of the program")));
}

TEST(ReportRefused, ARunOfAPartIsNamedAndNotComparedWithTheWhole) {
  const ReportInput input =
      runs_of_models("G21 G90\nG1 X10 F1000\nG1 X200 H1\nX10\n", {"cam", "grbl", "cam"});
  EXPECT_THAT(verdict_block(input).toStdString(), HasSubstr("<b>B</b> – 1 line of the program"));
  ReportPictures pictures;
  const QString table = runs_table_block(input, pictures);
  EXPECT_EQ(table.count(" %"), 0) << table.toStdString();
}

/// Rapids take time, but no part is made: no table has that time as a result.
TEST(ReportRefused, TablesHaveNoFiguresOfIt) {
  QLocale::setDefault(QLocale::c());
  const LoadedProgram program = load_program(
      std::make_shared<const SourceText>("part.nc", "G21 G90\nG0 X10\nG1 X100\nG1 Y100\nG0 X0\n"));
  ReportInput input;
  input.runs = report_runs({make_shown(simulate_run(program, make_setup({"grbl-router", "grbl", {}, {}})))});
  ASSERT_GT(input.run().shown->run.summary.cycle_time, 0);
  EXPECT_THAT(comparison_block(input).toStdString(), AllOf(HasSubstr("refused"), Not(HasSubstr("0.6"))));
  EXPECT_EQ(causes_block(input), QString());
}

}  // namespace
}  // namespace feedscope::ui
