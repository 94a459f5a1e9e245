#include "ui/workbench/trace_list.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>

#include "core/base/error.h"
#include "tests/ui/patience.h"
#include "tests/ui/run_fixture.h"
#include "tests/ui/trace_fixture.h"
#include "ui/workbench/workbench.h"

namespace feedscope::ui {
namespace {

using testing::HasSubstr;

class TraceListTest : public testing::Test {
 protected:
  bool wait() {
    return QTest::qWaitFor([this] { return !model.busy() && !traces.busy(); }, patience);
  }

  const feedscope::Run run = test::simulate_text(test::small_program);
  const test::WrittenFiles files;
  Workbench model{shipped_machines(), make_setup({})};
  TraceList& traces = model.traces();
  QSignalSpy failed{&traces, &TraceList::failed};
};

TEST_F(TraceListTest, LaysATraceBesideTheCurrentRunAndEveryOther) {
  model.show(run);
  traces.add(files.write("machine.csv", test::trace_table(run)));
  EXPECT_EQ(traces.status(0), TraceStatus::waiting);
  ASSERT_TRUE(wait());
  ASSERT_EQ(traces.status(0), TraceStatus::compared) << traces.failure(0).toStdString();
  const auto first = traces.result(0);
  EXPECT_NEAR(first->agreement.measured_time, run.summary.cycle_time, 2e-3);
  EXPECT_LT(std::abs(first->agreement.time_error()), 1e-3);
  EXPECT_EQ(traces.items()[0].name, "machine.csv");
  model.set_tolerance(0.001);
  EXPECT_EQ(traces.result(0), nullptr) << "that of another run is never shown";
  ASSERT_TRUE(wait());
  ASSERT_EQ(traces.status(0), TraceStatus::compared);
  EXPECT_GT(traces.result(0)->agreement.time_error(), 0.005);
  EXPECT_EQ(traces.trace(0), first->trace) << "read once";
}

TEST_F(TraceListTest, WaitsForARunAndGoesWithTheProgram) {
  traces.add(files.write("machine.csv", test::trace_table(run)));
  ASSERT_TRUE(wait());
  EXPECT_NE(traces.trace(0), nullptr);
  EXPECT_EQ(traces.status(0), TraceStatus::waiting);
  traces.set_run(make_shown(run));
  ASSERT_TRUE(wait());
  EXPECT_EQ(traces.status(0), TraceStatus::compared);
  model.show(run);
  EXPECT_TRUE(traces.items().empty());
}

TEST_F(TraceListTest, SaysWhatIsWrong) {
  model.show(run);
  traces.add(files.write("empty.csv", "time [s],x [mm]\n0,1\n"));
  traces.add("/no/such/file.csv");
  ASSERT_TRUE(wait());
  EXPECT_EQ(traces.status(0), TraceStatus::failed);
  EXPECT_EQ(traces.status(1), TraceStatus::failed);
  EXPECT_THAT(traces.failure(1).toStdString(), HasSubstr("/no/such/file.csv"));
  EXPECT_EQ(failed.size(), 2);
  EXPECT_THROW(traces.add("machine.csv", "x=1:furlong"), InputError);
  EXPECT_EQ(traces.items().size(), 2U);
}

TEST_F(TraceListTest, ACancelledTraceIsComparedOnceMoreWhenItIsWanted) {
  model.show(run);
  traces.add(files.write("machine.csv", test::trace_table(run)));
  traces.cancel();
  EXPECT_EQ(traces.status(0), TraceStatus::cancelled);
  ASSERT_TRUE(wait());
  EXPECT_EQ(traces.result(0), nullptr);
  traces.resume(0);
  ASSERT_TRUE(wait());
  EXPECT_EQ(traces.status(0), TraceStatus::compared);
}

TEST_F(TraceListTest, IsReadAgainWithOtherColumns) {
  model.show(run);
  traces.add(files.write("machine.csv", test::trace_table(run)), "time=1,x=2:-mm,y=3:mm");
  traces.set_columns(0, "time=1,x=2:mm,y=3:mm");
  ASSERT_TRUE(wait());
  ASSERT_EQ(traces.status(0), TraceStatus::compared);
  EXPECT_GT(traces.result(0)->found.pose.mirror.x(), 0);
  traces.remove(0);
  EXPECT_TRUE(traces.items().empty());
}

}  // namespace
}  // namespace feedscope::ui
