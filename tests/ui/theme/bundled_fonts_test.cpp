// Runs on a system without any font: the configuration of the fonts is an empty one.
#include "ui/theme/bundled_fonts.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QFile>
#include <QImage>
#include <QPainter>
#include <QRawFont>
#include <QTemporaryDir>
#include <array>
#include <filesystem>
#include <set>
#include <string>

#include "tests/support/folders.h"

namespace feedscope::ui {
namespace {

QImage drawn(const QFont& font, QChar letter) {
  QImage image(40, 40, QImage::Format_RGB32);
  image.fill(Qt::white);
  QPainter painter(&image);
  painter.setFont(font);
  painter.drawText(image.rect(), Qt::AlignCenter, QString(letter));
  return image;
}

/// A letter without a glyph is a box, and all boxes are the same.
TEST(BundledFonts, DrawEveryLetterOnASystemWithoutFonts) {
  ASSERT_EQ(drawn(QApplication::font(), 'A'), drawn(QApplication::font(), 'B')) << "the system has fonts";
  add_missing_fonts();
  QFont bold = QApplication::font();
  bold.setBold(true);
  QFont italic = QApplication::font();
  italic.setItalic(true);
  for (QFont font : {QApplication::font(), bold, italic, QFont(QStringLiteral("DejaVu Sans")),
                     QFont(QStringLiteral("DejaVu Sans Mono"))}) {
    font.setPixelSize(24);
    const QString letters = QString::fromUtf8("ABCXYZabcxyz0123456789µ°²³×−…éç");
    for (int i = 0; i < letters.size(); ++i) {
      EXPECT_NE(drawn(font, letters[i]), drawn(font, QChar(0xFFFF))) << i;
      for (int k = 0; k < i; ++k) {
        EXPECT_NE(drawn(font, letters[i]), drawn(font, letters[k])) << font.family().toStdString() << i << k;
      }
    }
  }
}

std::set<char32_t> letters_of(const std::filesystem::path& file) {
  QFile text(QString::fromStdString(file.string()));
  EXPECT_TRUE(text.open(QIODevice::ReadOnly)) << file;
  const std::u32string letters = QString::fromUtf8(text.readAll()).toStdU32String();
  return {letters.begin(), letters.end()};
}

/// Texts of the program, their translations, the machines and the lessons.
TEST(BundledFonts, HaveEveryLetterOfTheProgramsTexts) {
  add_missing_fonts();
  const std::set<std::string> kinds{".cpp", ".h", ".ts", ".toml", ".md", ".html"};
  QFont bold(QStringLiteral("DejaVu Sans"));
  bold.setBold(true);
  QFont italic(QStringLiteral("DejaVu Sans"));
  italic.setItalic(true);
  const std::array fonts{QRawFont::fromFont(QFont(QStringLiteral("DejaVu Sans"))), QRawFont::fromFont(bold),
                         QRawFont::fromFont(italic)};
  std::size_t seen = 0;
  for (const char* folder : {"app", "core", "ui", "machines", "resources"}) {
    const std::filesystem::path root = std::filesystem::path(FEEDSCOPE_SOURCE_DIR) / folder;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root)) {
      if (!kinds.contains(entry.path().extension().string())) {
        continue;
      }
      for (const char32_t letter : letters_of(entry.path())) {
        for (const QRawFont& font : fonts) {
          EXPECT_TRUE(letter < U' ' || font.supportsCharacter(letter))
              << "U+" << std::hex << static_cast<unsigned>(letter) << " of " << entry.path() << " is not in "
              << font.familyName().toStdString() << " " << font.styleName().toStdString();
        }
        ++seen;
      }
    }
  }
  EXPECT_GT(seen, 10000U);
}

}  // namespace
}  // namespace feedscope::ui

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  const QTemporaryDir folder;
  QFile fonts(folder.filePath(QStringLiteral("fonts.conf")));
  if (!fonts.open(QIODevice::WriteOnly)) {
    return 1;
  }
  fonts.write("<?xml version=\"1.0\"?><fontconfig></fontconfig>");
  fonts.close();
  qputenv("FONTCONFIG_FILE", fonts.fileName().toLocal8Bit());
  qputenv("QT_QPA_PLATFORM", "offscreen");
  const QApplication application(argc, argv);
  return RUN_ALL_TESTS();
}
