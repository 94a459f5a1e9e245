#include "ui/paper/page_breaks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

namespace feedscope::ui {
namespace {

/// Lines of 10 with a gap of 2 between them, none of which costs anything to break at.
std::vector<PageGap> gaps_of_lines(int lines) {
  std::vector<PageGap> gaps;
  for (int i = 1; i < lines; ++i) {
    gaps.push_back({12.0 * i - 2, 12.0 * i, 0, false, 0});
  }
  return gaps;
}

TEST(PageBreaks, PlainLinesFillEachPageButTheLast) {
  // Eight lines of 12 less the last gap are 94: nine do not fit into 100.
  const auto breaks = best_page_breaks(gaps_of_lines(20), 0, 238, 100);
  EXPECT_EQ(breaks, (std::vector<std::size_t>{7, 15}));
}

TEST(PageBreaks, NothingThatFitsIsBroken) {
  EXPECT_TRUE(best_page_breaks(gaps_of_lines(8), 0, 94, 100).empty());
  EXPECT_TRUE(best_page_breaks({}, 0, 50, 100).empty());
}

TEST(PageBreaks, ForcedBreaksAreMade) {
  auto gaps = gaps_of_lines(4);
  gaps[1].forced = true;
  EXPECT_EQ(best_page_breaks(gaps, 0, 46, 100), (std::vector<std::size_t>{1}));
}

TEST(PageBreaks, WhatNoPageHoldsStandsAlone) {
  const std::vector<PageGap> gaps{{10, 12, 0, false, 0}, {300, 302, 0, false, 0}};
  EXPECT_EQ(best_page_breaks(gaps, 0, 320, 100), (std::vector<std::size_t>{0, 1}));
}

/// Whether there is a way to fill every page but the last enough without breaking where it costs.
bool can_be_had(const std::vector<PageGap>& gaps, double top, double bottom, double height,
                std::size_t from) {
  const double start = from == 0 ? top : gaps[from - 1].below;
  if (bottom - start <= height) {
    return true;
  }
  for (std::size_t i = from; i < gaps.size() && gaps[i].above - start <= height; ++i) {
    const bool full = gaps[i].above - start >= page_cost::min_fill * height;
    if (full && gaps[i].cost == 0 && can_be_had(gaps, top, bottom, height, i + 1)) {
      return true;
    }
  }
  return false;
}

TEST(PageBreaks, AreFreeAndPagesFullWhereThatCanBeHad) {
  std::mt19937 random(7);
  int possible = 0;
  for (int i = 0; i < 400; ++i) {
    std::vector<PageGap> gaps;
    double place = 0;
    for (int line = 0; line < 24; ++line) {
      place += 5 + static_cast<double>(random() % 20);
      gaps.push_back({place, place + 2, random() % 3 == 0 ? 0.0 : 1e6, false, 0});
      place += 2;
    }
    const double bottom = place + 10;
    const auto breaks = best_page_breaks(gaps, 0, bottom, 100);
    double start = 0;
    bool kept = true;
    for (const std::size_t index : breaks) {
      const double used = gaps[index].above - start;
      EXPECT_LE(used, 100) << i;
      kept = kept && gaps[index].cost == 0 && used >= page_cost::min_fill * 100;
      start = gaps[index].below;
    }
    EXPECT_LE(bottom - start, 100) << i;
    const bool wanted = can_be_had(gaps, 0, bottom, 100, 0);
    EXPECT_EQ(kept, wanted) << "seed 7, case " << i;
    possible += wanted ? 1 : 0;
  }
  EXPECT_GT(possible, 40);
}

}  // namespace
}  // namespace feedscope::ui
