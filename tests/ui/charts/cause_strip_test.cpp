#include "ui/charts/cause_strip.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QImage>
#include <QPainter>
#include <QTest>
#include <QtMath>
#include <algorithm>

#include "ui/scene/cause_colour.h"

namespace feedscope::ui {
namespace {

using ::testing::HasSubstr;

class CauseStripTest : public testing::Test {
 protected:
  CauseStripTest() {
    strip.resize(700, strip.sizeHint().height());
    strip.show();
    std::vector<double> times(all_causes().size());
    times[cause_index({CauseKind::axis_jerk, 0})] = 1.5;
    times[cause_index({CauseKind::axis_jerk, 1})] = 0.5;
    times[cause_index({CauseKind::programmed_feed, -1})] = 6;
    strip.set_causes({CauseKind::programmed_feed, CauseKind::programmed_feed, CauseKind::axis_jerk, {}},
                     times);
  }

  QColor colour_at(double share) {
    QPixmap picture(strip.size());
    strip.render(&picture);
    const QRect bar = strip.strip();
    return picture.toImage().pixelColor(bar.left() + static_cast<int>(share * bar.width()), bar.center().y());
  }

  static QColor colour_of(CauseKind kind) {
    const Rgb rgb = cause_colour(kind);
    return QColor::fromRgbF(float(rgb[0]), float(rgb[1]), float(rgb[2]));
  }

  std::string tip(double share) {
    const QRect bar = strip.strip();
    return strip.tip_at({bar.left() + static_cast<int>(share * bar.width()), bar.center().y()}).toStdString();
  }

  CauseStrip strip;
};

TEST_F(CauseStripTest, ColoursTheColumnsByTheirCause) {
  EXPECT_EQ(colour_at(0.3).rgb(), colour_of(CauseKind::programmed_feed).rgb());
  EXPECT_EQ(colour_at(0.6).rgb(), colour_of(CauseKind::axis_jerk).rgb());
  EXPECT_NE(colour_at(0.9).rgb(), colour_of(CauseKind::axis_jerk).rgb());
}

TEST_F(CauseStripTest, NamesTheCauseItsShareAndItsAxes) {
  EXPECT_THAT(tip(0.6), HasSubstr("axis jerk: 25 % of the visible time, 2.000 s"));
  EXPECT_THAT(tip(0.6), HasSubstr("jerk of axis X: 19 %"));
  EXPECT_THAT(tip(0.6), HasSubstr("jerk of axis Y: 6.3 %"));
  EXPECT_THAT(tip(0.1), HasSubstr("programmed feed: 75 % of the visible time, 6.000 s"));
  EXPECT_EQ(tip(0.9), "");
}

TEST_F(CauseStripTest, ListsTheLargestShareFirst) {
  const QRect first = strip.legend_item(CauseKind::programmed_feed);
  const QRect second = strip.legend_item(CauseKind::axis_jerk);
  ASSERT_FALSE(first.isEmpty());
  ASSERT_FALSE(second.isEmpty());
  EXPECT_LT(first.right(), second.left());
  EXPECT_TRUE(strip.legend_item(CauseKind::dwell).isEmpty());
}

TEST_F(CauseStripTest, APressedCauseIsShownAlone) {
  QTest::mouseClick(&strip, Qt::LeftButton, {}, strip.legend_item(CauseKind::axis_jerk).center());
  EXPECT_EQ(strip.highlighted(), CauseKind::axis_jerk);
  EXPECT_EQ(colour_at(0.6).rgb(), colour_of(CauseKind::axis_jerk).rgb());
  EXPECT_NE(colour_at(0.3).rgb(), colour_of(CauseKind::programmed_feed).rgb());
  QTest::mouseClick(&strip, Qt::LeftButton, {}, strip.legend_item(CauseKind::axis_jerk).center());
  EXPECT_EQ(strip.highlighted(), std::nullopt);
}

/// On paper columns have no whole pixels, and edges are smoothed.
TEST_F(CauseStripTest, HasNoGapsWhereCausesMeet) {
  std::vector<std::optional<CauseKind>> columns;
  for (int i = 0; i < 30; ++i) {
    columns.push_back(i % 2 == 0 ? CauseKind::programmed_feed : CauseKind::axis_jerk);
  }
  strip.set_causes(columns, std::vector<double>(all_causes().size(), 1));
  constexpr double enlarged = 1.37;
  QImage image(strip.size() * enlarged, QImage::Format_RGB32);
  image.fill(Qt::white);
  QPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.scale(enlarged, enlarged);
  strip.render(&painter, {}, {}, QWidget::DrawChildren);
  painter.end();
  const QRect bar = strip.strip();
  const int y = qRound(bar.center().y() * enlarged);
  const int lightest = std::max(qGray(colour_of(CauseKind::programmed_feed).rgb()),
                                qGray(colour_of(CauseKind::axis_jerk).rgb()));
  for (int x = qCeil((bar.left() + 2) * enlarged); x < qFloor((bar.right() - 2) * enlarged); ++x) {
    EXPECT_LE(qGray(image.pixel(x, y)), lightest + 3) << "the ground shines through at " << x;
  }
}

TEST_F(CauseStripTest, LeavesOutWhatHasNoRoom) {
  strip.resize(300, strip.height());
  EXPECT_FALSE(strip.legend_item(CauseKind::programmed_feed).isEmpty());
  EXPECT_TRUE(strip.legend_item(CauseKind::axis_jerk).isEmpty());
  EXPECT_THAT(strip.tip_at({290, 3}).toStdString(), HasSubstr("axis jerk 25 %"));
}

TEST_F(CauseStripTest, OfNothingIsEmpty) {
  strip.set_causes({}, {});
  EXPECT_EQ(tip(0.5), "");
  EXPECT_TRUE(strip.legend_item(CauseKind::programmed_feed).isEmpty());
}

}  // namespace
}  // namespace feedscope::ui
