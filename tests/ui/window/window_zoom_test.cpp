#include <gtest/gtest.h>

#include <QTest>
#include <QWheelEvent>
#include <algorithm>
#include <ctime>
#include <filesystem>
#include <vector>

#include "tests/support/folders.h"
#include "tests/support/memory.h"
#include "tests/support/sanitized.h"
#include "tests/ui/patience.h"
#include "tests/ui/run_fixture.h"
#include "ui/window/main_window.h"

namespace feedscope::ui {
namespace {

constexpr int clicks = 60;
constexpr int clicks_to_rest = 5;
constexpr double max_seconds = 1;  // of processor time until the view shows what a click asked for
constexpr std::size_t max_bytes = 600 * test::megabyte;

double processor_seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// Close up nearly all of the path and its axes is far outside of the view: what is not seen costs nothing.
class WindowZoomTest : public testing::Test {
 protected:
  WindowZoomTest() {
    window.resize(900, 700);
    window.show();
  }

  void open(const std::filesystem::path& file) {
    model.open(file);
    ASSERT_TRUE(QTest::qWaitFor([this] { return !model.busy() && !window.busy(); }, patience));
    QCoreApplication::processEvents();
  }

  /// Turns the wheel over a place of the path, `way` 1: nearer, -1: farther. The longest click [s].
  double turn_wheel(int way) {
    QWidget& canvas = window.scene().canvas();
    double longest = 0;
    for (int i = 0; i < clicks; ++i) {
      const QPointF place(0.4 * canvas.width(), 0.6 * canvas.height());
      QWheelEvent event(place, canvas.mapToGlobal(place), {}, {0, 120 * way}, Qt::NoButton, Qt::NoModifier,
                        Qt::NoScrollPhase, false);
      const double before = processor_seconds();
      QApplication::sendEvent(&canvas, &event);
      for (int turn = 0; turn < 3; ++turn) {  // the second view follows with the next turn of the event loop
        QCoreApplication::processEvents();
      }
      if (i % clicks_to_rest == clicks_to_rest - 1) {  // a view that rests shows every detail
        window.scenes().rest();
      }
      window.scene().grab();
      if (SceneView* second = window.scenes().second()) {
        second->grab();
      }
      longest = std::max(longest, processor_seconds() - before);
    }
    return longest;
  }

  Workbench model{shipped_machines(), make_setup({})};
  MainWindow window{model, RenderBackend::software};
};

TEST_F(WindowZoomTest, SixtyClicksIntoAnySampleAreQuickAndSmallInOneAndTwoViews) {
  std::vector<std::filesystem::path> programs;
  for (const auto& entry : std::filesystem::directory_iterator(FEEDSCOPE_SOURCE_DIR "/resources/programs")) {
    if (entry.path().extension() != ".md") {
      programs.push_back(entry.path());
    }
  }
  std::ranges::sort(programs);
  ASSERT_GT(programs.size(), 20U);
  model.runs().duplicate(0);
  double longest = 0;
  std::size_t largest = 0;
  for (const std::filesystem::path& program : programs) {
    SCOPED_TRACE(program.filename().string());
    ASSERT_NO_FATAL_FAILURE(open(program));
    ASSERT_NE(model.shown(), nullptr);
    for (const ScenesMode mode : {ScenesMode::one, ScenesMode::side_by_side}) {
      window.scenes().set_mode(mode);
      for (const int way : {1, -1}) {
        const double seconds = turn_wheel(way);
        EXPECT_TRUE(test::sanitized || seconds < max_seconds) << seconds;
        EXPECT_TRUE(test::sanitized || test::resident_bytes() < max_bytes);
        longest = std::max(longest, seconds);
        largest = std::max(largest, test::resident_bytes());
      }
    }
  }
  RecordProperty("longest_click_ms", static_cast<int>(1000 * longest));
  RecordProperty("largest_mb", static_cast<int>(largest / test::megabyte));
}

}  // namespace
}  // namespace feedscope::ui
