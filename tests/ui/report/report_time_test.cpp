#include "ui/report/blocks/report_time.h"

#include <gmock/gmock.h>

#include "tests/ui/report/report_fixture.h"
#include "ui/language/time_texts.h"
#include "ui/report/report.h"
#include "ui/report/report_numbers.h"

namespace feedscope::ui {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

std::string html_of(const ReportInput& input, const QString& page) {
  return make_report(input, ReportTemplate(page, "page.html", report_placeholders()), ReportFormat::html);
}

TEST(ReportTime, HoldsTheNumbersOfTheReportOnTheRecommendedRun) {
  ReportInput input = test::two_runs();
  input.current = 1;
  const ReportInput recommended = with_recommended_run(input);
  ASSERT_EQ(recommended.current, 0U);
  const feedscope::Run& run = recommended.run().shown->run;
  const TimeReport report = time_report(run);
  const std::string use = html_of(input, "{{time_use}}");
  EXPECT_THAT(use, HasSubstr(fixed(report.use.cycle_time, 3).toStdString()));
  EXPECT_THAT(use, HasSubstr(fixed(report.use.of(TimeKind::cutting).lost(), 3).toStdString()));
  const std::string places = html_of(input, "{{time_places}}");
  EXPECT_THAT(places, HasSubstr(fixed(report.slow.groups.front().loss, 3).toStdString()));
  const std::string changes = html_of(input, "{{time_changes}}");
  ASSERT_FALSE(report.changes.best.empty());
  for (const std::size_t i : report.changes.best) {
    EXPECT_THAT(changes, HasSubstr(fixed(report.changes.tried[i].cycle_time, 3).toStdString()));
  }
}

TEST(ReportTime, WhatIsLeftOutIsNeitherShownNorSimulated) {
  ReportInput input = test::two_runs();
  const ReportInput without = with_time_report(input, false);
  EXPECT_TRUE(without.time->changes.tried.empty());
  EXPECT_EQ(time_changes_block(without), QString());
  input = test::with_appendices(std::move(input));
  input.without = {"time_changes", "charts", "machines"};
  const std::string html = make_report(input, load_report_template(), ReportFormat::html);
  EXPECT_THAT(html, HasSubstr("Where does the time go?"));
  for (const char* heading : {"What would help", "Along the path", "<h2>Machine</h2>"}) {
    EXPECT_THAT(html, Not(HasSubstr(heading)));
  }
}

TEST(ReportTime, ChartsOfAStretchSayWhichItIs) {
  ReportInput input = test::two_runs();
  EXPECT_THAT(html_of(input, "{{charts}}"), Not(HasSubstr(" From ")));
  const double duration = input.runs[0].shown->run.trajectory->duration();
  input.charts.time = Interval{0, duration};
  EXPECT_THAT(html_of(input, "{{charts}}"), Not(HasSubstr(" From ")));
  input.charts.time = Interval{0.05, 0.1};
  EXPECT_THAT(html_of(input, "{{charts}}"),
              HasSubstr(" From 0.050 s to 0.100 s of " + fixed(duration, 3).toStdString() + " s."));
}

/// However little it is of the whole program.
TEST(ReportTime, AnOperationNamesWhatItLosesMostTo) {
  ReportInput input;
  input.runs = report_runs({make_shown(
      test::simulate_text("G21 G90 F6000\nT1 M6\nG1 X10\nG4 X20000\nT2 M6\nG1 Y5\nX15\nY10\nX20\nM30\n"))});
  const TimeReport report = time_report(input.run().shown->run);
  ASSERT_EQ(report.use.operations.size(), 2U);
  const OperationTime& small = report.use.operations[1];
  ASSERT_LT(small.worst.lost, 5e-4 * report.use.cycle_time);
  EXPECT_TRUE(small.loses());
  EXPECT_THAT(html_of(input, "{{time_use}}"), HasSubstr(TimeTexts::cause(small.worst.cause).toStdString()));
}

TEST(ReportTime, AProgramThatTakesNoTimeHasNoSectionOfIt) {
  ReportInput input;
  input.runs = report_runs({make_shown(test::simulate_text("M30\n"))});
  EXPECT_THAT(html_of(input, "{{summary}}"),
              AllOf(HasSubstr("No motion in this program"), Not(HasSubstr("programmed time"))));
  EXPECT_THAT(html_of(input, "{{comparison_table}}"), Not(HasSubstr("1.000"))) << "the ratio of nothing";
  EXPECT_EQ(html_of(input, "{{time_use}}{{time_places}}{{time_changes}}"), "");
}

TEST(ReportRemarks, AreParagraphsOfPlainText) {
  ReportInput input = test::two_runs();
  EXPECT_EQ(html_of(input, "{{remarks}}"), "");
  input.remarks = " First <b>line\nsecond\n\n\nAnother ";
  EXPECT_EQ(html_of(input, "{{remarks}}"), "<p>First &lt;b&gt;line<br/>second</p>\n<p>Another</p>\n");
}

TEST(ReportPictures, ThereIsOneForEachPageOfThePdf) {
  ReportInput input = test::with_appendices(test::two_runs());
  input.without = {"time_changes"};
  const std::vector<std::string> pages = make_report_pictures(input, load_report_template(), 48);
  EXPECT_GE(pages.size(), 4U);
  for (const std::string& bytes : pages) {
    const QImage page = QImage::fromData(QByteArray::fromStdString(bytes));
    EXPECT_NEAR(page.width(), 210 / 25.4 * 48, 1);
    EXPECT_NEAR(page.height(), 297 / 25.4 * 48, 1);
  }
}

}  // namespace
}  // namespace feedscope::ui
