#include "ui/theme/type_size.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QComboBox>
#include <QImage>
#include <QLabel>
#include <QMainWindow>
#include <QSpinBox>

#include "ui/theme/theme.h"

namespace feedscope::ui {
namespace {

TEST(TypeSize, OneFactorMovesAllTypeThatFollowsAndBack) {
  apply_theme();
  QLabel plain;
  QLabel small;
  set_type_pixels(small, 10);
  plain.show();
  EXPECT_EQ(plain.font().pixelSize(), 12);
  EXPECT_EQ(small.font().pixelSize(), 10);
  TypeSize& size = TypeSize::of_application();
  size.set_scale(1.5);
  QCoreApplication::processEvents();
  EXPECT_EQ(plain.font().pixelSize(), 18);
  EXPECT_EQ(small.font().pixelSize(), 15);
  EXPECT_EQ(type_pixels(64), 96);
  apply_theme(ThemeKind::dark);
  EXPECT_EQ(QApplication::font().pixelSize(), 18) << "another theme keeps the size";
  size.set_scale(1);
  QCoreApplication::processEvents();
  EXPECT_EQ(plain.font().pixelSize(), 12);
  EXPECT_EQ(small.font().pixelSize(), 10);
}

TEST(TypeSize, StaysReadable) {
  TypeSize& size = TypeSize::of_application();
  size.set_scale(0);
  EXPECT_EQ(size.scale(), 0.5);
  size.set_scale(100);
  EXPECT_EQ(size.scale(), 8);
  size.set_scale(1);
}

TEST(TypeSize, LinesGrowWithTypeAndWithWindowsBeyond1920x1080) {
  QMainWindow window;
  window.setCentralWidget(new QLabel);
  QWidget& inside = *window.centralWidget();
  window.resize(1280, 800);
  EXPECT_EQ(line_pixels(1.5, inside), 1.5);
  window.resize(3840, 2160);
  EXPECT_EQ(line_pixels(1.5, inside), 3);
  window.resize(3840, 1080);
  EXPECT_EQ(line_pixels(1.5, inside), 1.5) << "wide, but not high";
  QLabel paper;
  paper.resize(3840, 2160);
  EXPECT_EQ(line_pixels(1.5, paper), 1.5) << "a picture has a size of its own";
  TypeSize::of_application().set_scale(2.5);
  EXPECT_EQ(line_pixels(2), 5);
  EXPECT_EQ(line_pixels(2, inside), 5);
  TypeSize::of_application().set_scale(1);
}

/// Dark pixels of a control that is drawn as large as the type asks for.
int dark_pixels(QWidget& widget) {
  widget.resize(widget.sizeHint());
  const QImage image = widget.grab().toImage();
  int dark = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      dark += image.pixelColor(x, y).lightness() < 100 ? 1 : 0;
    }
  }
  return dark;
}

TEST(TypeSize, ArrowsOfListsAndNumbersGrowWithType) {
  apply_theme();
  QComboBox list;
  QSpinBox number;
  number.setSpecialValueText(QStringLiteral(" "));
  number.setRange(0, 10);
  list.ensurePolished();
  const int list_before = dark_pixels(list);
  const int number_before = dark_pixels(number);
  TypeSize::of_application().set_scale(3);
  QCoreApplication::processEvents();
  EXPECT_GT(dark_pixels(list), 4 * list_before);
  EXPECT_GT(dark_pixels(number), 3 * number_before);
  TypeSize::of_application().set_scale(1);
  QCoreApplication::processEvents();
  EXPECT_EQ(dark_pixels(list), list_before);
}

}  // namespace
}  // namespace feedscope::ui
