#include "ui/report/blocks/report_circles.h"

#include <gmock/gmock.h>

#include "tests/ui/report/pdf_reading.h"
#include "tests/ui/report/report_fixture.h"
#include "ui/report/report.h"

namespace feedscope::ui {
namespace {

using testing::Contains;
using testing::Field;
using testing::HasSubstr;
using testing::Not;

ReportInput report_of(const std::string& text) {
  const LoadedProgram program = load_program(std::make_shared<const SourceText>("circles.nc", text));
  ReportInput input;
  input.runs = report_runs({make_shown(simulate_run(program, make_setup({"mikron-ucp710", "", {}})))});
  return input;
}

const std::string circles =
    "G21 G90 G17 G94 F6000\nG0 X30 Y0\nG3 I-30 J0\nG2 I-30 J0\nG0 X20\nG3 I-20 Z-1\nM30\n";

std::string blocks_of(const ReportInput& input, const char* page) {
  return make_report(input, ReportTemplate(QString::fromLatin1(page), "page.html", report_placeholders()),
                     ReportFormat::html);
}

TEST(ReportCircles, TableHasTheValuesOfTheEvaluation) {
  const ReportInput input = with_circles(report_of(circles));
  ASSERT_EQ(input.circles->tests.size(), 1U);
  const std::string html = circles_block(input).toStdString();
  const CircularTest& test = input.circles->tests[0];
  for (const double value : {test.passes[0].circularity.zone, *test.g_b(), *test.d()}) {
    EXPECT_THAT(html, HasSubstr(QString::number(1000 * value, 'f', 2).toStdString()));
  }
  EXPECT_THAT(html, HasSubstr("least radial separation of two concentric circles"));
  EXPECT_THAT(html, HasSubstr("Not evaluated: 1 helix with full turns."));
}

TEST(ReportCircles, SectionIsThereWhereTheProgramHasFullCircles) {
  const ReportTemplate shipped = load_report_template();
  test::PdfReading with(make_report(test::with_appendices(report_of(circles)), shipped, ReportFormat::pdf));
  using Bookmark = test::PdfReading::Bookmark;
  EXPECT_THAT(with.bookmarks(), Contains(Field(&Bookmark::title, "Circular test")));
  test::PdfReading without(
      make_report(test::with_appendices(report_of("G21 F3000 G1 X10\nM30\n")), shipped, ReportFormat::pdf));
  EXPECT_THAT(without.bookmarks(), Not(Contains(Field(&Bookmark::title, "Circular test"))));
}

TEST(ReportCircles, TemplatesPlaceOrOmitTheBlocks) {
  const ReportInput input = report_of(circles);
  EXPECT_THAT(blocks_of(input, "{{circles}}"), HasSubstr("<table"));
  EXPECT_THAT(blocks_of(input, "{{circle_plots}}"), HasSubstr("data:image/svg"));
  EXPECT_EQ(blocks_of(input, "{{#circles}}none{{/circles}}{{title}}").find("none"), 0U);
  const ReportInput plain = report_of("G21 F3000 G1 X10\nM30\n");
  EXPECT_EQ(blocks_of(plain, "{{circles}}{{circle_plots}}"), "");
}

}  // namespace
}  // namespace feedscope::ui
