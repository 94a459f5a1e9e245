#include <gtest/gtest.h>

#include <numbers>
#include <string>

#include "core/program/heidenhain/cycles/cycle_parameters.h"
#include "core/program/heidenhain/geometry/feeds.h"
#include "core/program/heidenhain/geometry/targets.h"
#include "core/program/heidenhain/language/labels.h"
#include "tests/core/program/heidenhain/part_bench.h"

namespace feedscope::heidenhain {
namespace {

std::string run_through(PartBench& bench) {
  std::string statements;
  do {
    const std::string_view statement =
        bench.context.statement.add(bench.lines.text().line(bench.lines.line()));
    if (!statement.empty()) {
      statements += std::string(statement) + '|';
      bench.context.statement.clear();
    }
  } while (bench.lines.advance());
  return statements;
}

TEST(StatementLines, RemoveCommentsAndBlankLines) {
  PartBench bench("L X+1 ; there\n\n; remark\nL X+2\n");
  EXPECT_EQ(run_through(bench), "L X+1 |L X+2|");
}

TEST(StatementLines, JoinLinesThatATildeContinues) {
  PartBench bench("CYCL DEF 200 ~\nQ200=2 ;clearance ~\nQ201=-5\nL X+2\n");
  EXPECT_EQ(run_through(bench), "CYCL DEF 200  Q200=2  Q201=-5 |L X+2|");
}

TEST(StatementLines, LeaveOutAllLinesOfALongRemark) {
  PartBench bench("3 ;a remark that goes on~\nover two lines\nL X+2\n");
  EXPECT_EQ(run_through(bench), "L X+2|");
}

TEST(StatementLines, KnowFromWhichLineAColumnComes) {
  PartBench bench("CYCL DEF 200~\nQ200=2\n");
  StatementLines& statement = bench.context.statement;
  EXPECT_TRUE(statement.add("CYCL DEF 200~").empty());
  bench.lines.advance();
  const std::string joined(statement.add("Q200=2"));
  const auto column = static_cast<std::uint32_t>(joined.find("Q200") + 1);
  EXPECT_EQ(statement.place(column).line, 2U);
  EXPECT_EQ(statement.place(column).column, 1U);
  EXPECT_EQ(statement.place(3).line, 1U);
}

MotionWords feed_word(FeedWord word, double value) {
  MotionWords words;
  words.feed_word = word;
  words.feed = value;
  return words;
}

TEST(Feeds, CountTenthsOfAnInchInInchPrograms) {
  PartBench bench;
  Feeds feeds(bench.context);
  bench.context.set_inch(true);
  feeds.apply(feed_word(FeedWord::value, 100));
  EXPECT_DOUBLE_EQ(bench.context.modal.feed.value, 10 * 25.4 / 60);
}

TEST(Feeds, ComeBackAfterABlockWithItsOwn) {
  PartBench bench;
  Feeds feeds(bench.context);
  feeds.apply(feed_word(FeedWord::value, 600));
  const auto alone = feeds.alone(feed_word(FeedWord::value, 60));
  ASSERT_TRUE(alone);
  EXPECT_DOUBLE_EQ(alone->value, 1);
  EXPECT_DOUBLE_EQ(bench.context.modal.feed.value, 10);
}

TEST(Feeds, AutoIsThatOfTheToolCall) {
  PartBench bench;
  Feeds feeds(bench.context);
  feeds.apply_tool_call(FeedWord::value, 1200, 1);
  feeds.apply(feed_word(FeedWord::value, 60));
  feeds.apply(feed_word(FeedWord::of_tool_call, 0));
  EXPECT_DOUBLE_EQ(bench.context.modal.feed.value, 20);
}

TEST(Feeds, AFeedOfZeroIsReportedAndTheLastOneStays) {
  PartBench bench;
  Feeds feeds(bench.context);
  feeds.apply(feed_word(FeedWord::value, 600));
  feeds.apply(feed_word(FeedWord::value, 0));
  EXPECT_DOUBLE_EQ(bench.context.modal.feed.value, 10);
  EXPECT_EQ(bench.log.take().size(), 1U);
}

TEST(Targets, ArePolarAboutThePole) {
  PartBench bench;
  const Feeds feeds(bench.context);
  Targets targets(bench.context, feeds);
  MotionWords pole;
  pole.axes[0] = {10, true, false};
  pole.axes[1] = {20, true, false};
  targets.set_pole(pole);
  MotionWords words;
  words.polar_radius = {5, true, false};
  words.polar_angle = {std::numbers::pi / 2, true, false};
  EXPECT_TRUE(targets.polar(words).isApprox(Vec3(10, 25, 0), 1e-12));
}

TEST(Targets, WithoutAPoleAreReported) {
  PartBench bench;
  const Feeds feeds(bench.context);
  EXPECT_FALSE(Targets(bench.context, feeds).has_pole(1));
  EXPECT_EQ(bench.log.take().front().code, "pole");
}

TEST(Labels, AreFoundOnceForEachText) {
  PartBench bench("LBL 1\nL X+1\nLBL 2\nLBL 2\n");
  Labels labels(bench.context, [](std::string_view line) {
    return line.starts_with("LBL ") ? std::string(line.substr(4)) : std::string();
  });
  EXPECT_EQ(labels.line_of("2", 1), 3U);
  EXPECT_EQ(labels.line_of("1", 1), 1U);
  EXPECT_EQ(labels.line_of("7", 1), std::nullopt);
  EXPECT_EQ(bench.log.take().size(), 2U) << "the second label 2 and the missing label 7";
}

TEST(CycleParameters, OfAnOlderProgramHaveTheirDefault) {
  PartBench bench;
  CycleParameters parameters(bench.context);
  Scanner scanner("DRILLING Q200=2 Q201=-5 Q206=150 Q202=5 Q203=+0 Q204=50");
  parameters.read(200, scanner);
  const auto words = parameters.drilling(200, 1);
  ASSERT_TRUE(words);
  EXPECT_EQ(words->clearance, 2);
  EXPECT_EQ(words->depth, -5);
  EXPECT_DOUBLE_EQ(words->feed, 2.5);
  EXPECT_EQ(words->bottom_dwell, 0) << "Q211 is newer";
}

TEST(CycleParameters, WithoutAValueAreReported) {
  PartBench bench;
  CycleParameters parameters(bench.context);
  EXPECT_EQ(parameters.drilling(200, 1), std::nullopt);
  EXPECT_EQ(bench.log.take().front().code, "cycle-parameter");
}

TEST(CycleParameters, TakePredefinedValues) {
  PartBench bench;
  CycleParameters parameters(bench.context);
  Scanner global("Q200=3");
  parameters.predefine(global);
  Scanner scanner("Q200=PREDEF");
  parameters.read(200, scanner);
  EXPECT_EQ(parameters.value(200), 3);
}

}  // namespace
}  // namespace feedscope::heidenhain
