#include "ui/language/texts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/ui/locale_in_force.h"

namespace feedscope::ui {
namespace {

TEST(ClockText, IsOfSecondsMinutesAndHours) {
  const test::LocaleInForce locale(QLocale::c());
  EXPECT_EQ(clock_text(0.0123), "12.3\u00a0ms");
  EXPECT_EQ(clock_text(12.3456), "12.3\u00a0s");
  EXPECT_EQ(clock_text(59.9999), "1:00.0");
  EXPECT_EQ(clock_text(60), "1:00.0");
  EXPECT_EQ(clock_text(185.29), "3:05.3");
  EXPECT_EQ(clock_text(3599.99), "1:00:00");
  EXPECT_EQ(clock_text(3600), "1:00:00");
  EXPECT_EQ(clock_text(16741), "4:39:01");
}

TEST(ClockText, SaysTheTimeThatItIsGiven) {
  const test::LocaleInForce locale(QLocale::c());
  std::mt19937 random(3);
  std::uniform_real_distribution<double> exponent(1.8, 6);
  for (int i = 0; i < 1000; ++i) {
    const double seconds = std::pow(10, exponent(random));
    const QStringList parts = clock_text(seconds).split(':');
    double said = 0;
    for (const QString& part : parts) {
      said = 60 * said + part.toDouble();
      EXPECT_TRUE(&part == &parts.first() || part.toDouble() < 60) << parts.join(':').toStdString();
    }
    EXPECT_NEAR(said, seconds, seconds < 3600 ? 0.0501 : 0.501) << parts.join(':').toStdString();
  }
}

}  // namespace
}  // namespace feedscope::ui
