#include <gtest/gtest.h>

#include <QComboBox>
#include <QLabel>
#include <QSignalSpy>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <fstream>
#include <map>
#include <random>

#include "core/analysis/contour/contour_report.h"
#include "tests/support/random_cases.h"
#include "tests/ui/patience.h"
#include "tests/ui/run_fixture.h"
#include "ui/annotations/annotation_overlay.h"
#include "ui/charts/charts_panel.h"
#include "ui/contour/contour_view.h"
#include "ui/language/texts.h"
#include "ui/program_text/program_panel.h"
#include "ui/runs/run_notice.h"
#include "ui/runs/runs_view.h"
#include "ui/slow_places/slow_places_view.h"
#include "ui/why/why_view.h"
#include "ui/window/main_window.h"

namespace feedscope::ui {
namespace {

const int actions = test::random_cases(250);
constexpr std::array tolerances{0.01, 0.02, 0.05};
constexpr std::array jerks{5.0, 10.0, 20.0};

/// Whatever is done to the runs, all that a run's name stands on was made by the setup that the run has: the
/// setup is simulated here once more, by itself.
class WhoseDataTest : public testing::TestWithParam<unsigned> {
 protected:
  WhoseDataTest() {
    window.resize(1000, 700);
    window.show();
    open("part.nc", test::small_program);
    window.part<ContourView>().panel_actions()[0]->trigger();  // its panel comes up
  }

  void open(const std::string& name, const std::string& text) {
    const std::filesystem::path file = std::filesystem::path(folder.path().toStdString()) / name;
    std::ofstream(file) << text;
    model.open(file);
    wait_until_idle();
  }

  void wait_until_idle() {
    ASSERT_TRUE(QTest::qWaitFor([this] { return !model.busy() && !window.busy(); }, patience));
    QCoreApplication::processEvents();
  }

  RunList& runs() { return model.runs(); }
  std::size_t any_row() { return random() % runs().items().size(); }
  template <class Values>
  double any_of(const Values& values) {
    return values[random() % values.size()];
  }

  /// What a row must show, if anything.
  const feedscope::Run& expected(std::size_t row) {
    const feedscope::Setup setup = runs().items()[row].setup.setup();
    const std::string key =
        model.file().filename().string() +
        std::to_string(std::get<double>(setup.settings.values().at("contour_tolerance_mm"))) + "/" +
        std::to_string(axis_limit(setup.machine, 'X', "jerk"));
    const auto found = simulated.find(key);
    return found != simulated.end()
               ? found->second
               : simulated.emplace(key, simulate_run(load_program(model.file()), setup)).first->second;
  }
  bool is_of(std::size_t row, const std::shared_ptr<const Trajectory>& trajectory) {
    return trajectory == nullptr || trajectory->duration() == expected(row).trajectory->duration();
  }

  std::string act() {
    const std::size_t row = any_row();
    switch (random() % 18) {
      case 0:
      case 1:
        if (runs().items().size() < 5) {
          runs().duplicate(row);
        }
        return "duplicate";
      case 2:
        runs().remove(row);
        return "remove";
      case 3:
      case 4:
        runs().select(row);
        return "select";
      case 5:
      case 6:
        model.set_tolerance(any_of(tolerances));
        return "tolerance";
      case 7:
        model.setup().set("X.jerk", any_of(jerks));
        return "jerk";
      case 8:
        runs().history().undo();
        return "undo";
      case 9:
        runs().history().redo();
        return "redo";
      case 10:
      case 11:
        model.cancel();
        return "cancel";
      case 12:
        model.simulate_again(row);
        return "again";
      case 13:
        runs().set_visible(row, random() % 2 == 0);
        return "visible";
      case 14:
        runs().rename(row, random() % 2 == 0 ? QString() : QStringLiteral("run %1").arg(random() % 9));
        return "rename";
      case 15:
        runs().move(row, any_row());
        return "move";
      case 16:
        window.scenes().set_mode(static_cast<ScenesMode>(random() % 3));
        return "views";
      default:
        window.scene().scene().set_colouring(random() % 2 == 0 ? Colouring::time_lost : Colouring::feed);
        return "colours";
    }
  }

  void let_time_pass() {
    switch (random() % 4) {
      case 0:
        return;
      case 1:
        QCoreApplication::processEvents();
        return;
      case 2:
        QTest::qWait(static_cast<int>(random() % 20));
        return;
      default:
        wait_until_idle();
    }
  }

