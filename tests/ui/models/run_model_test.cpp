#include "ui/models/run_model.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTemporaryDir>
#include <fstream>

#include "tests/ui/run_fixture.h"

namespace feedscope::ui {
namespace {

constexpr int patience = 20000;  // [ms]

class RunModelTest : public testing::Test {
 protected:
  std::filesystem::path write(const std::string& name, const std::string& text) {
    const std::filesystem::path file = std::filesystem::path(folder_.path().toStdString()) / name;
    std::ofstream(file) << text;
    return file;
  }

  static std::string long_program() {
    std::string text = "G21 G90 G94 F3000\n";
    for (int i = 0; i < 3000; ++i) {
      text += "G1 X" + std::to_string(i % 2) + " Y" + std::to_string(0.5 * i) + "\n";
    }
    return text;
  }

  static void wait_until_idle(RunModel& model) {
    QSignalSpy spy(&model, &RunModel::busy_changed);
    while (model.busy() && spy.wait(patience)) {
    }
    ASSERT_FALSE(model.busy());
  }

  RunModel model{shipped_machines(), make_setup({})};

 private:
  QTemporaryDir folder_;
};

TEST_F(RunModelTest, ReadsAndSimulatesAProgram) {
  QSignalSpy read(&model, &RunModel::program_changed);
  model.open(write("part.nc", test::small_program));
  EXPECT_TRUE(model.busy());
  wait_until_idle(model);
  ASSERT_NE(model.shown(), nullptr);
  EXPECT_EQ(model.program()->source->line_count(), 6U);
  EXPECT_EQ(read.count(), 2);  // none, then the new one
  EXPECT_GT(model.shown()->run.trajectory->duration(), 1);
  EXPECT_TRUE(model.cursor().valid());
}

TEST_F(RunModelTest, AnEditSimulatesAnewAndUndoBringsTheTimeBack) {
  model.open(write("part.nc", test::small_program));
  wait_until_idle(model);
  const double before = model.shown()->run.trajectory->duration();
  model.setup().set("X.jerk", 1.0);
  wait_until_idle(model);
  EXPECT_GT(model.shown()->run.trajectory->duration(), before);
  model.setup().history().undo();
  wait_until_idle(model);
  EXPECT_EQ(model.shown()->run.trajectory->duration(), before);
}

TEST_F(RunModelTest, TheLatestEditWins) {
  model.open(write("long.nc", long_program()));
  wait_until_idle(model);
  QSignalSpy runs(&model, &RunModel::run_changed);
  for (const double jerk : {11.0, 12.0, 13.0, 14.0}) {
    model.setup().set("X.jerk", jerk);
  }
  wait_until_idle(model);
  EXPECT_EQ(runs.count(), 1);
  EXPECT_DOUBLE_EQ(axis_limit(model.shown()->run.setup.machine, 'X', "jerk"), 14);
}

TEST_F(RunModelTest, AnEditWhileReadingStillShowsTheProgram) {
  model.open(write("long.nc", long_program()));
  model.setup().set("X.jerk", 12.0);
  wait_until_idle(model);
  ASSERT_NE(model.shown(), nullptr);
  EXPECT_DOUBLE_EQ(axis_limit(model.shown()->run.setup.machine, 'X', "jerk"), 12);
  ASSERT_NE(model.program(), nullptr);
}

TEST_F(RunModelTest, CancelKeepsTheRunThatIsShown) {
  model.open(write("long.nc", long_program()));
  wait_until_idle(model);
  const auto shown = model.shown();
  model.setup().set("X.jerk", 12.0);
  model.cancel();
  wait_until_idle(model);
  EXPECT_EQ(model.shown(), shown);
}

TEST_F(RunModelTest, AMissingFileIsAMessage) {
  QSignalSpy failed(&model, &RunModel::failed);
  model.open("no/such/file.nc");
  wait_until_idle(model);
  ASSERT_EQ(failed.count(), 1);
  EXPECT_THAT(failed.first().first().toString().toStdString(), testing::HasSubstr("file.nc"));
  EXPECT_EQ(model.shown(), nullptr);
}

TEST_F(RunModelTest, AnUnknownMachineIsAMessageAndTheOldOneStays) {
  QSignalSpy failed(&model, &RunModel::failed);
  model.choose_machine("spinner-mvc");
  ASSERT_EQ(failed.count(), 1);
  EXPECT_EQ(model.setup().file().machine.id, default_machine);
}

TEST_F(RunModelTest, AnEmptyProgramShowsAnEmptyRun) {
  model.open(write("empty.nc", ""));
  wait_until_idle(model);
  ASSERT_NE(model.shown(), nullptr);
  EXPECT_FALSE(model.cursor().valid());
}

TEST_F(RunModelTest, ClosingWhileBusyIsClean) {
  const auto file = write("long.nc", long_program());
  for (int i = 0; i < 5; ++i) {
    RunModel closing{shipped_machines(), make_setup({})};
    closing.open(file);
    closing.setup().set("X.jerk", 12.0);
  }
}

TEST_F(RunModelTest, OffersEveryMachineByName) {
  const auto choices = model.machine_choices();
  EXPECT_GE(choices.size(), 5U);
  for (const MachineChoice& choice : choices) {
    EXPECT_NE(choice.name, choice.id);
  }
}

}  // namespace
}  // namespace feedscope::ui
