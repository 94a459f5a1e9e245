#include "ui/fields/number_box.h"

#include <gtest/gtest.h>

#include <QLineEdit>
#include <QTest>
#include <QToolTip>
#include <cmath>
#include <random>
#include <utility>

#include "ui/fields/number_text.h"

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
  EXPECT_EQ(typed("12"), 12);
  EXPECT_EQ(typed("5e-1"), 0.5);
}

TEST_P(NumberBoxTest, ACommaThatCouldGroupThousandsIsRefusedUnlessItIsTheDecimalSign) {
  typed("3");
  EXPECT_EQ(typed("1,000"), QLocale(GetParam()).decimalPoint() == "," ? 1 : 3);
  EXPECT_EQ(typed("2.000"), 2);
}

/// What a key enters is never left out: "1/4" without its middle is 14.
TEST_P(NumberBoxTest, KeysThatMakeNoNumberChangeNothing) {
  std::minstd_rand random(9);
  const QString keys = QStringLiteral("0123456789.,eE+-/*' m");
  for (int i = 0; i < 300; ++i) {
    QString text;
    for (auto left = 1 + random() % 7; left > 0; --left) {
      text += keys[static_cast<qsizetype>(random() % static_cast<unsigned>(keys.size()))];
    }
    box.setValue(7);
    const double value = typed(text);
    const auto number = number_of(text, box.locale());
    EXPECT_TRUE(value == 7 || (number && std::abs(*number - value) < 1e-9)) << text.toStdString();
  }
}

TEST_P(NumberBoxTest, SaysWhyATextIsNotTaken) {
  box.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&box));
  box.setValue(7);
  for (const auto& [text, reason] : {std::pair{"1,2,3", "“1,2,3” has more than one decimal separator"},
                                     {"200", "“200” is not between 0 and 100."},
                                     {"0.00001", "“0.00001” has too many decimals; the smallest step is "},
                                     {"x", "“x” is not a number."}}) {
    EXPECT_EQ(typed(text), 7);
    EXPECT_TRUE(QToolTip::text().startsWith(reason)) << QToolTip::text().toStdString();
    QToolTip::hideText();
  }
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
