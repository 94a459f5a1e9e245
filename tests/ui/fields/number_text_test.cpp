#include "ui/fields/number_text.h"

#include <gtest/gtest.h>

#include <QLocale>
#include <random>

namespace feedscope::ui {
namespace {

TEST(NumberText, BothDecimalSignsMeanTheSame) {
  for (const char* text : {"0.02", "0,02", " 0,02 ", "+0.02", ".02", ",02", "2e-2", "0,2e-1"}) {
    ASSERT_TRUE(number_of(text).has_value()) << text;
    EXPECT_EQ(*number_of(text), 0.02) << text;
  }
  EXPECT_EQ(number_of("1,000"), 1);
  EXPECT_EQ(number_of("5."), 5);
  EXPECT_EQ(number_of(QString(QChar(0x2212)) + "3,5"), -3.5);
}

TEST(NumberText, WhatIsNoNumberIsNone) {
  for (const char* text : {"", ".", ",", "-", "1,000.5", "1.000,5", "1,0,0", "0,01,", "1 000", "1.5 mm",
                           "nan", "inf", "1e999", "0x10", "1e"}) {
    EXPECT_FALSE(number_of(text).has_value()) << text;
  }
}

TEST(NumberText, AnEditableTextGivesItsNumberBackInEveryLanguage) {
  const QLocale before;
  std::minstd_rand random(5);
  for (const char* language : {"C", "en", "fr", "de"}) {
    QLocale::setDefault(QLocale(language));
    for (int i = 0; i < 1000; ++i) {
      const double number = std::uniform_real_distribution<double>(-1e7, 1e7)(random);
      EXPECT_EQ(number_of(editable_text(number)), number) << language;
    }
  }
  QLocale::setDefault(before);
}

}  // namespace
}  // namespace feedscope::ui
