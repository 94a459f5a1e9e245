#include "ui/language/shown_numbers.h"

#include <gtest/gtest.h>

#include <QLocale>

#include "ui/language/language.h"

namespace feedscope::ui {
namespace {

class ShownNumbers : public testing::Test {
 protected:
  ShownNumbers() { QLocale::setDefault(QLocale::c()); }
  ~ShownNumbers() override { use_unit_system(UnitSystem::metric); }
};

TEST_F(ShownNumbers, AreMetricAtFirst) {
  EXPECT_EQ(amount_text(12.3456, Dimension::length), "12.346 mm");
  EXPECT_EQ(amount_text(50, Dimension::feed), "3000 mm/min");
  EXPECT_EQ(amount_text(0.0123, Dimension::error), "12.3 µm");
  EXPECT_EQ(with_unit_of("Error", Dimension::error), "Error [µm]");
  EXPECT_EQ(with_unit_of("Run", Dimension::number), "Run");
}

/// Their unit is a word in each language.
TEST_F(ShownNumbers, TurnsAreShownInTheLanguage) {
  EXPECT_EQ(key_unit("rev/s3").text.toStdString(), "rev/s³");
  EXPECT_EQ(key_unit("rev/s3").factor, 1);
  EXPECT_EQ(key_unit("deg").text.toStdString(), "°");
  install_language("fr");
  EXPECT_EQ(unit_of(Dimension::turning).toStdString(), "tr/min");
  EXPECT_EQ(key_unit("rev/s3").text.toStdString(), "tr/s³");
  install_language("en");
  QLocale::setDefault(QLocale::c());
}

TEST_F(ShownNumbers, AreInchesWhereTheyAreChosen) {
  use_unit_system(UnitSystem::inch);
  EXPECT_EQ(amount_text(25.4, Dimension::length), "1.0000 in");
  EXPECT_EQ(amount_text(25.4 / 60, Dimension::feed), "1.0 in/min");
  EXPECT_EQ(amount_text(0.0254, Dimension::error), "1.00 thou");
  EXPECT_EQ(amount_text(1.5, Dimension::time), "1.500 s") << "time has one unit";
  EXPECT_EQ(significant_text(0.508, Dimension::length, 4), "0.02 in");
}

TEST_F(ShownNumbers, HaveAboutTheSameResolutionInBothSystems) {
  EXPECT_EQ(decimals_of(Dimension::length, 4), 4);
  EXPECT_EQ(decimals_of(Dimension::error, 3), 3);
  use_unit_system(UnitSystem::inch);
  EXPECT_EQ(decimals_of(Dimension::length, 4), 5);
  EXPECT_EQ(decimals_of(Dimension::error, 3), 4);
  EXPECT_EQ(decimals_of(Dimension::jerk, -1), 0);
}

TEST_F(ShownNumbers, ComeBackFromTheUnitShown) {
  for (const UnitSystem system : {UnitSystem::metric, UnitSystem::inch}) {
    use_unit_system(system);
    for (const Dimension dimension :
         {Dimension::length, Dimension::error, Dimension::feed, Dimension::jerk}) {
      EXPECT_NEAR(from_shown_unit(in_shown_unit(3.7, dimension), dimension), 3.7, 1e-12);
    }
  }
}

TEST_F(ShownNumbers, OfKeysHaveTheFactorToTheirOwnUnit) {
  EXPECT_EQ(key_unit("m/s3").factor, 1);
  EXPECT_EQ(key_unit("m/s3").text, "m/s³");
  use_unit_system(UnitSystem::inch);
  EXPECT_NEAR(key_unit("mm").factor, 1 / 25.4, 1e-15);
  EXPECT_NEAR(key_unit("m/min").factor, 1000 / 25.4, 1e-9);
  EXPECT_NEAR(key_unit("m/s2").factor, 1000 / 25.4, 1e-9);
  EXPECT_EQ(key_unit("m/s2").text, "in/s²");
  EXPECT_EQ(key_unit("s").factor, 1);
  EXPECT_EQ(key_unit("").text, "");
}

}  // namespace
}  // namespace feedscope::ui
