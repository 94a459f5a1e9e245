#include <gtest/gtest.h>

#include <QTemporaryDir>
#include <QTest>
#include <QThreadPool>
#include <cmath>
#include <fstream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/memory.h"
#include "tests/support/sanitized.h"
#include "tests/ui/patience.h"
#include "tests/ui/run_fixture.h"
#include "ui/contour/contour_view.h"
#include "ui/window/main_window.h"

namespace feedscope::ui {
namespace {

using test::bytes_in_use;
using test::megabyte;

/// A spiral of short blocks and rapids, of about `bytes`.
std::string spiral(std::size_t bytes) {
  std::string text = "G21 G90 G94 F3000\n";
  char line[64];
  for (int i = 0; text.size() < bytes; ++i) {
    const double angle = 0.05 * i;
    std::snprintf(line, sizeof line, "G1 X%.3f Y%.3f\n", 0.01 * i * std::cos(angle),
                  0.01 * i * std::sin(angle));
    text += line;
  }
  return text + "M30\n";
}

/// Notices which of the large parts of a run and its program are still there when nothing should have them.
class Kept {
 public:
  void watch(const std::string& name, const std::shared_ptr<const void>& part) {
    parts_.push_back({name, part});
  }
  void watch(const Workbench& model) {
    const std::string run = "run " + std::to_string(++runs_) + ": ";
    const auto shown = model.shown();
    watch(run + "all", shown);
    watch(run + "motion", shown->run.trajectory);
    watch(run + "charts", shown->envelope);
    watch(run + "3D view", shown->samples);
    watch(run + "times of lines", shown->line_times);
    watch(run + "slow places", shown->slow_places);
    watch("program", model.program());
    watch("toolpath", model.shown_program().input.toolpath);
    watch("3D view of the program", model.shown_program().samples);
  }
  std::string text() const {
    std::string text;
    for (const auto& [name, part] : parts_) {
      text += part.expired() ? "" : name + "\n";
    }
    return text;
  }

 private:
  std::vector<std::pair<std::string, std::weak_ptr<const void>>> parts_;
  int runs_ = 0;
};

class WindowMemoryTest : public testing::Test {
 protected:
  WindowMemoryTest() {
    window.resize(700, 500);
    window.show();
  }
  void SetUp() override {
    if (test::sanitized) {
      GTEST_SKIP() << "a sanitizer keeps memory of its own";
    }
  }

  void open(const std::string& name, const std::string& text) {
    const std::filesystem::path file = std::filesystem::path(folder.path().toStdString()) / name;
    std::ofstream(file) << text;
    model.open(file);
    wait_until_idle();
  }
  void wait_until_idle() {
    ASSERT_TRUE(QTest::qWaitFor([this] { return !model.busy() && !window.busy(); }, patience));
    for (int i = 0; i < 5; ++i) {
      QCoreApplication::processEvents();
    }
    window.scene().grab();  // the buffers of the 3D view are made with the next frame
  }

  /// Three runs of a large program, time lost and contour errors, then a small program.
  void work_on_large_program() {
    ASSERT_NO_FATAL_FAILURE(open("large.nc", spiral(350'000)));
    one_run = bytes_in_use();
    kept = Kept();
    kept.watch(model);
    for (const double tolerance : {0.02, 0.05}) {
      model.runs().duplicate(model.runs().current());
      model.set_tolerance(tolerance);
      ASSERT_NO_FATAL_FAILURE(wait_until_idle());
      kept.watch(model);
    }
    window.scene().scene().set_colouring(Colouring::time_lost);
    ASSERT_NO_FATAL_FAILURE(wait_until_idle());
    if (!window.part<ContourView>().isVisible()) {
      window.part<ContourView>().panel_actions()[0]->trigger();  // its panel comes up
    }
    ASSERT_TRUE(QTest::qWaitFor([this] { return !window.part<ContourView>().busy(); }, patience));
    while (model.runs().items().size() > 1) {
      model.runs().remove(0);
    }
    ASSERT_NO_FATAL_FAILURE(open("small.nc", test::small_program));
    QThreadPool::globalInstance()->waitForDone(
        patience);  // a comparison that was cancelled still holds its runs
  }

  Kept kept;
  std::size_t one_run = 0;  ///< bytes in use with one run of the large program
  const QTemporaryDir folder;
  Workbench model{shipped_machines(), make_setup({})};
  MainWindow window{model, RenderBackend::software};
};

TEST_F(WindowMemoryTest, TwentyOpeningsOfAProgramLeaveNothing) {
  const std::string text = spiral(100'000);
  constexpr int openings = 20;
  constexpr int settled = 5;
  std::size_t before = 0;
  for (int i = 0; i < openings; ++i) {
    ASSERT_NO_FATAL_FAILURE(open("spiral.nc", text));
    ASSERT_NE(model.shown(), nullptr);
    if (i == settled) {
      before = bytes_in_use();
    }
  }
  const std::size_t after = bytes_in_use();
  EXPECT_LT(after, before + 10 * megabyte) << "from " << before / megabyte << " MB to " << after / megabyte;
}

TEST_F(WindowMemoryTest, AProgramThatIsReplacedGivesItsMemoryBack) {
  ASSERT_NO_FATAL_FAILURE(open("small.nc", test::small_program));
  // What stays for good comes with the first round: fonts, pictures of the window, and what the software
  // renderer keeps of the largest frame, up to 36 MB.
  ASSERT_NO_FATAL_FAILURE(work_on_large_program());
  const std::size_t small = bytes_in_use();
  ASSERT_NO_FATAL_FAILURE(work_on_large_program());
  EXPECT_GT(one_run, small + 10 * megabyte) << "there is something to give back";
  EXPECT_EQ(kept.text(), "") << "still there";
  const std::size_t after = bytes_in_use();
  EXPECT_LT(after, small + 5 * megabyte) << "from " << small / megabyte << " MB with one run to "
                                         << one_run / megabyte << " and back to " << after / megabyte;
}

}  // namespace
}  // namespace feedscope::ui
