#include "ui/study/study_map.h"

#include <gmock/gmock.h>

#include <QApplication>
#include <QPainter>
#include <cmath>
#include <random>

#include "tests/ui/report/recorded_text.h"
#include "ui/study/study_curves.h"

namespace feedscope::ui {
namespace {

/// `rows` x `columns` cells with the errors that `error` gives by column and row.
template <class Error>
StudyMap map_with(std::size_t columns, std::size_t rows, Error error) {
  StudyMap map;
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t column = 0; column < columns; ++column) {
      map.cells.push_back({10, error(column, row)});
    }
  }
  return map;
}

/// On a linear field the line of a level is where the field has it.
TEST(StudyMapTest, AContourOfALinearFieldIsStraight) {
  const StudyMap map =
      map_with(4, 3, [](std::size_t column, std::size_t) { return 0.01 * static_cast<double>(column); });
  const std::vector<QLineF> pieces = contour_pieces(map, 4, 0.0125);
  ASSERT_EQ(pieces.size(), 2U) << "one for each pair of rows";
  for (const QLineF& piece : pieces) {
    EXPECT_NEAR(piece.x1(), 1.25, 1e-12);
    EXPECT_NEAR(piece.x2(), 1.25, 1e-12);
    EXPECT_NEAR(std::abs(piece.dy()), 1, 1e-12);
  }
  EXPECT_TRUE(contour_pieces(map, 4, 0.04).empty()) << "beyond all errors";
}

/// The mean of the four corners decides which of them a saddle joins.
TEST(StudyMapTest, ASaddlePartsTheCornersThatAreNotAsItsMiddle) {
  const std::vector<double> high{1, 0, 0, 0.8};  // of (0, 0), (1, 0), (0, 1), (1, 1): mean 0.45
  const StudyMap map =
      map_with(2, 2, [&](std::size_t column, std::size_t row) { return high[2 * row + column]; });
  for (const double level : {0.4, 0.5}) {
    const std::vector<QLineF> pieces = contour_pieces(map, 2, level);
    ASSERT_EQ(pieces.size(), 2U);
    const bool joins_high = level < 0.45;
    for (const QLineF& piece : pieces) {
      const QPointF middle = piece.center();
      const bool at_high = (middle.x() < 0.5) == (middle.y() < 0.5);
      EXPECT_NE(at_high, joins_high) << "level " << level;
    }
  }
}

TEST(StudyMapTest, EveryEndOfAContourIsWhereTheErrorHasItsLevel) {
  for (unsigned seed = 0; seed < 50; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> error(0, 0.1);
    const std::size_t columns = 2 + seed % 5;
    StudyMap map = map_with(columns, 2 + seed % 3, [&](std::size_t, std::size_t) { return error(random); });
    map.cells.back().possible = seed % 2 == 0;
    const double level = error(random);
    for (const QLineF& piece : contour_pieces(map, columns, level)) {
      for (const QPointF& end : {piece.p1(), piece.p2()}) {
        const QPointF low(std::floor(end.x()), std::floor(end.y()));
        const QPointF high(std::ceil(end.x()), std::ceil(end.y()));
        const auto at = [&](const QPointF& place) {
          return map
              .cells[static_cast<std::size_t>(place.y()) * columns + static_cast<std::size_t>(place.x())]
              .error;
        };
        const double share = std::max(end.x() - low.x(), end.y() - low.y());
        EXPECT_NEAR(at(low) + share * (at(high) - at(low)), level, 1e-9) << "seed " << seed;
      }
    }
  }
}

/// Two runs on either of two values; the second value of the first setting is given first.
Study two_by_two() {
  Study study;
  study.sweeps = {parse_sweep("tolerance=0.04;0.01"), parse_sweep("X.jerk=20;50")};
  study.within = 0.02;
  const std::vector<double> times{8, 12, 7, 11};
  for (std::size_t i = 0; i < times.size(); ++i) {
    StudyRun& run = study.runs.emplace_back();
    run.setup = make_setup({});
    run.swept = {study.sweeps[0].values[i % 2], study.sweeps[1].values[i / 2]};
    run.summary.cycle_time = times[i];
    run.summary.cutting_contour_error = i % 2 == 0 ? 0.03 : 0.01;
  }
  return study;
}

