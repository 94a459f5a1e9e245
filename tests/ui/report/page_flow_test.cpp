#include "ui/paper/page_flow.h"

#include <gtest/gtest.h>

#include <QAbstractTextDocumentLayout>
#include <QTextBlock>
#include <QTextDocument>
#include <QTextTable>
#include <random>

#include "tests/ui/report/page_checks.h"

namespace feedscope::ui {
namespace {

constexpr double height = 300;

/// Text of one size in a narrow column.
void lay_out(QTextDocument& document, const QString& html) {
  QFont font(QStringLiteral("DejaVu Sans"));
  font.setPixelSize(11);
  document.setDefaultFont(font);
  document.setDocumentMargin(0);
  document.setHtml(html);
  document.setTextWidth(400);
}

QString paragraph(int words) {
  return QStringLiteral("<p>%1</p>").arg(QStringLiteral("word ").repeated(words));
}

QString table(int rows, int lines, int heads) {
  QString html = QStringLiteral("<table width=\"100%\" cellpadding=\"3\">");
  if (heads > 0) {
    html += QStringLiteral("<thead><tr><th>one</th><th>two</th></tr></thead>");
  }
  const QString cell = QStringLiteral("<td>%1</td>").arg(QStringList(lines, "cell").join("<br/>"));
  return html + QStringLiteral("<tr><td>a</td>%1</tr>").arg(cell).repeated(rows) + "</table>";
}

TEST(PageFlow, AHeadingStaysWithWhatFollows) {
  for (int lines = 0; lines < 30; ++lines) {
    QTextDocument document;
    const QString filler = QStringLiteral("<p>line</p>").repeated(lines);
    lay_out(document, filler + "<h2>Head</h2><h3>Part</h3><p>text</p>");
    test::check_pages(document, page_parts(document, height), height);
  }
}

/// The rule below the last line of a form is at the end of its row, which is higher than its text.
TEST(PageFlow, TheLastRowOfATableIsDrawnToItsEnd) {
  for (const char* after : {"", "<h2>Next</h2><p>text</p>"}) {
    QTextDocument document;
    lay_out(document, paragraph(20) +
                          "<table width=\"100%\"><tr><td style=\"padding-bottom: 40px\">.</td></tr></table>" +
                          after);
    QTextFrame& form = *document.rootFrame()->childFrames().front();
    const double end = document.documentLayout()->frameBoundingRect(&form).bottom();
    const std::vector<PagePart> pages = page_parts(document, end + 4);
    EXPECT_GE(pages.front().clip_bottom, end) << after;
    EXPECT_EQ(pages.size(), *after == 0 ? 1U : 2U);
  }
}

/// The page on which a text begins.
std::size_t page_of(const QTextDocument& document, const std::vector<PagePart>& pages, const QString& text) {
  for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
    if (block.text() == text) {
      const double top = document.documentLayout()->blockBoundingRect(block).top();
      for (std::size_t page = 0; page < pages.size(); ++page) {
        if (top < pages[page].bottom) {
          return page;
        }
      }
    }
  }
  ADD_FAILURE() << "no text " << text.toStdString();
  return pages.size();
}

TEST(PageFlow, ASentenceThatIntroducesStaysWithWhatFollows) {
  for (int lines = 0; lines < 30; ++lines) {
    QTextDocument document;
    const QString filler = QStringLiteral("<p>line</p>").repeated(lines);
    lay_out(document, filler +
                          "<h2>Head</h2><p>What it is.</p><h3>Part</h3><p>text</p><p>of it</p>"
                          "<p>They are:</p><ul><li>first</li><li>second</li></ul>");
    const std::vector<PagePart> pages = page_parts(document, height);
    EXPECT_EQ(page_of(document, pages, "Head"), page_of(document, pages, "Part")) << lines;
    EXPECT_EQ(page_of(document, pages, "They are:"), page_of(document, pages, "first")) << lines;
    test::check_pages(document, pages, height);
  }
}

TEST(PageFlow, ARowOfATableIsNotCut) {
  for (int lines = 0; lines < 24; ++lines) {
    QTextDocument document;
    lay_out(document, QStringLiteral("<p>line</p>").repeated(lines) + table(6, 4, 0));
    test::check_pages(document, page_parts(document, height), height);
  }
}

TEST(PageFlow, HeadsOfATableThatGoesOnAreRepeated) {
  QTextDocument document;
  lay_out(document, paragraph(10) + table(60, 1, 1) + paragraph(10));
  const std::vector<PagePart> pages = page_parts(document, height);
  ASSERT_GE(pages.size(), 4U);
  EXPECT_EQ(pages.front().head(), 0);
  EXPECT_GT(pages[1].head(), 10);
  EXPECT_LT(pages[1].head(), 40);
  EXPECT_EQ(pages[2].head(), pages[1].head());
  test::check_pages(document, pages, height);
}

TEST(PageFlow, APageThatIsAskedForBeginsThere) {
  QTextDocument document;
  lay_out(document, paragraph(200) + "<h1 style=\"page-break-before: always\">Answers</h1>" + paragraph(20));
  const std::vector<PagePart> pages = page_parts(document, height);
  ASSERT_EQ(pages.size(), 2U);
  EXPECT_NEAR(pages[1].top,
              document.documentLayout()->blockBoundingRect(document.lastBlock().previous()).top(), 1);
}

TEST(PageFlow, ACellThatNoPageHoldsIsCutBetweenItsLines) {
  QTextDocument document;
  lay_out(document, paragraph(10) + table(1, 80, 0) + paragraph(10));
  const std::vector<PagePart> pages = page_parts(document, height);
  EXPECT_GE(pages.size(), 4U);
  test::check_pages(document, pages, height);
}

TEST(PageFlow, NothingIsOnePage) {
  QTextDocument document;
  lay_out(document, {});
  EXPECT_EQ(page_parts(document, height).size(), 1U);
}

/// Every way in which texts, headings, notes and tables, one inside the other, may follow each other.
TEST(PageFlow, HoldsWhatItPromisesForRandomDocuments) {
  std::mt19937 random(14);
  const auto up_to = [&](unsigned most) { return static_cast<int>(random() % most); };
  for (int i = 0; i < 150; ++i) {
    QString html;
    const int pieces = 4 + up_to(24);
    for (int piece = 0; piece < pieces; ++piece) {
      switch (up_to(7)) {
        case 0:
          html += QStringLiteral("<h%1>Head</h%1>").arg(1 + up_to(3)) + paragraph(1 + up_to(60));
          break;
        case 1:
          html += "<h2>Head</h2>" + paragraph(3) + table(1 + up_to(4), 1 + up_to(2), up_to(2));
          break;
        case 2:
          html += table(1 + up_to(9), 1, up_to(2)) + "<p style=\"font-size: 9px\">A note.</p>";
          break;
        case 3:
          html += "<table width=\"100%\"><tr><td><h2>Question</h2>" + paragraph(1 + up_to(30)) +
                  table(3, 1, 0) + "</td></tr></table>";
          break;
        default:
          html += paragraph(1 + up_to(120));
      }
    }
    QTextDocument document;
    lay_out(document, html);
    SCOPED_TRACE(testing::Message() << "seed 14, document " << i << ": " << html.toStdString());
    test::check_pages(document, page_parts(document, height), height);
    if (HasFailure()) {
      break;
    }
  }
}

}  // namespace
}  // namespace feedscope::ui
