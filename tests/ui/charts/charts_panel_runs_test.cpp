#include <gtest/gtest.h>

#include <QFile>
#include <QPainter>
#include <QSignalSpy>
#include <QTemporaryDir>

#include "tests/ui/charts/charts_panel_fixture.h"
#include "tests/ui/report/recorded_text.h"

namespace feedscope::ui {
namespace {

class ChartsRuns : public test::ChartsPanelTest {
 protected:
  ChartsRuns() {
    const auto other = test::simulate_text(test::small_program, "cam").trajectory;
    panel.set_overlays(
        {{other, std::make_shared<const Envelope>(other), {}, Qt::magenta, "promised", false}});
    panel.refresh();
  }

  int magenta_pixels(std::size_t chart) {
    QApplication::processEvents();
    QPixmap picture(panel.chart(chart).size());
    static_cast<QWidget&>(panel.chart(chart)).render(&picture);
    const QImage image = picture.toImage();
    int count = 0;
    for (int y = 0; y < image.height(); ++y) {
      for (int x = 0; x < image.width(); ++x) {
        const QColor pixel = image.pixelColor(x, y);
        const int least = std::min(pixel.red(), pixel.blue());
        count += least > 200 && pixel.green() < least - 60 ? 1 : 0;
      }
    }
    return count;
  }

  void show_only(std::size_t curve) {
    for (std::size_t k = 0; k < panel.chart(0).spec().curves.size(); ++k) {
      panel.show_curve(0, k, k == curve);
    }
  }
};

constexpr std::size_t velocity_z = 4;

TEST_F(ChartsRuns, AnotherRunIsDrawnInItsColourAndNamed) {
  show_only(velocity_z);
  EXPECT_GT(magenta_pixels(0), 50);
  EXPECT_EQ(magenta_pixels(1), 0);
  ASSERT_EQ(panel.header(0).runs().size(), 1U);
  EXPECT_EQ(panel.header(0).runs()[0].name, "promised");
  EXPECT_TRUE(panel.header(1).runs().empty());
  panel.set_overlays({});
  panel.refresh();
  EXPECT_EQ(magenta_pixels(0), 0);
  EXPECT_TRUE(panel.header(0).runs().empty());
}

TEST_F(ChartsRuns, BesideOthersEachTitleNamesTheRun) {
  const auto texts = [this] {
    feedscope::test::RecordedText paper;
    QPainter painter(&paper);
    panel.draw(painter);
    return paper.texts();
  };
  EXPECT_TRUE(texts().contains("Jerk"));
  EXPECT_TRUE(texts().contains("Limited by"));
  panel.name_run("B");
  EXPECT_TRUE(texts().contains("Jerk of B"));
  EXPECT_TRUE(texts().contains("B limited by"));
}

TEST_F(ChartsRuns, ItsCurveCanBeChosenForEveryChart) {
  panel.set_overlay_curve(0, std::nullopt);
  panel.set_overlay_curve(1, 1);
  panel.refresh();
  EXPECT_EQ(magenta_pixels(0), 0);
  EXPECT_TRUE(panel.header(0).runs().empty());
  EXPECT_EQ(panel.header(1).runs().size(), 1U);
}

TEST_F(ChartsRuns, TheChartsGoOnToTheEndOfALongerOne) {
  const double end = trajectory().duration();
  EXPECT_DOUBLE_EQ(panel.range().upper(), end) << "the other one is shorter";
  std::string slow = test::small_program;
  slow.replace(slow.find("F3000"), 5, "F1000");
  const auto longer = test::simulate_text(slow, "cam").trajectory;
  ASSERT_GT(longer->duration(), end);
  panel.set_overlays({{longer, std::make_shared<const Envelope>(longer), {}, Qt::magenta, "slower", false}});
  panel.refresh();
  EXPECT_DOUBLE_EQ(panel.range().upper(), longer->duration());
  EXPECT_DOUBLE_EQ(panel.shown_times().upper, end) << "what is written of the run ends with it";
  panel.set_overlay_curve(0, std::nullopt);
  panel.refresh();
  EXPECT_DOUBLE_EQ(panel.range().upper(), end) << "nothing of it is shown";
}

TEST_F(ChartsRuns, TheOrdinateHoldsItsCurve) {
  show_only(velocity_z);
  EXPECT_GE(panel.chart(0).values().upper, 3000);  // the feed that it promises
}

TEST_F(ChartsRuns, ItsValueIsThatOfTheCursorsPlaceOverPathLength) {
  const double s = trajectory().path_length() / 3;
  cursor.set_path_length(s);
  panel.range().set_abscissa(Abscissa::path_length);
  panel.refresh();
  ASSERT_TRUE(panel.header(0).runs()[0].value.has_value());
  EXPECT_NEAR(*panel.header(0).runs()[0].value, 3000, 1);
}

TEST_F(ChartsRuns, TheVisibleRangeIsExported) {
  const QTemporaryDir folder;
  QSignalSpy exported(&panel, &ChartsPanel::exported);
  QSignalSpy failed(&panel, &ChartsPanel::failed);
  panel.range().show(0.2, 0.4);
  panel.commands().save_csv(folder.filePath("charts.csv"), CsvRows::pixels);
  ASSERT_TRUE(exported.wait());
  QFile file(folder.filePath("charts.csv"));
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  const QList<QByteArray> lines = file.readAll().trimmed().split('\n');
  EXPECT_EQ(lines.size(), panel.chart(0).column_count() + 2);
  EXPECT_NEAR(lines[1].split(',')[0].toDouble(), 0.2, 1e-9);
  EXPECT_NEAR(lines.back().split(',')[0].toDouble(), 0.4, 1e-9);
  panel.commands().save_csv(folder.filePath("missing/charts.csv"), CsvRows::samples, 0.001);
  ASSERT_TRUE(failed.wait());
  EXPECT_TRUE(failed.last().first().toString().contains("charts.csv"));
}

TEST_F(ChartsRuns, ThePictureHoldsTheChartsButNoControls) {
  const QTemporaryDir folder;
  panel.commands().save_picture(folder.filePath("charts.png"));
  const QImage image(folder.filePath("charts.png"));
  EXPECT_EQ(image.size(), panel.size() * 2);
  panel.commands().save_picture(folder.filePath("charts.svg"));
  QFile svg(folder.filePath("charts.svg"));
  ASSERT_TRUE(svg.open(QIODevice::ReadOnly));
  EXPECT_TRUE(svg.readAll().contains("<svg"));
  feedscope::test::RecordedText paper;
  QPainter painter(&paper);
  panel.draw(painter);
  const QString text = paper.texts().join('|');
  EXPECT_TRUE(text.contains("achieved"));
  EXPECT_TRUE(text.contains("Limited by"));
  EXPECT_FALSE(text.contains("Show all"));
}

}  // namespace
}  // namespace feedscope::ui
