#include "ui/load/load_view.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QComboBox>
#include <QLocale>
#include <QSignalSpy>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>

#include "core/base/data_folder.h"
#include "tests/ui/patience.h"
#include "ui/load/load_places_table.h"
#include "ui/load/operation_table.h"

namespace feedscope::ui {
namespace {

using testing::HasSubstr;

class LoadViewTest : public testing::Test {
 protected:
  LoadViewTest() { QLocale::setDefault(QLocale::c()); }

  void open(const std::filesystem::path& program = data_folder() / "resources/programs/trochoidal_slot.nc") {
    model.open(program);
    wait();
  }
  void wait() {
    ASSERT_TRUE(QTest::qWaitFor([this] { return !model.busy() && model.shown() != nullptr; }, patience));
  }
  void load_example() {
    view.open_file(
        QString::fromStdString((data_folder() / "resources/examples/trochoidal_slot_load.toml").string()));
    wait();
  }
  std::string message() const { return view.message().toStdString(); }

  Workbench model{shipped_machines(), make_setup({})};
  LoadView view{model};
};

TEST_F(LoadViewTest, AsksForOperationsFirst) {
  open();
  EXPECT_THAT(message(), HasSubstr("Say how the tools of the program are engaged"));
  EXPECT_EQ(model.shown()->run.sources.load, nullptr);
}

TEST_F(LoadViewTest, ShowsTheFiguresOfTheRunWithoutSimulatingItAgain) {
  open();
  const auto before = model.shown();
  load_example();
  const auto shown = model.shown();
  ASSERT_TRUE(shown->run.summary.load.has_value());
  EXPECT_EQ(shown->run.trajectory, before->run.trajectory);
  EXPECT_EQ(view.figures()->model()->rowCount(), 6);
  EXPECT_THAT(message(), HasSubstr("engagement as given"));
  EXPECT_THAT(message(), HasSubstr("feed motions without an operation"));
  // The same as a run that is simulated with the load from the start.
  feedscope::Setup setup = make_setup({});
  setup.load = view.setup();
  const feedscope::Run run = simulate_run(load_program(model.file()), setup);
  EXPECT_EQ(run.summary.load->all.predicted[3].largest, shown->run.summary.load->all.predicted[3].largest);
  EXPECT_EQ(run.summary.load->all.cutting_time, shown->run.summary.load->all.cutting_time);
}

TEST_F(LoadViewTest, HoldsForEveryRunAndCanBeUndone) {
  open();
  load_example();
  model.runs().duplicate(0);
  SetupState other = model.runs().current_item().setup;
  other.set_tolerance(0.02);
  model.runs().set_setup(1, other, "tolerance");
  wait();
  EXPECT_NE(model.shown()->run.sources.load, nullptr);
  model.runs().history().undo();
  model.runs().history().undo();
  model.runs().history().undo();
  wait();
  EXPECT_TRUE(model.runs().load().empty());
  EXPECT_TRUE(view.setup().empty());
  EXPECT_EQ(model.shown()->run.sources.load, nullptr);
  model.runs().history().redo();
  wait();
  EXPECT_EQ(view.setup().operations.size(), 1U);
  EXPECT_NE(model.shown()->run.sources.load, nullptr);
}

TEST_F(LoadViewTest, WhatDoesNotFitTheProgramIsSaidAndStays) {
  open();
  load_example();
  view.table()->setData(view.table()->index(0, OperationTable::tool), "99");
  wait();
  EXPECT_THAT(message(), HasSubstr("99"));
  EXPECT_EQ(model.shown()->run.sources.load, nullptr);
  EXPECT_EQ(view.setup().operations.front().tool, "99");
  view.table()->setData(view.table()->index(0, OperationTable::tool), "1");
  wait();
  EXPECT_NE(model.shown()->run.sources.load, nullptr);
}

TEST_F(LoadViewTest, AWrongCellIsRefusedAndSaid) {
  open();
  load_example();
  EXPECT_FALSE(view.table()->setData(view.table()->index(0, OperationTable::teeth), "none"));
  EXPECT_THAT(message(), HasSubstr("Teeth \"none\""));
}

TEST_F(LoadViewTest, RadialDepthBeyondTheDiameterIsSaid) {
  open();
  load_example();
  view.table()->setData(view.table()->index(0, OperationTable::first_number), "1");
  EXPECT_THAT(message(), HasSubstr("ae_mm 1.5 is larger than diameter_mm 1"));
}

TEST_F(LoadViewTest, AClickGoesToThePlace) {
  open();
  load_example();
  auto& places = static_cast<LoadPlacesTable&>(*view.places()->model());
  ASSERT_GT(places.rowCount(), 0);
  emit view.places()->clicked(places.index(0, 0));
  const LoadPlace& place = places.place(0);
  EXPECT_NEAR(model.cursor().state().time, (place.from + place.to) / 2, 1e-9);
}

TEST_F(LoadViewTest, AnotherProgramBeginsWithoutOperations) {
  open();
  load_example();
  open(data_folder() / "resources/programs/essid_table1.nc");
  EXPECT_TRUE(view.setup().empty());
  EXPECT_EQ(model.shown()->run.sources.load, nullptr);
}

TEST_F(LoadViewTest, FilesAreReadAsTheyAreWritten) {
  const QTemporaryDir folder;
  open();
  load_example();
  const LoadSetup before = view.setup();
  const QString file = folder.filePath("load.toml");
  view.save_file(file);
  view.table()->remove(0);
  EXPECT_TRUE(view.setup().empty());
  view.open_file(file);
  EXPECT_EQ(view.setup(), before);
}

TEST_F(LoadViewTest, AFileThatIsNoneIsReported) {
  open();
  QSignalSpy failures(&view, &Panel::failed);
  view.open_file("/nowhere/load.toml");
  ASSERT_EQ(failures.size(), 1);
  EXPECT_THAT(failures[0][0].toString().toStdString(), HasSubstr("/nowhere/load.toml"));
  view.save_file("/nowhere/load.toml");
  EXPECT_THAT(failures.back()[0].toString().toStdString(), HasSubstr("No operation"));
}

}  // namespace
}  // namespace feedscope::ui
