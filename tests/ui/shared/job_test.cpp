#include "ui/shared/job.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>
#include <atomic>
#include <new>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace feedscope::ui {
namespace {

using testing::ElementsAre;

/// Works until it is cancelled.
int until_cancelled(JobControl& control) {
  for (;;) {
    control.progress.report(0.5);
    std::this_thread::yield();
  }
}

TEST(JobTest, DeliversInTheThreadOfTheJobAndIsIdleThen) {
  Job<int> job;
  int result = 0;
  std::thread::id worker;
  job.start(
      [&worker](JobControl&) {
        worker = std::this_thread::get_id();
        return 7;
      },
      [&](const JobOutcome<int>& outcome) {
        EXPECT_FALSE(job.busy());
        result = outcome.result.value();
      });
  EXPECT_TRUE(job.busy());
  EXPECT_TRUE(QTest::qWaitFor([&] { return result == 7; }));
  EXPECT_NE(worker, std::this_thread::get_id());
}

TEST(JobTest, WhatWorkThrowsIsAMessage) {
  Job<int> job;
  std::vector<std::string> failures;
  const auto keep = [&](const JobOutcome<int>& outcome) {
    failures.push_back(outcome.failure.toStdString());
  };
  job.start([](JobControl&) -> int { throw std::runtime_error("axis X has no limit"); }, keep);
  EXPECT_TRUE(QTest::qWaitFor([&] { return failures.size() == 1; }));
  job.start([](JobControl&) -> int { throw std::bad_alloc(); }, keep);
  EXPECT_TRUE(QTest::qWaitFor([&] { return failures.size() == 2; }));
  EXPECT_THAT(failures,
              ElementsAre("axis X has no limit", "The program needs more memory than is available."));
}

TEST(JobTest, CancelledWorkIsDeliveredAsCancelled) {
  Job<int> job;
  bool cancelled = false;
  job.start(until_cancelled, [&](const JobOutcome<int>& outcome) { cancelled = outcome.cancelled(); });
  job.cancel();
  EXPECT_TRUE(QTest::qWaitFor([&] { return !job.busy(); }));
  EXPECT_TRUE(cancelled);
}

TEST(JobTest, AResultThatComesAfterTheCancelIsNotDelivered) {
  Job<int> job;
  std::atomic<bool> go = false;
  bool cancelled = false;
  job.start(
      [&go](JobControl&) {
        while (!go) {
          std::this_thread::yield();
        }
        return 1;
      },
      [&](const JobOutcome<int>& outcome) { cancelled = outcome.cancelled(); });
  job.cancel();
  go = true;
  EXPECT_TRUE(QTest::qWaitFor([&] { return !job.busy(); }));
  EXPECT_TRUE(cancelled);
}

TEST(JobTest, NewerWorkReplacesTheOneUnderWayAndTheOneThatWaits) {
  Job<int> job;
  QSignalSpy busy(&job, &JobBase::busy_changed);
  std::vector<int> results;
  const auto keep = [&](const JobOutcome<int>& outcome) { results.push_back(outcome.result.value_or(-1)); };
  job.start(until_cancelled, keep);
  job.start([](JobControl&) { return 1; }, keep);
  job.start([](JobControl&) { return 2; }, keep);
  EXPECT_TRUE(QTest::qWaitFor([&] { return !job.busy(); }));
  EXPECT_THAT(results, ElementsAre(2));
  EXPECT_EQ(busy.count(), 2);
}

TEST(JobTest, TellsBeforeItDeliversAndNothingOnceCancelled) {
  Job<int> job;
  std::vector<std::string> told;
  job.start(
      [&told](JobControl& control) {
        control.tell([&told] { told.emplace_back("first"); });
        control.tell([&told] { told.emplace_back("second"); });
        return 0;
      },
      [&](const JobOutcome<int>&) { told.emplace_back("delivered"); });
  EXPECT_TRUE(QTest::qWaitFor([&] { return !job.busy(); }));
  EXPECT_THAT(told, ElementsAre("first", "second", "delivered"));

  told.clear();
  std::atomic<bool> has_told = false;
  job.start(
      [&](JobControl& control) {
        control.tell([&told] { told.emplace_back("too late"); });
        has_told = true;
        return until_cancelled(control);
      },
      [](const JobOutcome<int>&) {});
  while (!has_told) {
    std::this_thread::yield();
  }
  job.cancel();
  EXPECT_TRUE(QTest::qWaitFor([&] { return !job.busy(); }));
  EXPECT_THAT(told, ElementsAre());
}

TEST(JobTest, ReportsProgressWhileItIsBusy) {
  Job<int> job;
  QSignalSpy progressed(&job, &JobBase::progressed);
  job.start(until_cancelled, [](const JobOutcome<int>&) {});
  EXPECT_TRUE(QTest::qWaitFor([&] { return !progressed.empty() && progressed.last().first() == 0.5; }));
  job.cancel();
  EXPECT_TRUE(QTest::qWaitFor([&] { return !job.busy(); }));
  EXPECT_EQ(job.fraction(), 1);
}

TEST(JobTest, DestructionCancelsAndDeliversNothing) {
  bool delivered = false;
  std::atomic<bool> ended = false;
  {
    Job<int> job;
    job.start(
        [&ended](JobControl& control) {
          try {
            return until_cancelled(control);
          } catch (const Cancelled&) {
            ended = true;
            throw;
          }
        },
        [&](const JobOutcome<int>&) { delivered = true; });
  }
  EXPECT_TRUE(QTest::qWaitFor([&] { return ended.load(); }));
  QTest::qWait(50);
  EXPECT_FALSE(delivered);
}

}  // namespace
}  // namespace feedscope::ui
