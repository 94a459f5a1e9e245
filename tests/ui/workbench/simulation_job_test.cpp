#include "ui/workbench/simulation_job.h"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>

#include "tests/ui/patience.h"

namespace feedscope::ui {
namespace {

/// Rows of a wavy surface in lines of 0.2 mm, which no model simulates within a second.
LoadedProgram long_surface() {
  std::string text = "G21 G90 G94 G1 F6000\n";
  constexpr int lines = 200000;
  constexpr int row = 500;
  for (int i = 0; i < lines; ++i) {
    const double x = 0.2 * (i / row % 2 == 0 ? i % row : row - 1 - i % row);
    const double z = 8 * std::sin(x / 13) + 0.3 * std::sin(x / 1.7);
    text +=
        "X" + std::to_string(x) + " Y" + std::to_string(0.2 * (i / row)) + " Z" + std::to_string(z) + "\n";
  }
  return load_program(std::make_shared<const SourceText>("surface.nc", text));
}

/// What Cancel of the window asks for while a model simulates.
class CancelledSimulation : public testing::TestWithParam<const ControlModel*> {
 protected:
  static const LoadedProgram& program() {
    static const LoadedProgram surface = long_surface();
    return surface;
  }

  /// How long a simulation goes on that is cancelled after `run_ms`: seconds of the clock or of the
  /// processor, whichever are fewer, as the machine may be busy.
  static double seconds_to_end(int run_ms) {
    SetupRequest request;
    request.model = GetParam()->info().id;
    SimulationJob job;
    job.start({program(), make_setup(request)});
    QTest::qWait(run_ms);
    QSignalSpy ended(&job, &SimulationJob::busy_changed);
    const auto from = std::chrono::steady_clock::now();
    const std::clock_t processor = std::clock();
    job.cancel();
    EXPECT_TRUE(!job.busy() || ended.wait(patience));
    const std::chrono::duration<double> clock = std::chrono::steady_clock::now() - from;
    return std::min(clock.count(), static_cast<double>(std::clock() - processor) / CLOCKS_PER_SEC);
  }
};

/// A second is what people wait for on an idle machine; a loop that does not look takes longer than this.
TEST_P(CancelledSimulation, EndsSoon) {
  for (const int run_ms : {1, 50, 400}) {
    EXPECT_LT(seconds_to_end(run_ms), 3) << "cancelled after " << run_ms << " ms";
  }
}

INSTANTIATE_TEST_SUITE_P(EveryModel, CancelledSimulation, testing::ValuesIn(all_models()),
                         [](const auto& model) { return model.param->info().id; });

}  // namespace
}  // namespace feedscope::ui
