#include "ui/report/page_fit.h"

#include <gmock/gmock.h>

#include "ui/report/paged_document.h"

namespace feedscope::ui {
namespace {

/// A section with a heading and an elastic picture.
QString fit_section(ReportPictures& pictures, const QString& name, double least, double largest) {
  const auto make = [](const QSizeF& size) { return ReportPicture{size, false, [](QPainter&, double) {}}; };
  return "<h2>" + name + "</h2>" +
         figure(pictures.add_elastic(name, 400, {make, least, largest}, name), "caption");
}

int pages_of_fit(const QString& html, const ReportPictures& pictures) {
  return static_cast<int>(PagedDocument(html, pictures).pages().size());
}

TEST(PageFit, ASectionAfterAFilledPageBeginsTheNextOne) {
  ReportPictures pictures;
  const QString html = "<html><head></head><body>" + fit_section(pictures, "a", 600, 800) + page_mark +
                       fit_section(pictures, "b", 100, 200);
  const QString fitted = with_filled_pages(html, pictures);
  EXPECT_TRUE(fitted.contains("<h2 style=\"page-break-before: always\">b</h2>"));
  EXPECT_EQ(pages_of_fit(fitted, pictures), 2);
  EXPECT_EQ(pictures.all().at("a").size.height(), 800);
}

TEST(PageFit, ASectionAfterLittleGoesOnThere) {
  ReportPictures pictures;
  const QString html = "<html><head></head><body>" + fit_section(pictures, "a", 200, 300) + page_mark +
                       fit_section(pictures, "b", 100, 400);
  const QString fitted = with_filled_pages(html, pictures);
  EXPECT_FALSE(fitted.contains("page-break"));
  EXPECT_EQ(pages_of_fit(fitted, pictures), 1);
}

TEST(PageFit, PicturesAreLoweredEvenlyUntilTheirPageHoldsThem) {
  ReportPictures pictures;
  const QString html = "<html><head></head><body>" + fit_section(pictures, "a", 200, 600) +
                       fit_section(pictures, "b", 200, 600);
  EXPECT_EQ(pages_of_fit(html, pictures), 2);
  const QString fitted = with_filled_pages(html, pictures);
  EXPECT_EQ(pages_of_fit(fitted, pictures), 1);
  const double height = pictures.all().at("a").size.height();
  EXPECT_EQ(height, pictures.all().at("b").size.height());
  EXPECT_GT(height, 350);
  EXPECT_TRUE(fitted.contains(QStringLiteral("height=\"%1\"").arg(height)));
}

}  // namespace
}  // namespace feedscope::ui
