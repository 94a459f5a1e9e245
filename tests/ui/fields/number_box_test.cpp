#include "ui/fields/number_box.h"

#include <gtest/gtest.h>

#include <QLineEdit>
#include <QTest>

namespace feedscope::ui {
namespace {

class NumberBoxTest : public testing::TestWithParam<const char*> {
 protected:
  NumberBoxTest() {
    box.setLocale(QLocale(GetParam()));
    box.setDecimals(4);
    box.setRange(0, 100);
    box.setSuffix(" mm");
    box.setValue(1);
  }

  double typed(const QString& text) {
    auto* line = box.findChild<QLineEdit*>();
    line->selectAll();
    QTest::keyClicks(line, text);
    QTest::keyClick(line, Qt::Key_Return);
    return box.value();
  }

  NumberBox box;
};

TEST_P(NumberBoxTest, TakesBothDecimalSigns) {
  EXPECT_EQ(typed("0.02"), 0.02);
  EXPECT_EQ(typed("0,05"), 0.05);
  EXPECT_EQ(typed(",5"), 0.5);
  EXPECT_EQ(typed("1,000"), 1);
  EXPECT_EQ(typed("12"), 12);
}

TEST_P(NumberBoxTest, ShowsTheDecimalSignOfTheLanguage) {
  typed("0.02");
  EXPECT_EQ(box.text(), "0" + QLocale(GetParam()).decimalPoint() + "0200 mm");
}

TEST_P(NumberBoxTest, WhatIsNoNumberOrOutOfRangeLeavesTheValue) {
  typed("3");
  box.setMinimum(0.01);
  for (const char* text : {"", ".", "0,0", "0,005", "-", "1,000.5", "1.2,5", "150", "-5", "0.12345"}) {
    EXPECT_EQ(typed(text), 3) << text;
  }
}

TEST_P(NumberBoxTest, ASpecialTextIsTheLeastValue) {
  box.setSpecialValueText("–");
  box.setValue(0);
  EXPECT_EQ(box.text(), "–");
  EXPECT_EQ(typed("0,5"), 0.5);
}

INSTANTIATE_TEST_SUITE_P(Languages, NumberBoxTest, testing::Values("C", "en", "fr", "de", "de_CH"));

}  // namespace
}  // namespace feedscope::ui
