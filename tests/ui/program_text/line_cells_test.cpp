#include "ui/program_text/line_cells.h"

#include <gtest/gtest.h>

#include <random>

namespace feedscope::ui {
namespace {

TEST(LineCells, OfPlainTextAreItsBytes) {
  const LineCells cells("G1 X5", Encoding::utf8);
  EXPECT_EQ(cells.count(), 5U);
  for (std::uint32_t i = 0; i <= 5; ++i) {
    EXPECT_EQ(cells.cell_of(i), i);
    EXPECT_EQ(cells.byte_at(i), i);
  }
  EXPECT_EQ(cells.cell_of(99), 5U);
  EXPECT_EQ(cells.byte_at(99), 5U);
}

TEST(LineCells, TabsReachToTheNextEighthCell) {
  const LineCells cells("G1\tX5\t", Encoding::utf8);
  EXPECT_EQ(cells.cell_of(3), 8U);  // X
  EXPECT_EQ(cells.byte_at(7), 2U);  // within the tab
  EXPECT_EQ(cells.count(), 16U);
  const auto runs = cells.runs(0, 6);
  ASSERT_EQ(runs.size(), 2U);
  EXPECT_EQ(runs[1].text, QStringLiteral("X5"));
  EXPECT_EQ(runs[1].cell, 8U);
}

TEST(LineCells, UmlautsTakeOneCellAndTwoBytes) {
  const std::string text = "(F\u00fc\u00df X)";
  const LineCells cells(text, Encoding::utf8);
  EXPECT_EQ(cells.count(), 7U);
  EXPECT_EQ(cells.cell_of(2), 2U);  // both bytes of the u
  EXPECT_EQ(cells.cell_of(3), 2U);
  EXPECT_EQ(cells.byte_at(3), 4U);
  ASSERT_EQ(cells.runs(0, 99).size(), 1U);
  EXPECT_EQ(cells.runs(0, 99)[0].text, QString::fromStdString(text));
}

TEST(LineCells, Latin1TakesOneCellAByte) {
  const LineCells cells("\xFC\xDF", Encoding::latin1);
  EXPECT_EQ(cells.count(), 2U);
  EXPECT_EQ(cells.runs(0, 2)[0].text, QStringLiteral("\u00fc\u00df"));
}

TEST(LineCells, WideCharactersTakeTwoCellsAndMarksNone) {
  const std::string text = "\u4e2dA\u0301B";  // a Chinese sign, A with a combining accent, B
  const LineCells cells(text, Encoding::utf8);
  EXPECT_EQ(cells.count(), 4U);
  EXPECT_EQ(cells.cell_of(3), 2U);
  EXPECT_EQ(cells.cell_of(4), 3U);  // of the accent: where the next character goes
  EXPECT_EQ(cells.byte_at(3), 4U);
}

TEST(LineCells, VeryLongLinesAreShownByteByByte) {
  const std::string text(LineCells::longest_decoded + 1, '\t');
  EXPECT_EQ(LineCells(text, Encoding::utf8).count(), text.size());
}

TEST(LineCells, OfAnyBytesStayWithinTheLine) {
  std::mt19937 random(1);
  std::uniform_int_distribution<int> byte(0, 255);
  for (int i = 0; i < 2000; ++i) {
    std::string text(static_cast<std::size_t>(i % 40), ' ');
    for (char& c : text) {
      c = static_cast<char>(byte(random));
    }
    for (const Encoding encoding : {Encoding::utf8, Encoding::latin1}) {
      const LineCells cells(text, encoding);
      for (std::uint32_t cell = 0; cell < cells.count() + 3; ++cell) {
        ASSERT_LE(cells.byte_at(cell), text.size());
        ASSERT_LE(cells.cell_of(cells.byte_at(cell)), cell);
      }
      cells.runs(0, static_cast<std::uint32_t>(text.size()));
    }
  }
}

}  // namespace
}  // namespace feedscope::ui