TEST(StudyMapTest, ValuesRiseAndTheRunToTakeIsMarked) {
  const StudyMaps maps = study_maps(two_by_two());
  EXPECT_THAT(maps.x.values, ::testing::ElementsAre(0.01, 0.04));
  EXPECT_EQ(maps.x.unit, "mm");
  EXPECT_EQ(maps.y.title, "X Jerk");
  EXPECT_EQ(maps.y.unit.toStdString(), "m/s³");
  ASSERT_EQ(maps.maps.size(), 1U);
  std::vector<double> times;
  std::vector<bool> best;
  for (const StudyMapCell& cell : maps.maps[0].cells) {
    times.push_back(cell.time);
    best.push_back(cell.best);
  }
  EXPECT_THAT(times, ::testing::ElementsAre(12, 8, 11, 7));
  EXPECT_THAT(best, ::testing::ElementsAre(false, false, true, false));
}

TEST(StudyMapTest, ValuesAtItsSidesHaveTheDigitsThatTellThemApart) {
  Study study = two_by_two();
  const auto texts = [&](std::vector<double> jerks) {
    study.sweeps[1].values = std::move(jerks);
    feedscope::test::RecordedText paper;
    QPainter painter(&paper);
    StudyMapPicture({}, {}, study_maps(study), QApplication::font()).paint(painter, {900, 600});
    return paper.texts();
  };
  EXPECT_TRUE(texts({23.333, 50}).contains("23"));
  EXPECT_TRUE(texts({23.333, 23.4}).contains("23.3"));
  EXPECT_TRUE(texts({120, 1500}).contains("1500"));
}

TEST(StudyMapTest, FurtherSettingsAreMapsOfTheirOwnWithUnits) {
  Study study = two_by_two();
  study.sweeps.push_back(parse_sweep("Y.jerk=10;30"));
  const std::vector<StudyRun> first = study.runs;
  study.runs.insert(study.runs.end(), first.begin(), first.end());
  for (std::size_t i = 0; i < study.runs.size(); ++i) {
    study.runs[i].swept.push_back(i < 4 ? 10 : 30);
  }
  const StudyMaps maps = study_maps(study);
  ASSERT_EQ(maps.maps.size(), 2U);
  EXPECT_THAT(maps.maps[1].name.toStdString(), ::testing::EndsWith(", Y Jerk 30 m/s³"));
}

TEST(StudyMapTest, TimesHaveAtMostEightColours) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    std::mt19937 random(seed);
    Study study = two_by_two();
    for (StudyRun& run : study.runs) {
      run.summary.cycle_time = std::pow(10.0, std::uniform_real_distribution<double>(-3, 6)(random));
    }
    const StudyMapPicture picture({}, {}, study_maps(study), QApplication::font());
    EXPECT_LE(picture.time_ticks().values.size() + 1, static_cast<std::size_t>(StudyMapPicture::most_colours))
        << "seed " << seed;
  }
}

TEST(StudyMapTest, TolerancesThatAreNotSweptNameTheirCurves) {
  Study study = two_by_two();
  study.sweeps = {parse_sweep("X.jerk=20;50")};
  for (std::size_t i = 0; i < study.runs.size(); ++i) {
    study.runs[i].setup = make_setup({"", "essid", i < 2 ? 0.01 : 0.05, {}});
  }
  const StudyCurves curves = study_curves(study);
  ASSERT_EQ(curves.curves.size(), 2U);
  EXPECT_EQ(curves.curves[1].name.toStdString(), "essid, spinner-mvc850, 0.05 mm");
}

}  // namespace
}  // namespace feedscope::ui