  void check() {
    const std::size_t current = runs().current();
    const auto shown = model.shown();
    const QString name = runs().title(runs().current_item());
    EXPECT_TRUE(is_of(current, shown == nullptr ? nullptr : shown->run.trajectory)) << "model";
    EXPECT_TRUE(is_of(current, model.cursor().trajectory())) << "cursor";
    EXPECT_TRUE(is_of(current, window.scene().scene().trajectory())) << "3D view";
    EXPECT_TRUE(is_of(current, window.scene().annotations().trajectory())) << "annotations";
    EXPECT_EQ(window.scene().annotations().run_name(), name);
    EXPECT_TRUE(is_of(current, window.part<ChartsPanel>().trajectory())) << "charts";
    if (const auto& why = window.part<WhyView>().shown()) {
      EXPECT_TRUE(is_of(current, why->run.trajectory)) << "why";
    }
    if (const auto* places = window.part<SlowPlacesView>().model().places()) {
      EXPECT_EQ(places, shown == nullptr ? nullptr : shown->slow_places.get()) << "slow places";
    }
    EXPECT_EQ(window.part<ProgramPanel>().view().times(), shown == nullptr ? nullptr : shown->line_times)
        << "program text";
    if (const ContourReport* report = window.part<ContourView>().places().report()) {
      EXPECT_EQ(report->largest, contour_report(expected(current), 1).largest) << "contour error";
    }
    check_others();
    check_table();
  }

  void check_others() {
    for (const RunOverlay& overlay : window.part<ChartsPanel>().overlays()) {
      EXPECT_TRUE(named(overlay.name, overlay.trajectory)) << "charts of " << overlay.name.toStdString();
    }
    for (const ContourCurve& curve : window.part<ContourView>().chart().curves().runs) {
      bool found = false;
      for (std::size_t row = 0; row < runs().items().size(); ++row) {
        found = found || (runs().lettered_title(row) == curve.name &&
                          contour_report(expected(row), 1).largest == curve.largest);
      }
      EXPECT_TRUE(found) << "histogram of " << curve.name.toStdString();
    }
    if (SceneView* second = window.scenes().second()) {
      const std::size_t row = runs().row_of(window.scenes().choice()->currentData().toInt());
      if (row < runs().items().size()) {
        EXPECT_TRUE(is_of(row, second->scene().trajectory())) << "second view";
        EXPECT_EQ(window.scenes().choice()->currentText(), runs().lettered_title(row));
      } else {
        EXPECT_EQ(second->scene().trajectory(), nullptr) << "second view of no run";
      }
    }
  }
  bool named(const QString& name, const std::shared_ptr<const Trajectory>& trajectory) {
    for (std::size_t row = 0; row < runs().items().size(); ++row) {
      if (runs().lettered_title(row) == name && is_of(row, trajectory)) {
        return true;
      }
    }
    return false;
  }

  void check_table() {
    const RunTable& table = window.part<RunsView>().results();
    for (std::size_t row = 0; row < runs().items().size(); ++row) {
      const QString text = table.index(static_cast<int>(row), RunTable::cycle_time).data().toString();
      const QString time = clock_text(expected(row).summary.cycle_time);
      switch (runs().status(row)) {
        case RunStatus::simulated:
          EXPECT_TRUE(text == time || text == "★ " + time) << text.toStdString();
          break;
        case RunStatus::waiting:
          EXPECT_EQ(text, "…");
          break;
        default:
          EXPECT_EQ(text, "cancelled");
      }
    }
    const bool offers = runs().status(runs().current()) == RunStatus::cancelled;
    RunNotice& notice = window.part<RunNotice>();
    EXPECT_EQ(!notice.isHidden() && !notice.again()->isHidden(), offers);
    EXPECT_EQ(window.part<RunsView>().again()->isEnabled(), offers);
  }

  void check_export() {
    const QString file = folder.filePath("charts.csv");
    QFile::remove(file);
    QSignalSpy written(&window.part<ChartsPanel>(), &ChartsPanel::exported);
    window.part<ChartsPanel>().range().fit();
    window.part<ChartsPanel>().commands().save_csv(file,
                                                   random() % 2 == 0 ? CsvRows::pixels : CsvRows::blocks);
    if (window.part<ChartsPanel>().trajectory() == nullptr) {
      EXPECT_FALSE(QFile::exists(file));
      return;
    }
    ASSERT_TRUE(written.count() > 0 || written.wait(patience));
    std::ifstream in(file.toStdString());
    std::string last;
    for (std::string line; std::getline(in, line);) {
      last = line;
    }
    EXPECT_NEAR(std::stod(last), expected(runs().current()).trajectory->duration(), 1e-6) << "export";
  }

  std::minstd_rand random{GetParam()};
  std::map<std::string, feedscope::Run> simulated;
  const QTemporaryDir folder;
  Workbench model{shipped_machines(), make_setup({})};
  MainWindow window{model, RenderBackend::software};
};

TEST_P(WhoseDataTest, NothingIsShownUnderTheNameOfARunThatDidNotMakeIt) {
  std::string done;
  for (int i = 0; i < actions && !HasFailure(); ++i) {
    done += act() + " ";
    check();
    let_time_pass();
    check();
    if (i % 25 == 0) {
      check_export();
    }
    if (i == actions / 2) {
      open("other.nc", "G21 G90 G94 F2000\nG1 X30\nG1 X30 Y30\nG1 X0 Y40\nM30\n");
    }
  }
  wait_until_idle();
  check();
  EXPECT_FALSE(HasFailure()) << "seed " << GetParam() << ", actions: " << done;
}

INSTANTIATE_TEST_SUITE_P(Seeds, WhoseDataTest, testing::Values(1U, 2U, 3U));

}  // namespace
}  // namespace feedscope::ui
