#include "ui/report/blocks/report_traces.h"

#include <gmock/gmock.h>

#include "core/analysis/agreement/agreement.h"
#include "core/trace/read_trace.h"
#include "tests/ui/report/pdf_reading.h"
#include "tests/ui/report/report_fixture.h"
#include "tests/ui/trace_fixture.h"
#include "ui/language/texts.h"
#include "ui/report/report.h"

namespace feedscope::ui {
namespace {

using testing::Contains;
using testing::Field;
using testing::HasSubstr;
using testing::Not;

/// Of the run with the smaller tolerance, beside that with the larger one.
ReportInput report_with_trace() {
  ReportInput input = test::two_runs();
  const test::WrittenFiles files;
  const auto trace = std::make_shared<const Trace>(
      read_trace(files.write("scope.csv", test::trace_table(input.runs[0].shown->run)), {}));
  input.current = 1;
  input.traces = {{lay_beside(trace, input.run().shown), "night shift", QColor(0, 0x9e, 0x73)}};
  return input;
}

TEST(ReportTraces, TellsTimesDistanceAndThePlacesThatDifferMost) {
  const ReportInput input = report_with_trace();
  const Agreement& agreement = input.traces[0].shown->agreement;
  ASSERT_FALSE(agreement.worst.empty());
  const std::string html = traces_block(input).toStdString();
  EXPECT_THAT(html, HasSubstr("night shift"));
  EXPECT_THAT(html, HasSubstr("#009e73"));
  EXPECT_THAT(html, HasSubstr(clock_text(agreement.measured_time).toStdString()));
  EXPECT_THAT(html, HasSubstr(clock_text(agreement.simulated_time).toStdString()));
  EXPECT_THAT(html, HasSubstr(QString::number(1000 * agreement.worst.front().lost, 'f', 2).toStdString()));
  EXPECT_THAT(html, HasSubstr("The trace was moved by X −12.5"));
}

TEST(ReportTraces, SectionIsThereWhereATraceIs) {
  using Bookmark = test::PdfReading::Bookmark;
  const ReportTemplate shipped = load_report_template();
  ReportInput input = report_with_trace();
  test::PdfReading with(make_report(input, shipped, ReportFormat::pdf));
  EXPECT_THAT(with.bookmarks(), Contains(Field(&Bookmark::title, "Agreement with the control")));
  input.traces.clear();
  EXPECT_TRUE(traces_block(input).isEmpty());
  test::PdfReading without(make_report(input, shipped, ReportFormat::pdf));
  EXPECT_THAT(without.bookmarks(), Not(Contains(Field(&Bookmark::title, "Agreement with the control"))));
}

}  // namespace
}  // namespace feedscope::ui
