#include <gmock/gmock.h>

#include <QAbstractTextDocumentLayout>
#include <QRegularExpression>
#include <QSvgRenderer>
#include <QTextBlock>
#include <QTextDocument>
#include <QTextTable>

#include "tests/ui/report/pdf_reading.h"
#include "tests/ui/report/report_fixture.h"
#include "ui/report/page_breaks.h"
#include "ui/report/report.h"

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
  ReportInput input = test::two_runs();
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
  EXPECT_GE(pdf.images().size(), 3U);
  const auto bookmarks = pdf.bookmarks();
  ASSERT_FALSE(bookmarks.empty());
  EXPECT_EQ(bookmarks.front().title, "Flange <b> & lid");
  using Bookmark = test::PdfReading::Bookmark;
  for (const char* title : {"Settings that differ", "Where most time is lost", "Program", "Control models"}) {
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
  static const QRegularExpression source("src=\"data:image/(png|svg\\+xml);base64,([^\"]*)\"");
  int pictures = 0;
  for (auto found = source.globalMatch(html); found.hasNext();) {
    const QRegularExpressionMatch match = found.next();
    const QByteArray bytes = QByteArray::fromBase64(match.captured(2).toLatin1());
    const bool raster = match.captured(1) == "png";
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
  EXPECT_THAT(made(input, ReportFormat::html), Not(HasSubstr("Where most time is lost")));
}

TEST(Report, CanBeCancelled) {
  Progress progress;
  progress.cancel();
  EXPECT_THROW(make_report(test::two_runs(), load_report_template(), ReportFormat::pdf, &progress),
               Cancelled);
}

/// Pages of `height`, text of one size.
void lay_out(QTextDocument& document, const QString& html, double height) {
  QFont font(QStringLiteral("DejaVu Sans"));
  font.setPixelSize(11);
  document.setDefaultFont(font);
  document.setDocumentMargin(0);
  document.setHtml(html);
  document.setPageSize({400, height});
  keep_together(document, height);
}

int page_of(const QTextDocument& document, const QTextBlock& block, double height) {
  return static_cast<int>(document.documentLayout()->blockBoundingRect(block).top() / height);
}

TEST(PageBreaks, AHeadingStaysWithWhatFollows) {
  constexpr double height = 300;
  for (int lines = 0; lines < 30; ++lines) {
    QTextDocument document;
    const QString filler = QStringLiteral("<p>line</p>").repeated(lines);
    lay_out(document, filler + "<h2>Head</h2><h3>Part</h3><p>text</p>", height);
    QTextBlock text = document.lastBlock();
    EXPECT_EQ(page_of(document, text.previous(), height), page_of(document, text, height)) << lines;
    EXPECT_EQ(page_of(document, text.previous().previous(), height), page_of(document, text, height))
        << lines;
  }
}

TEST(PageBreaks, ARowOfATableIsNotCut) {
  constexpr double height = 300;
  for (int lines = 0; lines < 24; ++lines) {
    QTextDocument document;
    const QString cell = QStringLiteral("<td>%1</td>").arg(QStringLiteral("word<br/>").repeated(4));
    lay_out(document,
            QStringLiteral("<p>line</p>").repeated(lines) + "<table>" +
                QStringLiteral("<tr>%1%1</tr>").arg(cell).repeated(6) + "</table>",
            height);
    for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
      const QTextLayout& layout = *block.layout();
      if (layout.lineCount() > 1) {
        const double top = document.documentLayout()->blockBoundingRect(block).top();
        const double first = top + layout.lineAt(0).y();
        const double last = top + layout.lineAt(layout.lineCount() - 1).y();
        EXPECT_EQ(static_cast<int>(first / height), static_cast<int>(last / height)) << lines;
      }
    }
  }
}

}  // namespace
}  // namespace feedscope::ui
