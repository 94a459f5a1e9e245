#include "ui/identification/identification_texts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QLocale>

namespace feedscope::ui {
namespace {

using testing::HasSubstr;

IdentifiedParameter told(double value, double uncertainty) {
  IdentifiedParameter one;
  one.parameter = {"X.acceleration", "m/s2", 0, 100};
  one.value = value;
  one.uncertainty = uncertainty;
  one.told = true;
  return one;
}

class IdentificationTextsTest : public testing::Test {
 protected:
  IdentificationTextsTest() { QLocale::setDefault(QLocale::c()); }
};

TEST_F(IdentificationTextsTest, AValueHasTheDigitsThatItsUncertaintyLeaves) {
  EXPECT_EQ(IdentificationTexts::found(told(1.30021, 0.0123)), "1.300 ± 0.012");
  EXPECT_EQ(IdentificationTexts::found(told(0.0200051, 0.0000254)), "0.02001 ± 0.00003");
  EXPECT_EQ(IdentificationTexts::found(told(12345.6, 321)), "12346 ± 321");
  EXPECT_EQ(IdentificationTexts::found(told(75, 0)), "75.0000 ± 0.0000");
}

TEST_F(IdentificationTextsTest, WhatIsNotToldSaysWhatWouldTellIt) {
  IdentifiedParameter one = told(2, 0);
  one.told = false;
  one.start = 2;
  one.reason = "It changes nothing that these traces show.";
  EXPECT_EQ(IdentificationTexts::found(one), "not found");
  EXPECT_THAT(IdentificationTexts::explanation(one, true).toStdString(),
              HasSubstr("No part of the test program would show this value"));
  one.told_by = "SINGLE MOVES OF X";
  EXPECT_EQ(
      IdentificationTexts::explanation(one, true),
      "It changes nothing that these traces show. A recording of the test program tells it: part SINGLE "
      "MOVES OF X.");
  one.start = 1;
  EXPECT_THAT(IdentificationTexts::explanation(one, true).toStdString(), HasSubstr("show. In use: 2"));
  one.at_least = 12345;
  EXPECT_EQ(IdentificationTexts::found(one), "at least 12345");
  EXPECT_EQ(IdentificationTexts::explanation(one, false), "It changes nothing that these traces show.")
      << "a model that does not explain the recording says nothing of other recordings";
}

TEST_F(IdentificationTextsTest, ADriveSaysWhatOfTheFollowingErrorItExplains) {
  Identification found;
  found.drives = {
      {'X', {}, 4000, 0.0412, 0.00041, true}, {'Y', {}, 4000, 0.02, 0.011, false}, {'Z', {}, 0, 0, 0, false}};
  EXPECT_EQ(
      IdentificationTexts::drives(found).join('\n').toStdString(),
      "Drive of X: following error 41.2 µm (rms), 0.4 µm of it unexplained.\n"
      "Drive of Y: following error 20.0 µm (rms), 11.0 µm of it unexplained: too much to find its values.\n"
      "Drive of Z: not found.");
  IdentifiedParameter gain;
  gain.parameter = drive_parameter('X', 0);
  gain.value = 60;
  gain.uncertainty = 0.12;
  gain.told = true;
  EXPECT_EQ(IdentificationTexts::title(gain.parameter), "X Position gain Kv [1/s]");
  EXPECT_THAT(IdentificationTexts::explanation(gain, false).toStdString(),
              HasSubstr("if the drive is linear"));
}

TEST_F(IdentificationTextsTest, ANumberWithoutAValueIsADash) {
  EXPECT_EQ(IdentificationTexts::title({"X.jerk", "m/s3", 0, 1}), "X Jerk [m/s³]");
  EXPECT_EQ(IdentificationTexts::value(0, {"X.jerk", "m/s3", 0, 1}), "–");
  EXPECT_EQ(IdentificationTexts::value(15, {"X.jerk", "m/s3", 0, 1}), "15");
}

}  // namespace
}  // namespace feedscope::ui
