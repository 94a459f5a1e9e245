#include <gtest/gtest.h>

#include <QTest>
#include <QWheelEvent>
#include <algorithm>
#include <filesystem>
#include <vector>

#include "tests/support/folders.h"
#include "tests/support/memory.h"
#include "tests/support/random_cases.h"
#include "tests/support/sanitized.h"
#include "tests/ui/patience.h"
#include "tests/ui/run_fixture.h"
#include "ui/window/main_window.h"

namespace feedscope::ui {
namespace {

constexpr int clicks = 60;
constexpr int clicks_to_draw = 10;
constexpr std::size_t max_resident_bytes = 600 * test::megabyte;

/// Close up nearly all of the path and its axes is far outside of the view: what is not seen costs nothing.
class WindowZoomTest : public testing::Test {
 protected:
  WindowZoomTest() {
    window.resize(700, 550);
    window.show();
  }

  void open(const std::filesystem::path& file) {
    model.open(file);
    ASSERT_TRUE(QTest::qWaitFor([this] { return !model.busy() && !window.busy(); }, patience));
    QCoreApplication::processEvents();
  }

  /// Turns the wheel over a place of the path, nearer and nearer.
  void turn_wheel() {
    QWidget& canvas = window.scene().canvas();
    for (int i = 0; i < clicks; ++i) {
      const QPointF place(0.4 * canvas.width(), 0.6 * canvas.height());
      QWheelEvent event(place, canvas.mapToGlobal(place), {}, {0, 120}, Qt::NoButton, Qt::NoModifier,
                        Qt::NoScrollPhase, false);
      QApplication::sendEvent(&canvas, &event);
      QCoreApplication::processEvents();
      if (window.scenes().second() != nullptr) {  // follows with the next turn of the event loop
        QCoreApplication::processEvents();
        QCoreApplication::processEvents();
      }
      if (i % clicks_to_draw == clicks_to_draw - 1) {
        window.scenes().rest();  // a view that rests shows every detail
        window.scene().grab();
        if (SceneView* second = window.scenes().second()) {
          second->grab();
        }
      }
    }
  }

  Workbench model{shipped_machines(), make_setup({})};
  MainWindow window{model, RenderBackend::software};
};

TEST_F(WindowZoomTest, SixtyClicksIntoAnySampleStaySmallInOneAndTwoViews) {
  std::vector<std::filesystem::path> programs;
  for (const auto& entry : std::filesystem::directory_iterator(FEEDSCOPE_SOURCE_DIR "/resources/programs")) {
    if (entry.path().extension() != ".md") {
      programs.push_back(entry.path());
    }
  }
  std::ranges::sort(programs);
  ASSERT_GT(programs.size(), 20U);
  model.runs().duplicate(0);
  const bool all = test::thorough();
  // Else every fourth program, one and two views in turns.
  for (std::size_t i = 0; i < programs.size(); i += all ? 1 : 4) {
    SCOPED_TRACE(programs[i].filename().string());
    ASSERT_NO_FATAL_FAILURE(open(programs[i]));
    ASSERT_NE(model.shown(), nullptr);
    for (const ScenesMode mode : {ScenesMode::one, ScenesMode::side_by_side}) {
      if (!all && (mode == ScenesMode::one) != (i % 8 == 0)) {
        continue;
      }
      window.scenes().set_mode(mode);
      window.scene().scene().fit();
      turn_wheel();
      EXPECT_TRUE(test::sanitized || test::resident_bytes() < max_resident_bytes);
    }
  }
}

}  // namespace
}  // namespace feedscope::ui
