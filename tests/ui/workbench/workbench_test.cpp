#include "ui/workbench/workbench.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QFileInfo>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <algorithm>
#include <fstream>
#include <utility>

#include "tests/ui/patience.h"
#include "tests/ui/run_fixture.h"
#include "ui/workbench/simulate_shown.h"

namespace feedscope::ui {
namespace {

class WorkbenchTest : public testing::Test {
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

  static void wait_until_idle(Workbench& model) {
    QSignalSpy spy(&model, &Workbench::busy_changed);
    while (model.busy() && spy.wait(patience)) {
    }
    ASSERT_FALSE(model.busy());
  }

  template <class Slot>
  void connect_drawn(Slot slot) {
    QObject::connect(&model, &Workbench::drawn_changed, &model, slot);
  }

  Workbench model{shipped_machines(), make_setup({})};

 private:
  QTemporaryDir folder_;
};

TEST_F(WorkbenchTest, ReadsAndSimulatesAProgram) {
  QSignalSpy read(&model, &Workbench::program_changed);
  model.open(write("part.nc", test::small_program));
  EXPECT_TRUE(model.busy());
  wait_until_idle(model);
  ASSERT_NE(model.shown(), nullptr);
  EXPECT_EQ(model.program()->source->line_count(), 6U);
  EXPECT_EQ(read.count(), 2);  // none, then the new one
  EXPECT_GT(model.shown()->run.trajectory->duration(), 1);
  EXPECT_TRUE(model.cursor().valid());
}

TEST_F(WorkbenchTest, AFileThatIsOpenedRightAfterItWasWrittenIsReadOnce) {
  const std::filesystem::path part = write("part.nc", test::small_program);
  model.open(part);
  wait_until_idle(model);
  write("part.nc", "G21 G1 X1 F100\n");
  QSignalSpy noticed(&model, &Workbench::noticed);
  model.open(part);
  wait_until_idle(model);
  const auto program = model.program();
  EXPECT_FALSE(noticed.wait(1000)) << "what changed before it was read is no change";
  EXPECT_EQ(model.program(), program);
  write("part.nc", "G21 G1 X2 F100\nX3\n");
  EXPECT_TRUE(noticed.wait(patience)) << "what changes later is read again";
}

TEST_F(WorkbenchTest, ReadsTheProgramAnewInAnotherWayAndAnotherProgramAsUsual) {
  const std::filesystem::path part = write("part.nc", "G21 G17\nG42 D7 G1 X10 F600\nX20\nX30\n");
  model.open(part);
  wait_until_idle(model);
  EXPECT_EQ(model.program()->cutters.at(0).source, CutterSource::unknown);
  ReadOptions options;
  options.radii.set("7", 4);
  model.set_reading(options);
  wait_until_idle(model);
  EXPECT_EQ(model.program()->cutters.at(0).source, CutterSource::asked);
  EXPECT_EQ(model.shown()->run.path->segments.back().end.y(), -4);
  model.reload();
  wait_until_idle(model);
  EXPECT_EQ(model.reading(), options);
  model.open(write("other.nc", test::small_program));
  wait_until_idle(model);
  EXPECT_EQ(model.reading(), ReadOptions());
}

TEST_F(WorkbenchTest, AnEditSimulatesAnewAndUndoBringsTheTimeBack) {
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

/// Each stage reports what it takes: one that says nothing would leave the bar near its end meanwhile.
TEST_F(WorkbenchTest, EveryStageOfARunAdvancesItsProgress) {
  const LoadedProgram input = load_program(std::make_shared<const SourceText>("part.nc", long_program()));
  Progress sampling;
  const feedscope::Run run = simulate_run(input, make_setup({}));
  sample_executed(run.trajectory, default_max_points, {}, &sampling);
  EXPECT_NEAR(sampling.fraction(), 1, 1e-9);
  Progress whole;
  simulate_shown(input, make_setup({}), &whole);
  EXPECT_NEAR(whole.fraction(), 1, 1e-9) << "shares of the stages do not add up";
  sampling.cancel();
  EXPECT_THROW(sample_executed(run.trajectory, default_max_points, {}, &sampling), Cancelled);
}

TEST_F(WorkbenchTest, TheLatestEditWins) {
  model.open(write("long.nc", long_program()));
  wait_until_idle(model);
  QSignalSpy results(&model.runs(), &RunList::result_changed);
  for (const double jerk : {11.0, 12.0, 13.0, 14.0}) {
    model.setup().set("X.jerk", jerk);
  }
  wait_until_idle(model);
  EXPECT_EQ(results.count(), 1);
  EXPECT_DOUBLE_EQ(axis_limit(model.shown()->run.setup.machine, 'X', "jerk"), 14);
}

TEST_F(WorkbenchTest, PicturesDrawARunBeforeItsSummaryIsThere) {
  std::vector<std::shared_ptr<const ShownRun>> drawn;
  connect_drawn([&] { drawn.push_back(model.drawn()); });
  model.open(write("long.nc", long_program()));
  wait_until_idle(model);
  ASSERT_GE(drawn.size(), 2U);
  const auto& first = drawn[drawn.size() - 2];
  ASSERT_NE(first, nullptr);
  EXPECT_EQ(first->line_times, nullptr);
  EXPECT_EQ(first->run.summary.cycle_time, 0);
  EXPECT_EQ(model.drawn(), model.shown());
  EXPECT_EQ(first->samples, model.shown()->samples) << "nothing is drawn twice";
  EXPECT_EQ(first->envelope, model.shown()->envelope);
  EXPECT_EQ(first->run.trajectory, model.shown()->run.trajectory);
  EXPECT_GT(model.shown()->run.summary.cycle_time, 0);
}

TEST_F(WorkbenchTest, TheCursorStaysWhenTheRestOfARunComes) {
  connect_drawn([&] {
    if (model.drawn() != nullptr && model.shown() == nullptr) {
      model.cursor().set_time(1);
    }
  });
  model.open(write("long.nc", long_program()));
  wait_until_idle(model);
  EXPECT_EQ(model.cursor().state().time, 1);
}

TEST_F(WorkbenchTest, ARunThatIsDrawnAndThenCancelledIsNotDrawnAnyMore) {
  bool was_drawn = false;
  connect_drawn([&] {
    if (model.drawn() != nullptr && !std::exchange(was_drawn, true)) {
      model.cancel();
    }
  });
  model.open(write("long.nc", long_program()));
  wait_until_idle(model);
  EXPECT_TRUE(was_drawn);
  EXPECT_EQ(model.drawn(), nullptr);
  EXPECT_FALSE(model.cursor().valid());
  EXPECT_EQ(model.runs().status(0), RunStatus::cancelled);
}

TEST_F(WorkbenchTest, AnEditOfARunThatIsDrawnReplacesIt) {
  int drawn = 0;
  connect_drawn([&] {
    if (model.drawn() != nullptr && ++drawn == 1) {
      model.setup().set("X.jerk", 14.0);
      EXPECT_EQ(model.drawn(), nullptr);
    }
  });
  model.open(write("long.nc", long_program()));
  wait_until_idle(model);
  ASSERT_NE(model.shown(), nullptr);
  EXPECT_DOUBLE_EQ(axis_limit(model.shown()->run.setup.machine, 'X', "jerk"), 14);
}

TEST_F(WorkbenchTest, AnEditWhileReadingStillShowsTheProgram) {
  model.open(write("long.nc", long_program()));
  model.setup().set("X.jerk", 12.0);
  wait_until_idle(model);
  ASSERT_NE(model.shown(), nullptr);
  EXPECT_DOUBLE_EQ(axis_limit(model.shown()->run.setup.machine, 'X', "jerk"), 12);
  ASSERT_NE(model.program(), nullptr);
}

TEST_F(WorkbenchTest, ACancelledRunShowsNothingUntilItIsSimulatedAgain) {
  model.open(write("long.nc", long_program()));
  wait_until_idle(model);
  model.cursor().set_line(500);
  const double place = model.cursor().state().path_length;
  model.setup().set("X.jerk", 12.0);
  EXPECT_EQ(model.shown(), nullptr);
  EXPECT_FALSE(model.cursor().valid());
  model.cancel();
  wait_until_idle(model);
  EXPECT_EQ(model.shown(), nullptr);
  EXPECT_EQ(model.runs().status(0), RunStatus::cancelled);
  model.simulate_again(0);
  wait_until_idle(model);
  ASSERT_NE(model.shown(), nullptr);
  EXPECT_DOUBLE_EQ(axis_limit(model.shown()->run.setup.machine, 'X', "jerk"), 12);
  EXPECT_NEAR(model.cursor().state().path_length, place, 1e-6) << "the cursor comes back to its place";
}

TEST_F(WorkbenchTest, AProgramWhoseReadingWasCancelledIsReadAgain) {
  model.open(write("long.nc", long_program()));
  model.cancel();
  wait_until_idle(model);
  EXPECT_EQ(model.runs().status(0), RunStatus::cancelled);
  model.simulate_again(0);
  wait_until_idle(model);
  EXPECT_NE(model.shown(), nullptr);
}

TEST_F(WorkbenchTest, CancellingNothingGivesNothingUp) {
  model.cancel();
  EXPECT_EQ(model.runs().status(0), RunStatus::waiting);
}

TEST_F(WorkbenchTest, AMissingFileIsAMessage) {
  QSignalSpy failed(&model, &Workbench::failed);
  model.open("no/such/file.nc");
  wait_until_idle(model);
  ASSERT_EQ(failed.count(), 1);
  EXPECT_THAT(failed.first().first().toString().toStdString(), testing::HasSubstr("file.nc"));
  EXPECT_EQ(model.shown(), nullptr);
}

TEST_F(WorkbenchTest, AnUnknownMachineIsAMessageAndTheOldOneStays) {
  QSignalSpy failed(&model, &Workbench::failed);
  model.choose_machine("spinner-mvc");
  ASSERT_EQ(failed.count(), 1);
  EXPECT_EQ(model.setup().file().machine.id, default_machine);
}

TEST_F(WorkbenchTest, AnEmptyProgramShowsAnEmptyRun) {
  model.open(write("empty.nc", ""));
  wait_until_idle(model);
  ASSERT_NE(model.shown(), nullptr);
  EXPECT_FALSE(model.cursor().valid());
}

TEST_F(WorkbenchTest, EveryRunIsSimulatedTheCurrentOneFirst) {
  model.open(write("long.nc", long_program()));
  wait_until_idle(model);
  model.runs().duplicate(0);
  model.runs().duplicate(1);
  QSignalSpy results(&model.runs(), &RunList::result_changed);
  for (const std::size_t row : {0, 1, 2}) {
    SetupState setup = model.runs().items()[row].setup;
    setup.set("X.jerk", 3.0 + static_cast<double>(row));
    model.runs().set_setup(row, setup, "X.jerk");
  }
  wait_until_idle(model);
  ASSERT_EQ(results.count(), 3);
  EXPECT_EQ(results.first().first().value<std::size_t>(), model.runs().current());
  for (std::size_t row = 0; row < 3; ++row) {
    EXPECT_EQ(model.runs().status(row), RunStatus::simulated);
  }
}

TEST_F(WorkbenchTest, AnotherCurrentRunIsShownAtTheSamePlace) {
  model.open(write("part.nc", test::small_program));
  wait_until_idle(model);
  model.runs().duplicate(0);
  model.setup().set("X.jerk", 1.0);
  wait_until_idle(model);
  model.cursor().set_line(4);
  model.cursor().set_time(model.cursor().state().time + 0.05);
  const double slower = model.shown()->run.trajectory->duration();
  model.runs().select(0);
  EXPECT_LT(model.shown()->run.trajectory->duration(), slower);
  EXPECT_EQ(model.cursor().state().line, 4U);
}

TEST_F(WorkbenchTest, ACancelledRunWaitsForTheNextChange) {
  model.open(write("long.nc", long_program()));
  wait_until_idle(model);
  model.setup().set("X.jerk", 12.0);
  model.cancel();
  wait_until_idle(model);
  EXPECT_EQ(model.runs().status(0), RunStatus::cancelled);
  model.setup().set("X.jerk", 13.0);
  wait_until_idle(model);
  EXPECT_EQ(model.runs().status(0), RunStatus::simulated);
}

TEST_F(WorkbenchTest, AFileThatChangesIsReadAgainAndTheCursorStaysAtItsLine) {
  const auto file = write("part.nc", test::small_program);
  model.open(file);
  wait_until_idle(model);
  model.cursor().set_line(4);
  QSignalSpy noticed(&model, &Workbench::noticed);
  write("part.nc", "G21 G90 G94 F3000\nG1 X20\nG1 X50 Y5\nG1 X90\n");
  ASSERT_TRUE(noticed.wait(patience));
  wait_until_idle(model);
  EXPECT_EQ(model.program()->source->line_count(), 4U);
  EXPECT_EQ(model.cursor().state().line, 4U);
}

TEST_F(WorkbenchTest, AToleranceReplacesTheProgramsOwn) {
  model.open(write("part.nc", "G64 P0.2\n" + test::small_program));
  wait_until_idle(model);
  model.choose_machine("spinner-mvc850");  // by itself it would run on a LinuxCNC, which has no such setting
  wait_until_idle(model);
  ASSERT_TRUE(model.set_tolerance(0.01));
  EXPECT_EQ(std::get<std::string>(model.setup().state().value("program_tolerance")), "off");
  EXPECT_FALSE(model.set_tolerance(-1));
  model.setup().history().undo();
  EXPECT_EQ(std::get<std::string>(model.setup().state().value("program_tolerance")), "on");
}

/// Runs were compared on the program before; what was set up on the machine is still its own.
TEST_F(WorkbenchTest, AnotherProgramBeginsWithOneRunAndFollowsItsOwnTolerance) {
  const auto first = write("part.nc", test::small_program);
  model.open(first);
  wait_until_idle(model);
  model.setup().set("X.jerk", 12.0);
  ASSERT_TRUE(model.set_tolerance(0.01));
  model.runs().duplicate(0);
  model.runs().rename(1, "fine");
  ASSERT_TRUE(model.set_tolerance(0.005));
  wait_until_idle(model);
  model.reload();
  wait_until_idle(model);
  ASSERT_EQ(model.runs().items().size(), 2U) << "the same program again";
  model.open(write("other.nc", "G64 P0.2\n" + test::small_program));
  wait_until_idle(model);
  ASSERT_EQ(model.runs().items().size(), 1U);
  EXPECT_EQ(model.runs().current_item().name, QString());
  EXPECT_EQ(model.setup().state().edits(), (std::map<std::string, SettingValue>{{"X.jerk", 12.0}}));
  EXPECT_EQ(model.runs().tolerance(model.runs().current_item())->max, 0.2);
  ASSERT_NE(model.shown(), nullptr);
  EXPECT_FALSE(model.setup().history().canUndo()) << "undo would bring runs of another program back";
}

/// What was typed before any program was open is meant for the first.
TEST_F(WorkbenchTest, TheFirstProgramRunsAsItWasSetUpBefore) {
  ASSERT_TRUE(model.set_tolerance(0.02));
  model.open(write("part.nc", "G64 P0.2\n" + test::small_program));
  wait_until_idle(model);
  EXPECT_EQ(model.runs().tolerance(model.runs().current_item())->max, 0.02);
}

/// As --tolerance, a sweep and a lesson set it.
TEST_F(WorkbenchTest, AToleranceGivesTheSettingsOfTheCommandLine) {
  for (const char* words : {"G64 P0.2\n", ""}) {
    model.open(write("part.nc", words + test::small_program));
    wait_until_idle(model);
    model.choose_machine("spinner-mvc850");
    wait_until_idle(model);
    ASSERT_TRUE(model.set_tolerance(0.042));
    EXPECT_EQ(model.setup().setup(), make_setup({model.setup().file().machine.id, "essid", 0.042})) << words;
    model.setup().history().undo();
  }
}

TEST_F(WorkbenchTest, AProgramRunsOnAMachineWithItsControlUntilSomeoneChoosesOne) {
  const auto heidenhain = write("part.h", "0 BEGIN PGM A MM\n1 L X+20 F3000\n2 L Y+20\n3 END PGM A MM\n");
  const auto plain = write("part.nc", test::small_program);
  QSignalSpy noticed(&model, &Workbench::noticed);
  model.open(heidenhain);
  wait_until_idle(model);
  EXPECT_EQ(model.setup().file().machine.id, "dmg-mori-evo40");
  ASSERT_NE(model.shown(), nullptr);
  EXPECT_EQ(model.shown()->run.setup.machine.id, "dmg-mori-evo40");
  EXPECT_EQ(noticed.count(), 1);
  model.open(plain);
  wait_until_idle(model);
  EXPECT_EQ(model.setup().file().machine.id, default_machine);
  model.choose_machine("huron-kx10");
  model.open(heidenhain);
  wait_until_idle(model);
  EXPECT_EQ(model.setup().file().machine.id, "huron-kx10");
}

TEST_F(WorkbenchTest, ASavedMachineReadsBackWithAllChangesAndIsTheNewBase) {
  model.setup().set("X.jerk", 21.0);
  model.setup().set("alpha", 3.0);
  const auto file = write("mine.toml", "");
  model.save_machine(file);
  EXPECT_EQ(model.setup().file().machine.id, "mine");
  EXPECT_TRUE(model.setup().state().edits().empty());
  EXPECT_EQ(std::get<double>(model.setup().state().value("alpha")), 3);
  const Machine machine = shipped_machines().load(file.string());
  EXPECT_EQ(axis_limit(machine, 'X', "jerk"), 21);
  EXPECT_EQ(machine.provenance.at("alpha"), (Provenance{"set by hand", false}))
      << "whoever set it assumed nothing";
  EXPECT_EQ(machine.name, "Spinner MVC 850 (mine)");
  model.save_machine(file, " Hall 3, left ");
  EXPECT_EQ(shipped_machines().load(file.string()).name, "Hall 3, left");
}

TEST_F(WorkbenchTest, AMachineThatCannotBeSavedIsAMessage) {
  QSignalSpy failed(&model, &Workbench::failed);
  model.save_machine("/no/such/folder/mine.toml");
  ASSERT_EQ(failed.count(), 1);
  EXPECT_THAT(failed.first().first().toString().toStdString(), testing::HasSubstr("mine.toml"));
}

TEST_F(WorkbenchTest, ProgressSaysWhatIsDone) {
  QSignalSpy progress(&model, &Workbench::progressed);
  std::string text = "G21 G90 G94 F3000\n";
  for (int i = 0; i < 60'000; ++i) {
    text += "G1 X" + std::to_string(i % 2) + " Y" + std::to_string(0.5 * i) + "\n";
  }
  model.open(write("longer.nc", text));
  wait_until_idle(model);
  ASSERT_GT(progress.count(), 0);
  EXPECT_THAT(progress.last().first().toString().toStdString(), testing::HasSubstr("blocks"));
}

TEST_F(WorkbenchTest, ClosingWhileBusyIsClean) {
  const auto file = write("long.nc", long_program());
  for (int i = 0; i < 5; ++i) {
    Workbench closing{shipped_machines(), make_setup({})};
    closing.open(file);
    closing.setup().set("X.jerk", 12.0);
  }
}

TEST_F(WorkbenchTest, OffersEveryMachineByName) {
  const auto choices = model.machine_choices();
  EXPECT_GE(choices.size(), 5U);
  for (const MachineChoice& choice : choices) {
    EXPECT_NE(choice.name, choice.id);
  }
}

TEST_F(WorkbenchTest, AMachineOfOnesOwnStaysInTheListWithItsOwner) {
  const std::filesystem::path file = write("my-mill.toml", "");
  model.save_machine(file, "My mill");
  model.choose_machine("huron-kx10");
  const auto choices = model.machine_choices();
  const auto own = std::ranges::find(choices, "My mill", &MachineChoice::name);
  ASSERT_NE(own, choices.end());
  EXPECT_EQ(own->file.toStdString(), file.string());
  EXPECT_EQ(own->owner, QFileInfo(own->file).owner());
  model.choose_machine(own->key());
  EXPECT_EQ(model.setup().file().machine.id, "my-mill");
  std::filesystem::remove(file);
  const auto after = model.machine_choices();
  EXPECT_EQ(std::ranges::find(after, "My mill", &MachineChoice::name), after.end()) << "a file that is gone";
}

TEST_F(WorkbenchTest, SaysWhereTheLanguageOfTheProgramChoseTheMachine) {
  EXPECT_FALSE(model.machine_by_language()) << "there is no program";
  model.open(write("plate.h", "BEGIN PGM A MM\nL X+10 F1000\nEND PGM A MM\n"));
  wait_until_idle(model);
  EXPECT_TRUE(model.machine_by_language());
  model.choose_machine("huron-kx10");
  EXPECT_FALSE(model.machine_by_language());
}

}  // namespace
}  // namespace feedscope::ui
