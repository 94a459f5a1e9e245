#include "ui/workbench/run_comparison.h"

#include <gtest/gtest.h>

#include <QCoreApplication>

#include "tests/ui/run_fixture.h"

namespace feedscope::ui {
namespace {

constexpr std::nullopt_t none = std::nullopt;

TEST(ReferenceRow, IsNeverTheRunItself) {
  EXPECT_EQ(reference_row(1, 0, none, none), none);
  EXPECT_EQ(reference_row(1, 0, 0, 0), none);
  EXPECT_EQ(reference_row(3, 0, none, none), 1U);
  EXPECT_EQ(reference_row(3, 2, none, none), 0U);
  EXPECT_EQ(reference_row(3, 1, 2, 0), 2U) << "the chosen one comes first";
  EXPECT_EQ(reference_row(3, 2, 2, 1), 1U) << "then the one beside";
  EXPECT_EQ(reference_row(3, 0, 7, none), 1U) << "one that is gone is none";
}

class RunComparisonTest : public testing::Test {
 protected:
  RunComparisonTest() {
    const LoadedProgram input =
        load_program(std::make_shared<const SourceText>("test.nc", test::small_program));
    SetupState fine = runs.items()[0].setup;
    fine.set("contour_tolerance_mm", 0.005);
    runs.duplicate_as(0, fine);
    for (const RunItem& item : runs.items()) {
      runs.set_result(item.id, make_shown(simulate_run(input, item.setup.setup())));
    }
  }
  void wait() {
    while (comparison.busy()) {
      QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    }
  }

  RunList runs{make_setup({})};
  RunComparison comparison{runs};
};

/// Whichever runs stand beside each other, of any number, in any order.
TEST_F(RunComparisonTest, RunsBesideEachOtherAreComparedWithEachOther) {
  for (int more = 0; more < 3; ++more) {
    runs.duplicate(0);
  }
  for (std::size_t current = 0; current < runs.items().size(); ++current) {
    runs.select(current);
    for (std::size_t beside = 0; beside < runs.items().size(); ++beside) {
      if (beside == current) {
        continue;
      }
      comparison.set_beside(runs.items()[beside].id);
      comparison.choose(0);
      EXPECT_EQ(comparison.reference_of(current), beside);
      EXPECT_EQ(comparison.reference_of(beside), current);
      for (std::size_t chosen = 0; chosen < runs.items().size(); ++chosen) {
        comparison.choose(runs.items()[chosen].id);
        EXPECT_EQ(comparison.reference_of(current), chosen == current ? beside : chosen);
        EXPECT_EQ(comparison.reference_of(beside), chosen == beside ? current : chosen);
      }
    }
  }
}

TEST_F(RunComparisonTest, MakesThePathOnceAndSaysWhenItIsThere) {
  int ready = 0;
  QObject::connect(&comparison, &RunComparison::ready, [&] { ++ready; });
  EXPECT_EQ(comparison.samples(1), nullptr);
  EXPECT_EQ(comparison.samples(1), nullptr);
  wait();
  EXPECT_EQ(ready, 1);
  const auto samples = comparison.samples(1);
  ASSERT_NE(samples, nullptr);
  EXPECT_NEAR(double{samples->lost.back()},
              runs.result(1)->run.trajectory->duration() - runs.result(0)->run.trajectory->duration(), 1e-6);
  EXPECT_EQ(comparison.samples(1), samples);
}

TEST_F(RunComparisonTest, IsGivenUpAndStartsAgainWhenAskedFor) {
  int ready = 0;
  int cancelled = 0;
  QObject::connect(&comparison, &RunComparison::ready, [&] { ++ready; });
  QObject::connect(&comparison, &RunComparison::cancelled, [&] { ++cancelled; });
  comparison.cancel();
  EXPECT_EQ(cancelled, 0) << "nothing was under way";
  comparison.samples(1);
  EXPECT_TRUE(comparison.busy()) << "even if the work is done: it is not delivered yet";
  comparison.cancel();
  EXPECT_EQ(cancelled, 1);
  EXPECT_FALSE(comparison.busy());
  QCoreApplication::processEvents();
  EXPECT_EQ(ready, 0);
  EXPECT_EQ(comparison.samples(1), nullptr);
  wait();
  EXPECT_EQ(ready, 1);
  EXPECT_NE(comparison.samples(1), nullptr);
  EXPECT_EQ(comparison.progress(), 1);
}

TEST_F(RunComparisonTest, FollowsTheChoiceAndForgetsRunsThatAreGone) {
  comparison.choose(runs.items()[1].id);
  EXPECT_EQ(comparison.reference_of(0), 1U);
  EXPECT_EQ(comparison.reference_of(1), 0U);
  comparison.samples(0);
  runs.remove(1);
  EXPECT_EQ(comparison.chosen(), 0);
  EXPECT_EQ(comparison.reference_of(0), none);
  EXPECT_EQ(comparison.samples(0), nullptr);
  EXPECT_FALSE(comparison.busy());
}

TEST_F(RunComparisonTest, GoesWhileBusy) {
  auto short_lived = std::make_unique<RunComparison>(runs);
  short_lived->samples(0);
  short_lived->samples(1);
  short_lived.reset();
  QCoreApplication::processEvents();
}

}  // namespace
}  // namespace feedscope::ui
