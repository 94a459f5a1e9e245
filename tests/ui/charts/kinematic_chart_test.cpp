#include "ui/charts/kinematic_chart.h"

#include <gtest/gtest.h>

#include <QGuiApplication>
#include <QImage>
#include <QPainter>
#include <QStringList>
#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <set>

#include "tests/ui/report/recorded_text.h"
#include "tests/ui/run_fixture.h"

namespace feedscope::ui {
namespace {

/// A chart of jerks in which the tangential one may be cut.
class JerkChart : public testing::Test {
 protected:
  JerkChart()
      : chart_({"Jerk",
                "mm/s3",
                {{QuantityId::tangential_jerk, "jt", "tangential", CurveRole::path, 1, true},
                 {QuantityId::jerk_x, "jx", "X", CurveRole::x},
                 {QuantityId::jerk_y, "jy", "Y", CurveRole::y}}},
               range_) {
    chart_.resize(600, 300);
    chart_.setAttribute(Qt::WA_DontShowOnScreen);
    chart_.show();  // gives the plot its place
  }

  /// Shows one column; jerks as tangential, X, Y.
  void show(Extent tangential, Extent x, Extent y) {
    Band band;
    band[QuantityId::tangential_jerk] = tangential;
    band[QuantityId::jerk_x] = x;
    band[QuantityId::jerk_y] = y;
    chart_.show_bands(std::array{band});
  }

  KinematicChart& chart() { return chart_; }
  double lowest() { return chart_.values().lower; }
  double highest() { return chart_.values().upper; }

 private:
  ViewRange range_;
  KinematicChart chart_;
};

/// A slow cut after a rapid with all of the machine's acceleration.
TEST(AccelerationChart, RapidsDoNotSetTheScaleAndAreNoted) {
  const auto run = test::simulate_text("G21 G90 G94\nG0 X100\nG1 X110 F100\n");
  const Envelope envelope(run.trajectory);
  ViewRange range;
  KinematicChart chart(kinematic_chart_specs()[acceleration_chart], range);
  chart.resize(600, 300);
  const auto most = [&](QuantityId id) {
    const Extent whole = envelope.overall()[id];
    return chart.spec().convert(std::max(double{whole.max}, -double{whole.min}));
  };
  ASSERT_NEAR(most(QuantityId::tangential_acceleration), 1, 0.01);
  chart.show_bands(std::array{envelope.overall()});
  EXPECT_GE(chart.values().upper, 1);
  EXPECT_FALSE(chart.notes().join(' ').contains("rapids"));
  chart.set_cutting({envelope.cutting()});
  chart.show_bands(std::array{envelope.overall()});
  EXPECT_LT(chart.values().upper, 0.25);
  EXPECT_GT(chart.values().upper,
            chart.spec().convert(double{envelope.cutting()[QuantityId::tangential_acceleration].max}));
  EXPECT_GT(chart.values().lower, -0.25) << "braking of the rapid as well";
  EXPECT_TRUE(chart.notes().join(' ').contains("rapids up to 1")) << chart.notes().join(' ').toStdString();
  chart.set_cutting({});
  chart.show_bands(std::array{envelope.overall()});
  EXPECT_GE(chart.values().upper, 1) << "rapids alone";
}

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
  chart().set_limits({{6, {}, {0}}});
  show({0, 200}, {-1, 4}, {0, 0});
  EXPECT_GE(highest(), 6);
  EXPECT_LE(lowest(), -6);
  show({0, 200}, {-1, 2}, {0, 0});
  EXPECT_LT(highest(), 6);
}

/// Nothing is written into the plot: it could lie over a curve.
TEST_F(JerkChart, NamesOfLimitsAreNotInThePlot) {
  const auto draw = [&](const QString& name) {
    chart().set_limits({{6, name, {}}});
    show({0, 0}, {-20, 20}, {-1, 1});  // beyond the limit
    QImage image(chart().size(), QImage::Format_RGB32);
    QPainter painter(&image);
    chart().draw(painter);
    return image;
  };
  EXPECT_EQ(draw("limit of X Y"), draw("limit of Z"));
}

TEST_F(JerkChart, TellsTheLimitsThatItShowsAndWhatItDoesNotDraw) {
  chart().set_limits({{6, {}, {0}}, {500, {}, {1}}});
  show({0, 0}, {-20, 20}, {-1, 1});
  ASSERT_EQ(chart().limits_in_sight().size(), 1U);
  EXPECT_EQ(chart().limits_in_sight()[0].label, QStringLiteral("limit of X"));
  EXPECT_EQ(chart().notes(), QStringList());
  chart().set_jumps(true);
  EXPECT_EQ(chart().notes(), QStringList("jumps of the acceleration are not drawn"));
}

/// The limit of an axis at rest would look as if it were that of the others.
TEST_F(JerkChart, ShowsLimitsOfMovingAxesOnly) {
  chart().set_limits({{100, {}, {0}}, {6, {}, {1}}, {6, {}, {2}}});
  show({0, 0}, {-20, 20}, {0, 0});
  EXPECT_TRUE(chart().limits_in_sight().empty()) << "that of X is far away";
  show({0, 0}, {-20, 20}, {-1, 1});
  ASSERT_EQ(chart().limits_in_sight().size(), 1U);
  EXPECT_EQ(chart().limits_in_sight()[0].label, QStringLiteral("limit of Y"));
  EXPECT_EQ(chart().limits_in_sight()[0].axes, std::vector<std::size_t>{1}) << "in the colour of Y";
}

TEST(LimitLines, OneOfSeveralAxesHasTheColoursOfAllThatMove) {
  const std::vector<LimitLine> limits{{10, {}, {0}}, {6, {}, {1}}, {10, {}, {2}}, {10, "bound", {}}};
  const auto moving = [&](const std::vector<std::size_t>& axes) {
    return limits_of_moving(limits, [&](const LimitLine& limit) {
      return std::ranges::find(axes, limit.axes.front()) != axes.end();
    });
  };
  const std::vector<LimitLine> all = moving({0, 1, 2});
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[0].label, QStringLiteral("limit of X Z"));
  EXPECT_EQ(all[0].axes, (std::vector<std::size_t>{0, 2}));
  EXPECT_EQ(all[1].axes, std::vector<std::size_t>{1});
  EXPECT_EQ(all[2].label, QStringLiteral("bound")) << "not joined with X and Z";
  QImage image(40, 3, QImage::Format_RGB32);
  image.fill(Qt::white);
  QPainter painter(&image);
  const ThemeColours& colours = theme_colours(QGuiApplication::palette());
  draw_limit_line(painter, {0, 1.5}, {40, 1.5}, all[0], colours, 1);
  painter.end();
  std::set<QRgb> seen;
  for (int x = 0; x < image.width(); ++x) {
    seen.insert(image.pixel(x, 1));
  }
  EXPECT_TRUE(seen.contains(colours.axes[0].rgb()));
  EXPECT_TRUE(seen.contains(colours.axes[2].rgb()));
  EXPECT_FALSE(seen.contains(colours.shared.rgb()));
}

