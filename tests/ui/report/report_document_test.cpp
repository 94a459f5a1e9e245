#include <gmock/gmock.h>

#include <QPainter>
#include <QRegularExpression>
#include <QSvgRenderer>

#include "tests/ui/report/pdf_reading.h"
#include "tests/ui/report/recorded_text.h"
#include "tests/ui/report/report_fixture.h"
#include "ui/report/report.h"
#include "ui/report/report_numbers.h"
#include "ui/theme/offscreen_application.h"

namespace feedscope::ui {
namespace {

using testing::Contains;
using testing::Field;
using testing::HasSubstr;
using testing::Not;

std::string made(const ReportInput& input, ReportFormat format) {
  return make_report(input, load_report_template(), format);
}

std::string filled(const ReportInput& input, const QString& page) {
  return make_report(input, ReportTemplate(page, "page.html", report_placeholders()), ReportFormat::html);
}

TEST(Report, PdfHasTitlePagesBookmarksAndFonts) {
  ReportInput input = test::with_appendices(test::two_runs());
  input.title = "Flange <b> & lid";
  input.author = "Somebody";
  const std::string bytes = made(input, ReportFormat::pdf);
  test::PdfReading pdf(bytes);
  EXPECT_GE(pdf.page_count(), 4U);
  EXPECT_NEAR(pdf.page_size(0).first, 595, 1);
  EXPECT_NEAR(pdf.page_size(0).second, 842, 1);
  EXPECT_EQ(pdf.info("/Title"), "Flange <b> & lid");
  EXPECT_EQ(pdf.info("/Author"), "Somebody");
  EXPECT_TRUE(pdf.fonts_embedded());
  EXPECT_TRUE(pdf.images().empty()) << "all pictures are vectors";
  const auto bookmarks = pdf.bookmarks();
  ASSERT_FALSE(bookmarks.empty());
  EXPECT_THAT(bookmarks.front().title, HasSubstr("No difference worth having: A (0.01 mm) takes"))
      << "the headline";
  EXPECT_EQ(pdf.language(), "en");
  using Bookmark = test::PdfReading::Bookmark;
  for (const char* title :
       {"Motion", "Settings that differ", "Where most time is lost", "Program", "Control models"}) {
    EXPECT_THAT(bookmarks, Contains(Field(&Bookmark::title, title)));
  }
  EXPECT_TRUE(std::ranges::is_sorted(bookmarks, {}, &Bookmark::page));
  EXPECT_THAT(bookmarks, Not(Contains(Field(&Bookmark::page, -1))));
}

TEST(Report, TheSameInputGivesTheSameBytes) {
  const ReportInput input = test::two_runs();
  EXPECT_EQ(made(input, ReportFormat::pdf), made(input, ReportFormat::pdf));
  EXPECT_EQ(made(input, ReportFormat::html), made(input, ReportFormat::html));
}

TEST(Report, HtmlHoldsEveryPictureInside) {
  const QString html = QString::fromStdString(made(test::two_runs(), ReportFormat::html));
  EXPECT_FALSE(html.contains("picture:"));
  EXPECT_FALSE(html.contains("{{"));
  static const QRegularExpression source("src=\"data:image/(png;base64|svg\\+xml),([^\"]*)\"");
  int pictures = 0;
  for (auto found = source.globalMatch(html); found.hasNext();) {
    const QRegularExpressionMatch match = found.next();
    const QByteArray data = match.captured(2).toLatin1();
    const bool raster = match.captured(1) != "svg+xml";
    const QByteArray bytes = raster ? QByteArray::fromBase64(data) : QByteArray::fromPercentEncoding(data);
    EXPECT_TRUE(raster ? !QImage::fromData(bytes).isNull() : QSvgRenderer(bytes).isValid());
    ++pictures;
  }
  EXPECT_EQ(pictures, html.count("<img "));
  EXPECT_FALSE(QString(html).remove(source).contains(QRegularExpression("\\bnan\\b")));
  EXPECT_GE(pictures, 6);
}

TEST(Report, NamesAndTextsAreEscaped) {
  ReportInput input = test::two_runs("<i>&.nc");
  input.title = "<script>";
  input.annotations = {test::note("a <b> note")};
  const std::string html = filled(input, "{{title}}{{program}}{{notes}}{{program_facts}}");
  EXPECT_THAT(html, HasSubstr("&lt;script&gt;"));
  EXPECT_THAT(html, HasSubstr("&lt;i&gt;&amp;.nc"));
  EXPECT_THAT(html, HasSubstr("a &lt;b&gt; note"));
  EXPECT_THAT(html, Not(HasSubstr("<script>")));
}

TEST(Report, NotesSayTheirLineTimeAndPlace) {
  ReportInput input = test::two_runs();
  Annotation note = test::note("slow here");
  note.kind = AnnotationKind::region;
  note.until = {note.place.segment + 1, 0.5};
  input.annotations = {note};
  const auto& run = input.run().shown->run;
  const State from = run.trajectory->state(time_of(*run.trajectory, note.place));
  const State to = run.trajectory->state(time_of(*run.trajectory, note.until));
  const std::uint32_t line = run.path->segments[note.place.segment].line;
  const std::string html = filled(input, "{{notes}}");
  EXPECT_THAT(html, HasSubstr(QStringLiteral(">%1 – %2<").arg(line).arg(line + 1).toStdString()));
  EXPECT_THAT(
      html,
      HasSubstr(QStringLiteral("%1<br/>%2").arg(from.time, 0, 'f', 3).arg(to.time, 0, 'f', 3).toStdString()));
  EXPECT_THAT(html, HasSubstr(QStringLiteral("%1, %2, %3")
                                  .arg(to.position.x(), 0, 'f', 3)
                                  .arg(to.position.y(), 0, 'f', 3)
                                  .arg(to.position.z(), 0, 'f', 3)
                                  .toStdString()));
  EXPECT_THAT(html, HasSubstr("slow here"));
}

TEST(Report, SaysWhatDiffersAndWhatTheFiguresAre) {
  const ReportInput input = test::two_runs();
  const std::string differing = filled(input, "{{differing_settings}}");
  EXPECT_THAT(differing, HasSubstr("Contour tolerance"));
  EXPECT_THAT(differing, Not(HasSubstr("Look-ahead")));
  const Summary& summary = input.runs[1].shown->run.summary;
  EXPECT_THAT(filled(input, "{{comparison_table}}"),
              HasSubstr(QString::number(summary.cycle_time, 'f', 3).toStdString()));
  ReportInput single = input;
  single.runs.resize(1);
  EXPECT_EQ(filled(single, "{{differing_settings}}{{comparison_bars}}{{notes}}{{messages}}"), "");
}

TEST(Report, BarsNameTheToleranceInForceOfEveryRunAndNoHeadingIsCut) {
  const ReportInput input = test::two_runs();
  const ReportTemplate page("{{comparison_bars}}", "page.html", report_placeholders());
  const ReportPage report = report_page(input, page, ReportFormat::html);
  ASSERT_EQ(report.pictures.all().size(), 1U);
  test::RecordedText paper;
  QPainter painter(&paper);
  report.pictures.paint("bars", painter, 1);
  painter.end();
  for (const char* text : {"tolerance", "contour error", "0.01", "0.05"}) {
    EXPECT_TRUE(paper.texts().contains(text)) << text << " in " << paper.texts().join("|").toStdString();
  }
  EXPECT_TRUE(paper.texts().filter("…").isEmpty());
}

TEST(Report, EveryNumberOfTheMachineHasItsSource) {
  const std::string html = filled(test::two_runs(), "{{machines}}");
  EXPECT_THAT(html, HasSubstr("X Y: Essid 2019, table 2"));
  EXPECT_THAT(html, HasSubstr("<i>assumed: "));
}

TEST(Report, AProgramThatDoesNotMoveHasAReportToo) {
  ReportInput input;
  input.runs = report_runs({make_shown(test::simulate_text("M30\n"))});
  const std::string bytes = made(input, ReportFormat::pdf);
  EXPECT_GE(test::PdfReading(bytes).page_count(), 1U);
  EXPECT_THAT(made(input, ReportFormat::html), Not(HasSubstr("still loses")));
}

TEST(Report, CanBeCancelled) {
  Progress progress;
  progress.cancel();
  EXPECT_THROW(make_report(test::two_runs(), load_report_template(), ReportFormat::pdf, &progress),
               Cancelled);
}

TEST(Report, PdfTextIsCopiedAsItIsRead) {
  const OffscreenApplication application;
  ReportInput input = test::two_runs("ff_fi_fl_ffi_affluent_profile.nc");
  input.title = "Official fluffy profile of a stiff flange";
  input.annotations = {test::note("ffi fluff")};
  const std::string bytes = made(input, ReportFormat::pdf);
  EXPECT_THAT(test::PdfReading(bytes).copied_ligatures(), testing::IsEmpty());
}

TEST(Report, EveryFigureHasTheNextNumber) {
  const QString html = QString::fromStdString(made(test::two_runs(), ReportFormat::html));
  static const QRegularExpression numbers("<p class=\"caption\">Figure (\\d+)\\. ");
  int count = 0;
  for (auto found = numbers.globalMatch(html); found.hasNext();) {
    EXPECT_EQ(found.next().captured(1).toInt(), ++count);
  }
  EXPECT_EQ(count, html.count("class=\"figure\""));
  EXPECT_GE(count, 4);
  EXPECT_FALSE(html.contains(QChar(0xe000)));
}

TEST(ReportNumbers, AChangeHasASignUnlessItIsNone) {
  EXPECT_EQ(signed_percent(-0.0121), QStringLiteral("−1.2"));
  EXPECT_EQ(signed_percent(0.034), QStringLiteral("+3.4"));
  EXPECT_EQ(signed_percent(-0.0002), QStringLiteral("0.0"));
  EXPECT_EQ(signed_percent(0), QStringLiteral("0.0"));
}

TEST(Report, HtmlFitsANarrowScreen) {
  const std::string html = made(test::two_runs(), ReportFormat::html);
  EXPECT_THAT(html, HasSubstr("<meta name=\"viewport\" content=\"width=device-width"));
  EXPECT_THAT(html, HasSubstr("overflow-x: auto"));
}

TEST(Report, CloseUpsHoldTheAnnotationsOfTheirPlaceOnly) {
  ReportInput input = test::two_runs();
  const Trajectory& trajectory = *input.run().shown->run.trajectory;
  for (std::uint32_t segment = 0; segment < 4; ++segment) {
    Annotation annotation = test::note(QString::number(segment));
    annotation.place = {segment, 0.5};
    input.annotations.push_back(annotation);
  }
  const double duration = trajectory.duration();
  constexpr int parts = 12;
  std::size_t seen = 0;
  for (int i = 0; i < parts; ++i) {
    const double from = duration * i / parts;
    const double to = duration * (i + 1) / parts;
    for (const Annotation& annotation : annotations_between(input, from, to)) {
      const double time = time_of(trajectory, annotation.place);
      EXPECT_TRUE(from <= time && time <= to);
      ++seen;
    }
  }
  EXPECT_EQ(seen, input.annotations.size()) << "each in one part";
  Annotation region = test::note("over all");
  region.kind = AnnotationKind::region;
  region.place = {0, 0.0};
  region.until = {3, 1.0};
  input.annotations = {region};
  EXPECT_EQ(annotations_between(input, 0.4 * duration, 0.5 * duration).size(), 1U);
}

}  // namespace
}  // namespace feedscope::ui
