#include "ui/paper/pdf_file.h"

#include <gmock/gmock.h>

#include <QBuffer>
#include <QPainter>
#include <QPdfWriter>
#include <QPolygonF>
#include <cmath>

#include "tests/ui/report/pdf_reading.h"

namespace feedscope::ui {
namespace {

std::string three_pages() {
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  QPdfWriter writer(&buffer);
  QPainter painter(&writer);
  for (int page = 0; page < 3; ++page) {
    if (page > 0) {
      writer.newPage();
    }
    painter.drawText(1000, 1000, QStringLiteral("page"));
  }
  painter.end();
  return buffer.data().toStdString();
}

TEST(PdfFile, BookmarksAreReadBackAsATree) {
  const std::string pdf = finished_pdf(
      three_pages(), {"Title · ü",
                      "Somebody",
                      {},
                      {{1, "one", 0, 50}, {3, "deep", 0, 60}, {2, "part", 1, 10}, {1, "two", 2, 0}}});
  test::PdfReading reading(pdf);
  const auto bookmarks = reading.bookmarks();
  ASSERT_EQ(bookmarks.size(), 4U);
  const std::vector<std::tuple<int, std::string, int>> expected{
      {1, "one", 0}, {2, "deep", 0}, {2, "part", 1}, {1, "two", 2}};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(std::tuple(bookmarks[i].level, bookmarks[i].title, bookmarks[i].page), expected[i]);
  }
  EXPECT_EQ(reading.info("/Title"), "Title · ü");
  EXPECT_EQ(reading.info("/Author"), "Somebody");
  EXPECT_EQ(reading.page_count(), 3U);
}

TEST(PdfFile, LinksLeadToTheirPlaces) {
  PdfProperties properties{"t", {}, {}, {}};
  properties.links = {{0, QRectF(10, 20, 30, 8), "Figure 2", 2, 100}};
  const std::string pdf = finished_pdf(three_pages(), properties);
  test::PdfReading reading(pdf);
  const auto links = reading.links();
  ASSERT_EQ(links.size(), 1U);
  EXPECT_EQ(links[0].page, 0);
  EXPECT_EQ(links[0].title, "Figure 2");
  EXPECT_EQ(links[0].to_page, 2);
}

TEST(PdfFile, HoldsNoTimeUnlessAskedFor) {
  const std::string pdf = finished_pdf(three_pages(), {"t", {}, {}, {}});
  EXPECT_EQ(test::PdfReading(pdf).info("/CreationDate"), "");
  EXPECT_EQ(test::PdfReading(pdf).info("/Author"), "");
  const std::string dated = finished_pdf(three_pages(), {"t", {}, "D:20250131000000Z", {}});
  EXPECT_EQ(test::PdfReading(dated).info("/CreationDate"), "D:20250131000000Z");
}

TEST(PdfFile, TheSamePagesGiveTheSameBytes) {
  const PdfProperties properties{"t", {}, {}, {{1, "one", 0, 0}}};
  const std::string pages = three_pages();
  EXPECT_EQ(finished_pdf(pages, properties), finished_pdf(pages, properties));
}

TEST(PdfFile, CoordinatesAreRoundedToWhatAPrinterShows) {
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  QPdfWriter writer(&buffer);
  constexpr double dots_a_point = 1200 / 72.0;
  writer.setResolution(1200);
  QPainter painter(&writer);
  constexpr double scale = 12.5;
  painter.scale(scale, scale);
  QPolygonF line;
  for (int i = 0; i < 2000; ++i) {
    line.append({300 + 200 * std::sin(0.7 * i), 300 + 200 * std::cos(1.3 * i)});
  }
  painter.drawPolyline(line);
  painter.end();
  const std::string plain = buffer.data().toStdString();
  const std::string finished = finished_pdf(plain, {"t", {}, {}, {}});
  const auto exact = test::PdfReading(plain).line_ends(0);
  const auto rounded = test::PdfReading(finished).line_ends(0);
  ASSERT_EQ(exact.size(), rounded.size());
  ASSERT_GE(exact.size(), 1999U);
  for (std::size_t i = 0; i < exact.size(); ++i) {
    ASSERT_LE(std::abs(exact[i].first - rounded[i].first) / dots_a_point, 0.005) << i;
    ASSERT_LE(std::abs(exact[i].second - rounded[i].second) / dots_a_point, 0.005) << i;
  }
  EXPECT_LT(static_cast<double>(finished.size()), 0.75 * static_cast<double>(plain.size()));
}

}  // namespace
}  // namespace feedscope::ui
