#include "ui/report/blocks/report_identification.h"

#include <gmock/gmock.h>

#include "core/trace/read_trace.h"
#include "tests/ui/identification_fixture.h"
#include "tests/ui/report/pdf_reading.h"
#include "tests/ui/report/report_fixture.h"
#include "tests/ui/trace_fixture.h"
#include "ui/report/report.h"

namespace feedscope::ui {
namespace {

using testing::Contains;
using testing::Field;
using testing::HasSubstr;
using testing::Not;

class ReportIdentification : public testing::Test {
 protected:
  ReportIdentification() {
    QLocale::setDefault(QLocale::c());
    outcome->program = program_mark(input.program());
    input.identification.outcome = outcome;
  }
  std::string block() const { return identification_block(input).remove("<wbr>").toStdString(); }

  const std::shared_ptr<IdentificationOutcome> outcome = test::some_outcome();
  ReportInput input = test::two_runs();
};

TEST_F(ReportIdentification, SaysWhichRecordingsAreExplainedAndHowWell) {
  const std::string html = block();
  EXPECT_THAT(html, HasSubstr("explains what was recorded"));
  EXPECT_THAT(html, HasSubstr("scope.csv"));
  EXPECT_THAT(html, HasSubstr("times.csv"));
  EXPECT_THAT(html, HasSubstr("section times"));
  EXPECT_THAT(html, HasSubstr("+0.05")) << "2 ms of 4 s";
  EXPECT_THAT(html, HasSubstr("90")) << "1.5 mm/s in mm/min";
  EXPECT_THAT(html, HasSubstr("1.25, root mean square"));
  EXPECT_THAT(html, Not(HasSubstr("have changed since")));
}

TEST_F(ReportIdentification, EachNumberHasItsUncertaintyAndSource) {
  const std::string html = block();
  EXPECT_THAT(html, HasSubstr("X Acceleration"));
  EXPECT_THAT(html, HasSubstr("m/s²"));
  EXPECT_THAT(html, HasSubstr("<b>1.300</b>"));
  EXPECT_THAT(html, HasSubstr("0.012"));
  EXPECT_THAT(html, HasSubstr("identified from scope.csv, times.csv, 2026-11-27"));
}

TEST_F(ReportIdentification, WhatIsNotToldSaysWhatWouldTellIt) {
  const std::string html = block();
  EXPECT_THAT(html, HasSubstr("at least 0.5"));
  EXPECT_THAT(html, HasSubstr("It changes nothing that these traces show."));
  EXPECT_THAT(html, HasSubstr("A recording of the test program tells it: part SINGLE MOVES OF Z."));
  EXPECT_THAT(html, HasSubstr("Found: 1 of 2 values."));
}

TEST_F(ReportIdentification, ComparesTheModelsAndSaysWhichCouldNotBeFitted) {
  const std::string html = block();
  EXPECT_THAT(html, HasSubstr("87.50"));
  EXPECT_THAT(html, HasSubstr("−15.00")) << "of the table, which is farther off than the trace";
  EXPECT_THAT(html, HasSubstr("not fitted"));
  EXPECT_THAT(html, HasSubstr("holds too little of its program"));
  outcome->models.pop_back();
  outcome->unfitted.clear();
  EXPECT_THAT(block(), Not(HasSubstr("Explains the recordings"))) << "there is nothing to compare";
}

/// Its numbers would say nothing of the machine.
TEST_F(ReportIdentification, AModelThatDoesNotExplainSaysSo) {
  input.identification.chosen = 1;
  const std::string html = block();
  EXPECT_THAT(html, HasSubstr("does not explain what was recorded"));
  EXPECT_THAT(html, Not(HasSubstr("Found: ")));
  EXPECT_THAT(html, Not(HasSubstr("Tick other models"))) << "there is nothing to tick on paper";
}

TEST_F(ReportIdentification, NamesTheSectionsThatDifferMost) {
  const std::string html = block();
  EXPECT_THAT(html, HasSubstr("4-7"));
  EXPECT_THAT(html, HasSubstr("0.5060"));
  EXPECT_THAT(html, HasSubstr("times.csv: the 4 of 4 sections that differ most."));
}

TEST_F(ReportIdentification, SaysIfSomethingHasChangedSince) {
  input.identification.stale = true;
  EXPECT_THAT(block(), HasSubstr("have changed since"));
  input.identification.stale = false;
  outcome->program = "of another program";
  EXPECT_THAT(block(), HasSubstr("have changed since"));
}

/// A session keeps where its traces are, not what was in them.
TEST_F(ReportIdentification, SaysIfTheFileOfARecordingHoldsAnotherOne) {
  const test::WrittenFiles files;
  const auto show_trace_of = [&](const ReportRun& run) {
    const auto trace = std::make_shared<const Trace>(
        read_trace(files.write("scope.csv", test::trace_table(run.shown->run)), {}));
    input.traces = {{lay_beside(trace, input.run().shown), "scope.csv", QColor(0, 0x9e, 0x73)}};
  };
  show_trace_of(input.runs[0]);
  outcome->recordings[0] = used_recording(*input.traces[0].shown->trace);
  EXPECT_THAT(block(), Not(HasSubstr("have changed since")));
  show_trace_of(input.runs[1]);
  EXPECT_THAT(block(), HasSubstr("have changed since"));
  outcome->recordings[0].name = "another.csv";
  EXPECT_THAT(block(), Not(HasSubstr("have changed since"))) << "a trace that was not used";
}

TEST_F(ReportIdentification, SectionIsThereWhereAResultIs) {
  using Bookmark = test::PdfReading::Bookmark;
  const ReportTemplate shipped = load_report_template();
  test::PdfReading with(make_report(input, shipped, ReportFormat::pdf));
  EXPECT_THAT(with.bookmarks(), Contains(Field(&Bookmark::title, "Identification")));
  const std::string html = make_report(input, shipped, ReportFormat::html);
  EXPECT_THAT(html, HasSubstr("alt=\"Residuals of the identification\""));
  input.identification = {};
  EXPECT_EQ(block(), "");
  test::PdfReading without(make_report(input, shipped, ReportFormat::pdf));
  EXPECT_THAT(without.bookmarks(), Not(Contains(Field(&Bookmark::title, "Identification"))));
}

}  // namespace
}  // namespace feedscope::ui
