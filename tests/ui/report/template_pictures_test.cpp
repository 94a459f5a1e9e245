#include "ui/report/template_pictures.h"

#include <gmock/gmock.h>

#include <QBuffer>
#include <QFile>
#include <QImage>
#include <QTemporaryDir>

#include "core/base/error.h"
#include "tests/ui/report/pdf_reading.h"
#include "ui/report/paged_document.h"
#include "ui/report/paged_pdf.h"

namespace feedscope::ui {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class TemplatePictures : public testing::Test {
 protected:
  TemplatePictures() {
    QImage logo(48, 24, QImage::Format_RGB32);
    logo.fill(QColor(0x12, 0x34, 0x56));
    logo.save(folder_.filePath("logo.png"));
    write(
        "logo.svg",
        R"(<svg xmlns="http://www.w3.org/2000/svg" width="40" height="20"><rect width="40" height="20"/></svg>)");
    write("text.png", "no picture");
  }
  void write(const QString& name, const QByteArray& bytes) const {
    QFile file(folder_.filePath(name));
    file.open(QIODevice::WriteOnly);
    file.write(bytes);
  }
  QString page(const QString& body) const {
    return with_pictures_inside(body, folder_.filePath("page.html"));
  }
  std::string refusal(const QString& body) const {
    try {
      page(body);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

  QTemporaryDir folder_;
};

TEST_F(TemplatePictures, AreTakenIntoThePage) {
  for (const char* name : {"logo.png", "./logo.png", "logo.svg"}) {
    const QString filled =
        page(QStringLiteral("<p>a</p><img alt='x' src=\"%1\" width=\"20\"/><p>b</p>").arg(name));
    EXPECT_TRUE(filled.startsWith("<p>a</p><img alt='x' src=\"data:image/")) << name;
    EXPECT_TRUE(filled.endsWith("\" width=\"20\"/><p>b</p>")) << name;
    EXPECT_EQ(page(filled), filled) << "once is enough";
  }
  EXPECT_EQ(page("<img src='picture:view'/>{{view}}"), "<img src='picture:view'/>{{view}}");
}

/// The bytes of most photographs contain a '<'.
TEST_F(TemplatePictures, APictureOfManyColoursIsNoDrawing) {
  QImage photograph(64, 64, QImage::Format_RGB32);
  for (int i = 0; i < 64 * 64; ++i) {
    photograph.setPixel(i % 64, i / 64, qRgb(i * 7 % 251, i * 31 % 241, i * 53 % 239));
  }
  photograph.save(folder_.filePath("photograph.png"));
  QFile file(folder_.filePath("photograph.png"));
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  ASSERT_TRUE(file.read(1024).contains('<'));
  EXPECT_TRUE(page("<img src='photograph.png'/>").contains("data:image/png;base64,"));
}

TEST_F(TemplatePictures, AreInThePdfFile) {
  const std::string pdf = paged_pdf(page("<img src='logo.png'/>"), ReportPictures(), {"t", {}, {}});
  EXPECT_THAT(test::PdfReading(pdf).images(), testing::ElementsAre(std::pair(48, 24)));
}

TEST_F(TemplatePictures, KeepTheirShapeAndFitThePage) {
  const auto height = [&](const QString& attributes) {
    const PagedDocument document(page("<img src='logo.png' " + attributes + "/>"), ReportPictures());
    return document.pages().front().used();
  };
  EXPECT_NEAR(height("width='96'"), 48, 6);
  EXPECT_NEAR(height("height='96'"), 96, 6);
  EXPECT_NEAR(height(""), 24, 6);
  EXPECT_NEAR(height("width='5000'"), report_width / 2, 6);
}

TEST_F(TemplatePictures, ThatCannotBeHadAreErrorsWithTheirPlace) {
  EXPECT_THAT(refusal("<p>\n\n<img src=\"none.png\"/>"),
              AllOf(HasSubstr("page.html:3:"), HasSubstr("'none.png'")));
  EXPECT_THAT(refusal("<img src=\"text.png\"/>"), HasSubstr("is not a picture"));
  EXPECT_THAT(refusal("\n<img src=\"https://a.b/logo.png\"/>"),
              AllOf(HasSubstr("page.html:2:"), HasSubstr("is a URL")));
  EXPECT_THAT(refusal("<img src='data:image/png;base64,AAAA'/>"), HasSubstr("contains no picture"));
  EXPECT_THAT(refusal("<link rel='stylesheet' href='own.css'/>"), HasSubstr("<style>"));
}

}  // namespace
}  // namespace feedscope::ui
