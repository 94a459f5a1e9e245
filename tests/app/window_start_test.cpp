#include "app/window_start.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QApplication>
#include <QDeadlineTimer>
#include <QTemporaryDir>
#include <fstream>

#include "core/base/error.h"
#include "tests/ui/patience.h"
#include "tests/ui/run_fixture.h"

namespace feedscope {
namespace {

class WindowStartTest : public testing::Test {
 protected:
  std::string write(const std::string& name, const std::string& text) const {
    const std::filesystem::path file = std::filesystem::path(folder_.path().toStdString()) / name;
    std::ofstream(file) << text;
    return file.string();
  }

  void show(const RunOptions& options) {
    WindowStart(options, "").show(window, model);
    wait_until_idle();
  }

  void wait_until_idle() const {
    while (model.busy()) {
      QApplication::processEvents(QEventLoop::WaitForMoreEvents);
    }
  }

  static std::string refusal(const RunOptions& options, const std::string& lesson = "") {
    try {
      const WindowStart start(options, lesson);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

  ui::Workbench model{shipped_machines(), make_setup({})};
  ui::MainWindow window{model, ui::RenderBackend::software};

 private:
  QTemporaryDir folder_;
};

TEST_F(WindowStartTest, TheRunIsTheOneThatSimulateWouldMake) {
  RunOptions options;
  options.file = write("part.nc", "G64 P0.2\n" + test::small_program);
  options.machine = "huron-kx10";
  options.model = "essid";
  options.tolerance = "0.03";
  options.set = {"X.jerk=12", "alpha=2"};
  show(options);
  ASSERT_NE(model.shown(), nullptr);
  EXPECT_EQ(model.shown()->run.setup, make_setup(options.request(Dialect::iso)));
  EXPECT_EQ(model.setup().state().edits().size(), 4U) << "tolerance, whose it is, jerk and alpha are marked";
  EXPECT_FALSE(window.session().changed()) << "nothing to save: the command line says it all";
}

TEST_F(WindowStartTest, TheProgramIsReadAsAsked) {
  RunOptions options;
  options.file = write("part.nc", "G90 F20\nG1 X1\nX2\n");
  options.unit = "inch";
  show(options);
  ASSERT_NE(model.shown(), nullptr);
  EXPECT_NEAR(model.shown()->run.trajectory->path_length(), 50.8, 1e-9);
  EXPECT_EQ(model.reading(), options.reading());
  EXPECT_FALSE(window.session().changed());
}

TEST_F(WindowStartTest, WithoutAMachineTheLanguageOfTheProgramChooses) {
  RunOptions options;
  options.file = write("part.h", "0 BEGIN PGM A MM\n1 L X+20 F3000\n2 L Y+20\n3 END PGM A MM\n");
  options.tolerance = "0.02";
  show(options);
  EXPECT_EQ(model.setup().file().machine.id, "dmg-mori-evo40");
  EXPECT_EQ(contour_tolerance(model.setup().setup()), 0.02);
}

TEST_F(WindowStartTest, AMachineAloneWaitsForAProgram) {
  RunOptions options;
  options.machine = "huron-kx10";
  show(options);
  EXPECT_EQ(model.setup().file().machine.id, "huron-kx10");
  model.open(write("part.h", "0 BEGIN PGM A MM\n1 L X+20 F3000\n2 END PGM A MM\n"));
  wait_until_idle();
  EXPECT_EQ(model.setup().file().machine.id, "huron-kx10");
}

TEST_F(WindowStartTest, TracesAreLaidBesideTheProgram) {
  std::string table = "time [s],x [mm]\n";
  for (int i = 0; i <= 500; ++i) {
    table += std::to_string(0.002 * i) + "," + std::to_string(0.02 * i) + "\n";
  }
  RunOptions options;
  options.file = write("part.nc", "G21 G90 G1 X10 F600\nM30\n");
  const std::string trace = write("machine.csv", table);
  WindowStart(options, "", {trace}).show(window, model);
  const QDeadlineTimer deadline(ui::patience);
  while ((model.busy() || model.traces().busy()) && !deadline.hasExpired()) {
    QApplication::processEvents(QEventLoop::AllEvents, 50);
  }
  ASSERT_EQ(model.traces().items().size(), 1U);
  EXPECT_EQ(model.traces().status(0), ui::TraceStatus::compared) << model.traces().failure(0).toStdString();
  EXPECT_THROW(WindowStart(RunOptions(), "", {trace}), InputError) << "no program";
  EXPECT_THROW(WindowStart(options, "", {options.file}), InputError) << "a program is no trace";
}

TEST_F(WindowStartTest, EveryOptionIsRefusedWhereItWouldHaveNoEffect) {
  std::vector<std::pair<std::string, RunOptions>> cases;
  const auto with = [&](const std::string& name, auto change) {
    change(cases.emplace_back(name, RunOptions()).second);
  };
  with("--machine", [](RunOptions& o) { o.machine = "huron-kx10"; });
  with("--model", [](RunOptions& o) { o.model = "cam"; });
  with("--tolerance", [](RunOptions& o) { o.tolerance = "0.1"; });
  with("--set", [](RunOptions& o) { o.set = {"X.jerk=1"}; });
  const std::size_t of_run = cases.size();
  with("--dialect", [](RunOptions& o) { o.dialect = "iso"; });
  with("--unit", [](RunOptions& o) { o.unit = "mm"; });
  with("--skip-deleted", [](RunOptions& o) { o.skip_deleted = true; });
  with("--repeat-limit", [](RunOptions& o) { o.repeat_limit = 3; });
  with("--call-depth", [](RunOptions& o) { o.call_depth = 3; });
  with("--tool", [](RunOptions& o) { o.radii = {"1=5"}; });
  with("--tools", [](RunOptions& o) { o.tool_table = "tools.csv"; });
  with("--tools-unit", [](RunOptions& o) { o.table_unit = "inch"; });
  with("--wear-only", [](RunOptions& o) { o.wear_only = true; });
  with("--simulate-cut-off", [](RunOptions& o) { o.simulate_cut_off = true; });
  for (std::size_t i = 0; i < cases.size(); ++i) {
    auto& [name, options] = cases[i];
    EXPECT_THAT(refusal(options, "3"), testing::HasSubstr(name + " cannot be combined with lesson '3'"));
    EXPECT_EQ(refusal(options).find(name + " is an option of the program") == 0, i >= of_run)
        << refusal(options);
    options.file = "mine.feedscope";
    EXPECT_THAT(refusal(options),
                testing::HasSubstr(name + " cannot be combined with session 'mine.feedscope'"));
  }
}

}  // namespace
}  // namespace feedscope
