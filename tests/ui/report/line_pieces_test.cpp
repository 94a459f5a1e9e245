#include "ui/paper/line_pieces.h"

#include <gmock/gmock.h>

namespace feedscope::ui {
namespace {

const QRectF room(0, 0, 100, 100);

LineEnd end(double x, double y, double depth, const QColor& colour = Qt::black) {
  return {QPointF(x, y), depth, colour};
}

TEST(LinePieces, TheFartherLineComesFirst) {
  LinePieces pieces(room);
  pieces.add(end(0, 50, 30, Qt::red), end(100, 50, 30, Qt::red), 2, true);
  pieces.add(end(50, 0, 10, Qt::blue), end(50, 100, 10, Qt::blue), 2, true);
  const auto lines = pieces.sorted();
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0].colour, QColor(Qt::blue));
  EXPECT_EQ(lines[1].colour, QColor(Qt::red));
}

TEST(LinePieces, LinesThatPassThroughEachOtherChangePlaces) {
  // One rises from left to right, the other falls: above is the first on the right, the second on the left.
  LinePieces pieces(room);
  pieces.add(end(0, 50, 0, Qt::red), end(100, 50, 80, Qt::red), 2, true);
  pieces.add(end(0, 50, 80, Qt::blue), end(100, 50, 0, Qt::blue), 2, true);
  QColor left;
  QColor right;
  for (const auto& line : pieces.sorted()) {
    (line.points.boundingRect().center().x() < 50 ? left : right) = line.colour;
  }
  EXPECT_EQ(left, QColor(Qt::blue));
  EXPECT_EQ(right, QColor(Qt::red));
}

TEST(LinePieces, ALevelPathIsOnePolylineInTheOrderItWasAdded) {
  LinePieces pieces(room);
  for (int x = 0; x < 90; x += 10) {
    pieces.add(end(x, 10, 5), end(x + 10, 10, 5), 2, true);
  }
  const auto lines = pieces.sorted();
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0].points.size(), 10);
  EXPECT_EQ(lines[0].points.front(), QPointF(1.5, 10));
}

TEST(LinePieces, AColourThatChangesIsCutIntoStepsThatAreNotSeen) {
  LinePieces pieces(room);
  pieces.add(end(0, 10, 0, QColor(0, 0, 0)), end(100, 10, 0, QColor(255, 255, 255)), 2, true);
  const auto lines = pieces.sorted();
  EXPECT_GE(lines.size(), 16U);
  EXPECT_LE(lines.size(), 32U);
  for (const auto& line : lines) {
    const double shown = line.colour.redF() * 100;
    EXPECT_NEAR(shown, line.points.boundingRect().center().x(), 3);
  }
}

TEST(LinePieces, AJumpOfColourIsNoPiece) {
  LinePieces pieces(room);
  pieces.add(end(10, 10, 0, Qt::black), end(50, 10, 0, Qt::black), 2, true);
  pieces.add(end(50, 10, 0, Qt::black), end(50, 10, 0, Qt::white), 2, true);
  pieces.add(end(50, 10, 0, Qt::white), end(90, 10, 0, Qt::white), 2, true);
  EXPECT_EQ(pieces.count(), 2U);
}

TEST(LinePieces, StepsOfColourAreNoShorterThanTheWidthLetsThemBeSeen) {
  LinePieces pieces(room);
  pieces.add(end(50, 10, 0, Qt::black), end(52, 10, 0, Qt::white), 4, true);
  EXPECT_EQ(pieces.count(), 2U) << "a quarter of the width each";
}

TEST(LinePieces, WhatIsOutsideIsOmittedAndWhatReachesOutIsCut) {
  LinePieces pieces(room);
  pieces.add(end(-50, -10, 0), end(150, -10, 0), 2, true);
  pieces.add(end(200, 0, 0), end(300, 90, 0), 2, true);
  EXPECT_EQ(pieces.count(), 0U);
  pieces.add(end(-50, 40, 0), end(150, 60, 0), 2, true);
  const auto lines = pieces.sorted();
  ASSERT_EQ(lines.size(), 1U);
  const double half = 1.5;  // of the width, and of a pixel
  EXPECT_NEAR(lines[0].points.front().x(), half, 1e-9);
  EXPECT_NEAR(lines[0].points.front().y(), 45.15, 1e-9);
  EXPECT_NEAR(lines[0].points.back().x(), 100 - half, 1e-9);
  EXPECT_NEAR(lines[0].points.back().y(), 54.85, 1e-9);
}

TEST(LinePieces, APointIsAPiece) {
  LinePieces pieces(room);
  EXPECT_TRUE(pieces.add(end(10, 10, 0), end(10, 10, 0), 4, true));
  EXPECT_EQ(pieces.count(), 1U);
}

TEST(LinePieces, MoreThanTheBoundAreRefused) {
  LinePieces pieces(room);
  const double depth = LinePieces::max_depth * static_cast<double>(LinePieces::max_pieces);
  EXPECT_TRUE(pieces.add(end(10, 50, 0), end(90, 50, depth), 1, true));
  EXPECT_EQ(pieces.count(), LinePieces::max_pieces);
  EXPECT_FALSE(pieces.add(end(10, 10, 0), end(11, 11, 0), 1, true));
}

}  // namespace
}  // namespace feedscope::ui
