#include "ui/theme/type_size.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QLabel>

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

}  // namespace
}  // namespace feedscope::ui
