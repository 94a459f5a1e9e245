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
  EXPECT_EQ(number_of("5."), 5);
  EXPECT_EQ(number_of(QString(QChar(0x2212)) + "3,5"), -3.5);
}

TEST(NumberText, ACommaThatCouldGroupThousandsIsTakenOnlyWhereItIsTheDecimalSign) {
  for (const char* text : {"1,000", "-25,400", "999,999"}) {
    EXPECT_FALSE(number_of(text, QLocale("en")).has_value()) << text;
    EXPECT_FALSE(number_of(text, QLocale("de_CH")).has_value()) << text;
    EXPECT_EQ(number_of(text, QLocale("fr")), QString(text).replace(',', '.').toDouble());
    EXPECT_EQ(number_of(text, QLocale("de")), QString(text).replace(',', '.').toDouble());
  }
  for (const char* text : {"0,125", "1,0000", "1234,567", "12,5"}) {
    EXPECT_EQ(number_of(text, QLocale("en")), QString(text).replace(',', '.').toDouble());
  }
}

TEST(NumberText, ATextThatIsNoNumberIsToldWhy) {
  const QLocale english("en");
  EXPECT_EQ(number_problem("1,000", english), "“1,000” could be 1.000 or 1000; type one of these.");
  EXPECT_EQ(number_problem("12,345.6", english),
            "“12,345.6” has more than one decimal separator or uses thousands separators; type 12345.6.");
  EXPECT_EQ(number_problem("1.000,5", english),
            "“1.000,5” has more than one decimal separator or uses thousands separators; type 1000.5.");
  EXPECT_EQ(number_problem("1.000,5", QLocale("de")), number_problem("1.000,5", english));
  EXPECT_EQ(number_problem("1/4", english), "“1/4” is not a number.");
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