TEST(LimitLines, OneOfAllMovingAxesHasTheCommonColour) {
  const std::vector<LimitLine> lines =
      limits_of_moving({{10, {}, {0}}, {10, {}, {1}}, {6, {}, {2}}},
                       [](const LimitLine& limit) { return limit.axes.front() < 2; });
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0].label, QStringLiteral("limit of X Y"));
  EXPECT_TRUE(lines[0].axes.empty());
}

/// Zero and its neighbours for every range: "-0.0" is none of their labels.
TEST_F(JerkChart, ZeroHasNoSignInAnyRange) {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> exponent(-3, 5);
  for (int i = 0; i < 300; ++i) {
    const double size = std::pow(10.0, exponent(random));
    const double lower = -size * (0.05 + 0.01 * (i % 100));
    chart().choose_values(Interval{lower, size});
    feedscope::test::RecordedText paper;
    QPainter painter(&paper);
    chart().draw(painter);
    int zeros = 0;
    for (QString label : paper.texts()) {
      EXPECT_FALSE(label.contains('-')) << "a true minus";
      const bool negative = label.startsWith(QChar(0x2212));
      const bool zero = label.remove(QChar(0x2212)).toDouble() == 0;
      EXPECT_FALSE(negative && zero) << lower << " to " << size;
      zeros += zero ? 1 : 0;
    }
    EXPECT_EQ(zeros, 1) << lower << " to " << size;
  }
}

/// Whole ranges of 0.1 s to 10 million seconds, and their last tenths.
TEST(ChartAbscissa, NumbersAreNeverCut) {
  ViewRange range;
  range.set_trajectory(feedscope::test::simulate_text("G1 X0.01 F6000\n").trajectory, false);
  KinematicChart chart({"Feed", "mm/min", {{QuantityId::feed, "feed", "achieved", CurveRole::path}}}, range);
  chart.setAttribute(Qt::WA_DontShowOnScreen);
  chart.label_abscissa("Time [s]");
  chart.show();
  std::mt19937 random(11);
  std::uniform_real_distribution<double> exponent(-1, 7);
  for (int i = 0; i < 100; ++i) {
    const double end = i == 0 ? 120000.001 : std::pow(10.0, exponent(random));
    range.set_end_beside(end);
    range.show(i % 3 == 1 ? 0.9 * end : 0, end);
    chart.resize(1000 - 7 * i, 200);
    chart.show_bands(std::array{Band{}});
    feedscope::test::RecordedText paper;
    QPainter painter(&paper);
    chart.draw(painter);
    for (qsizetype k = 0; k < paper.texts().size(); ++k) {
      const feedscope::test::TextSpan& span = paper.spans()[static_cast<std::size_t>(k)];
      EXPECT_GE(span.left, 0) << paper.texts()[k].toStdString() << " up to " << end;
      EXPECT_LE(span.right, chart.width()) << paper.texts()[k].toStdString() << " up to " << end;
    }
    EXPECT_TRUE(i > 0 || paper.texts().contains("120000")) << paper.texts().join(" ").toStdString();
  }
}

}  // namespace
}  // namespace feedscope::ui
