#include "ui/charts/chart_export.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QImage>
#include <QPainter>
#include <QTemporaryDir>
#include <sstream>

#include "core/base/error.h"
#include "core/export/export.h"
#include "tests/ui/run_fixture.h"

namespace feedscope::ui {
namespace {

using ::testing::HasSubstr;

class ChartExport : public testing::Test {
 protected:
  QString path(const char* name) const { return folder.filePath(name); }
  static QByteArray contents(const QString& file) {
    QFile in(file);
    return in.open(QIODevice::ReadOnly) ? in.readAll() : QByteArray();
  }

  QTemporaryDir folder;
  std::shared_ptr<const Trajectory> trajectory = test::simulate_text(test::small_program).trajectory;
};

TEST_F(ChartExport, OfTheWholeRunIsWhatSimulateWrites) {
  std::ostringstream expected;
  write_csv(expected, *trajectory, 0.01);
  save_csv(path("run.csv"), *trajectory, sample_times({0, trajectory->duration()}, 0.01));
  EXPECT_EQ(contents(path("run.csv")).toStdString(), expected.str());
}

TEST_F(ChartExport, OfARangeHoldsItsRowsOnly) {
  save_csv(path("range.csv"), *trajectory, sample_times({0.4, 0.6}, 0.1));
  const QList<QByteArray> lines = contents(path("range.csv")).trimmed().split('\n');
  ASSERT_EQ(lines.size(), 4);
  EXPECT_TRUE(lines[0].startsWith("time_s,path_mm,line,"));
  const State state = trajectory->state(0.5);
  const QList<QByteArray> cells = lines[2].split(',');
  EXPECT_NEAR(cells[0].toDouble(), 0.5, 1e-12);
  EXPECT_NEAR(cells[1].toDouble(), state.path_length, 1e-6);
  EXPECT_NEAR(cells[6].toDouble(), state.speed * 60, 1e-6);
  EXPECT_NEAR(lines[3].split(',')[0].toDouble(), 0.6, 1e-12);
}

TEST_F(ChartExport, OfBlocksHasARowWhereEachBegins) {
  const double duration = trajectory->duration();
  const std::vector<double> times = block_times(*trajectory, {0, duration});
  ASSERT_EQ(times.size(), 5U);  // four blocks that move, and the end
  EXPECT_EQ(times.back(), duration);
  constexpr double just = 1e-6;  // [s]
  for (std::size_t i = 0; i + 1 < times.size(); ++i) {
    EXPECT_EQ(trajectory->state(times[i] + just).line, i + 2) << "lines 2 to 5 move";
    EXPECT_TRUE(i == 0 || trajectory->state(times[i] - just).line == i + 1);
  }
  const std::vector<double> part = block_times(*trajectory, {times[1] + 0.01, times[2] + 0.01});
  EXPECT_EQ(part, (std::vector<double>{times[1] + 0.01, times[2], times[2] + 0.01}));
}

TEST_F(ChartExport, TooManyRowsAreRefused) {
  EXPECT_THROW(sample_times({0, 1e6}, 1e-6), InputError);
  EXPECT_THROW(sample_times({0, 1}, 0), InputError);
}

TEST_F(ChartExport, WhatCannotBeWrittenIsNamedAndLeavesNothingBehind) {
  const QString file = path("missing/run.csv");
  const std::vector<double> times{0};
  try {
    save_csv(file, *trajectory, times);
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("run.csv"));
  }
  EXPECT_THROW(save_picture(file, {10, 10}, "", [](QPainter&) {}), InputError) << "no picture by its name";
  EXPECT_THROW(save_picture(path("missing/run.png"), {10, 10}, "", [](QPainter&) {}), InputError);
  EXPECT_TRUE(QDir(folder.path()).isEmpty());
}

TEST_F(ChartExport, PicturesHaveTheirSize) {
  const auto square = [](QPainter& painter) { painter.fillRect(10, 10, 20, 20, Qt::red); };
  save_picture(path("a.png"), {60, 40}, "square", square);
  const QImage image(path("a.png"));
  EXPECT_EQ(image.size(), QSize(120, 80));
  EXPECT_EQ(image.pixelColor(40, 40), QColor(Qt::red));
  EXPECT_EQ(image.pixelColor(70, 70), QColor(Qt::white));
  save_picture(path("a.svg"), {60, 40}, "square", square);
  const QByteArray svg = contents(path("a.svg"));
  EXPECT_TRUE(svg.contains("viewBox=\"0 0 60 40\""));
  EXPECT_TRUE(svg.contains("#ff0000"));
  EXPECT_FALSE(svg.contains("<image"));
}

}  // namespace
}  // namespace feedscope::ui
