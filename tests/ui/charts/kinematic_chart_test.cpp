#include "ui/charts/kinematic_chart.h"

#include <gtest/gtest.h>

#include <QValueAxis>
#include <array>
#include <cmath>

namespace feedscope::ui {
namespace {

double as_it_is(double value) {
  return value;
}

/// A chart of jerks in which the tangential one may be cut.
class JerkChart : public testing::Test {
 protected:
  JerkChart()
      : chart_({"Jerk",
                "mm/s3",
                {{Channel::tangential_jerk, "jt", "tangential", CurveRole::path, 1, true},
                 {Channel::jerk_x, "jx", "X", CurveRole::x},
                 {Channel::jerk_y, "jy", "Y", CurveRole::y}},
                as_it_is},
               range_, true) {
    chart_.resize(600, 300);
  }

  /// Shows one column; jerks as tangential, X, Y.
  void show(Extent tangential, Extent x, Extent y) {
    Band band;
    band.channels[static_cast<std::size_t>(Channel::tangential_jerk)] = tangential;
    band.channels[static_cast<std::size_t>(Channel::jerk_x)] = x;
    band.channels[static_cast<std::size_t>(Channel::jerk_y)] = y;
    chart_.show_bands(std::array{band});
  }

  KinematicChart& chart() { return chart_; }
  double lowest() { return ordinate().min(); }
  double highest() { return ordinate().max(); }

 private:
  const QValueAxis& ordinate() {
    return *qobject_cast<QValueAxis*>(chart_.chart()->axes(Qt::Vertical).front());
  }

  ViewRange range_;
  KinematicChart chart_;
};

TEST_F(JerkChart, FollowsTheAxesWhereTheTangentialJerkIsFarLarger) {
  show({-235, 180}, {-4, 5}, {-2, 3});
  EXPECT_LT(highest(), 10);
  EXPECT_GT(lowest(), -10);
  EXPECT_GE(highest(), 5);
  EXPECT_LE(lowest(), -4);
}

TEST_F(JerkChart, ShowsTheTangentialJerkOfAStraightLineInFull) {
  const float diagonal = 5 * std::sqrt(3.0F);
  show({-diagonal, diagonal}, {-5, 5}, {-5, 5});
  EXPECT_GE(highest(), diagonal);
  EXPECT_LE(lowest(), -diagonal);
}

TEST_F(JerkChart, GrowsWithTheAxesInFull) {
  show({-1, 1}, {-70, 3}, {-2, 90});
  EXPECT_GE(highest(), 90);
  EXPECT_LE(lowest(), -70);
}

TEST_F(JerkChart, ShowsALimitThatIsNotFarAway) {
  chart().set_limits({{6, "limit of X", 0}});
  show({0, 200}, {-1, 4}, {0, 0});
  EXPECT_GE(highest(), 6);
  EXPECT_LE(lowest(), -6);
  show({0, 200}, {-1, 2}, {0, 0});
  EXPECT_LT(highest(), 6);
}

}  // namespace
}  // namespace feedscope::ui
