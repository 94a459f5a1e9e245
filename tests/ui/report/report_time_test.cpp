#include "ui/report/report_time.h"

#include <gmock/gmock.h>

#include "tests/ui/report/report_fixture.h"
#include "ui/report/report.h"
#include "ui/report/report_numbers.h"

namespace feedscope::ui {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string html_of(const ReportInput& input, const QString& page) {
  return make_report(input, ReportTemplate(page, "page.html", report_placeholders()), ReportFormat::html);
}

TEST(ReportTime, HoldsTheNumbersOfTheReportOnTheCurrentRun) {
  ReportInput input = test::two_runs();
  input.current = 1;
  const feedscope::Run& run = input.run().shown->run;
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
  input.without = {"time_changes", "charts", "machines"};
  const std::string html = make_report(input, load_report_template(), ReportFormat::html);
  EXPECT_THAT(html, HasSubstr("Where does the time go?"));
  for (const char* heading : {"What would help", "Along the path", "<h2>Machine</h2>"}) {
    EXPECT_THAT(html, Not(HasSubstr(heading)));
  }
}

TEST(ReportTime, AProgramThatTakesNoTimeHasNoSectionOfIt) {
  ReportInput input;
  input.runs = report_runs({make_shown(test::simulate_text("M30\n"))});
  EXPECT_EQ(html_of(input, "{{time_use}}{{time_places}}{{time_changes}}"), "");
}

TEST(ReportRemarks, AreParagraphsOfPlainText) {
  ReportInput input = test::two_runs();
  EXPECT_EQ(html_of(input, "{{remarks}}"), "");
  input.remarks = " First <b>line\nsecond\n\n\nAnother ";
  EXPECT_EQ(html_of(input, "{{remarks}}"), "<p>First &lt;b&gt;line<br/>second</p>\n<p>Another</p>\n");
}

TEST(ReportPictures, ThereIsOneForEachPageOfThePdf) {
  ReportInput input = test::two_runs();
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
