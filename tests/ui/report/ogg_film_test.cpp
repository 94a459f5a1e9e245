#include "ui/film/ogg_film.h"

#include <gmock/gmock.h>

#include <QColor>
#include <QFile>
#include <QTemporaryDir>

#include "core/base/error.h"

namespace feedscope::ui {
namespace {

class OggFilmTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!OggFilm::is_available()) {
      GTEST_SKIP() << "VTK has no IOOggTheora";
    }
  }

  static QImage plain(QRgb colour) {
    QImage image(96, 64, QImage::Format_RGB32);
    image.fill(colour);
    return image;
  }

  QTemporaryDir folder_;
};

/// Of the identification header (Theora specification, 6.2): the size of the picture at byte 14, the rate of
/// frames at byte 22, both with the highest byte first.
TEST_F(OggFilmTest, IsAnOggFileWithAVideoOfThatSizeAndRate) {
  const std::string name = folder_.filePath("film.ogv").toStdString();
  {
    OggFilm film(name, 30, "film.ogv");
    for (const QRgb colour : {0xffff0000, 0xff00ff00, 0xff0000ff}) {
      film.add(plain(colour));
    }
    film.finish();
  }
  QFile file(QString::fromStdString(name));
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  const QByteArray bytes = file.readAll();
  EXPECT_TRUE(bytes.startsWith("OggS"));
  const qsizetype header = bytes.indexOf(QByteArray("\x80theora", 7));
  ASSERT_GE(header, 0);
  const auto number = [&](qsizetype at, int count) {
    int value = 0;
    for (int i = 0; i < count; ++i) {
      value = 256 * value + static_cast<unsigned char>(bytes[header + at + i]);
    }
    return value;
  };
  EXPECT_EQ(number(14, 3), 96);
  EXPECT_EQ(number(17, 3), 64);
  EXPECT_EQ(number(22, 4), 30 * number(26, 4));
}

TEST_F(OggFilmTest, SaysWhenItCannotBeWritten) {
  const auto write = [](const std::string& name) {
    OggFilm film(name, 25, "it.ogv");
    film.add(plain(0xff808080));
    film.finish();
  };
  for (const std::string& file :
       {folder_.filePath("none/film.ogv").toStdString(), std::string("/dev/full")}) {
    EXPECT_THAT([&] { write(file); },
                testing::ThrowsMessage<InputError>(testing::HasSubstr("cannot write 'it.ogv'")))
        << file;
  }
}

}  // namespace
}  // namespace feedscope::ui
