#include "core/program/text/block_number.h"

#include <gtest/gtest.h>

namespace feedscope {
namespace {

TEST(BlockNumber, OfLinesOfEveryDialect) {
  EXPECT_EQ(block_number("N120 G1 X5"), "N120");
  EXPECT_EQ(block_number("  n007G1X5"), "N007");
  EXPECT_EQ(block_number("/N10 G0 Z5"), "N10");
  EXPECT_EQ(block_number("N 30 X1"), "N30");
  EXPECT_EQ(block_number("12 L X+5 FMAX"), "12");
  EXPECT_EQ(block_number("12"), "12");
}

TEST(BlockNumber, OfLinesWithoutOneIsEmpty) {
  for (const char* line : {"", " ", "G1 X12", "X120", "N", "NEXT: G1", "(N10)", "%1234", "1.5 X", "12X5"}) {
    EXPECT_EQ(block_number(line), "") << line;
  }
}

}  // namespace
}  // namespace feedscope
