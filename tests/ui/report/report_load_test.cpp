#include "ui/report/blocks/report_load.h"

#include <gmock/gmock.h>

#include "core/base/data_folder.h"
#include "tests/ui/report/pdf_reading.h"
#include "tests/ui/report/report_fixture.h"
#include "ui/report/report.h"

namespace feedscope::ui {
namespace {

using testing::Contains;
using testing::Field;
using testing::HasSubstr;
using testing::Not;

ReportInput report_of_load(bool load) {
  const auto source = std::make_shared<const SourceText>(
      "part.nc", "G21 G90\nT1 M6\nS8000 M3\nG1 X50 F2000\nY50\nG1 Z-5\nM30\n");
  Setup setup = make_setup({"", "essid", {}});
  if (load) {
    setup.load = read_load_file(data_folder() / "resources/examples/lesson_chip_load.toml");
  }
  ReportInput input;
  input.runs = report_runs({make_shown(simulate_run(load_program(source), setup))});
  return input;
}

TEST(ReportLoad, HasTheFiguresOfTheRunAndWhatIsAssumed) {
  const ReportInput input = report_of_load(true);
  const LoadFigures& load = *input.run().shown->run.summary.load;
  const std::string html = load_block(input).toStdString();
  EXPECT_THAT(html, HasSubstr(QString::number(load.all.predicted[3].largest, 'f', 0).toStdString() + " N"));
  EXPECT_THAT(html, HasSubstr(QString::number(load.all.programmed[3].largest, 'f', 0).toStdString() + " N"));
  EXPECT_THAT(html, HasSubstr("Aluminium 7075-T6"));
  EXPECT_THAT(html, HasSubstr("Milling Force Model for Aviation Aluminum Alloy"));
  EXPECT_THAT(html, HasSubstr("engagement as given"));
  EXPECT_THAT(html, HasSubstr("plunging and drilling"));
  EXPECT_THAT(html, HasSubstr("rubbing"));
}

TEST(ReportLoad, SectionIsThereWhereOperationsAreKnown) {
  const ReportTemplate shipped = load_report_template();
  using Bookmark = test::PdfReading::Bookmark;
  test::PdfReading with(make_report(report_of_load(true), shipped, ReportFormat::pdf));
  EXPECT_THAT(with.bookmarks(), Contains(Field(&Bookmark::title, "Cutting load")));
  test::PdfReading without(make_report(report_of_load(false), shipped, ReportFormat::pdf));
  EXPECT_THAT(without.bookmarks(), Not(Contains(Field(&Bookmark::title, "Cutting load"))));
  EXPECT_TRUE(load_block(report_of_load(false)).isEmpty());
}

}  // namespace
}  // namespace feedscope::ui
