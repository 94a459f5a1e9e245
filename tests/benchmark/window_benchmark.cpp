#include <benchmark/benchmark.h>

#include <QApplication>
#include <QLocale>
#include <QTemporaryDir>
#include <filesystem>
#include <fstream>

#include "tests/benchmark/programs.h"
#include "ui/main_window.h"
#include "ui/theme/theme.h"

namespace feedscope::benchmark {
namespace {

using State = ::benchmark::State;

/// The window at its default size on a program of so many short lines.
class Window {
 public:
  explicit Window(std::size_t blocks)
      : file_(std::filesystem::path(folder_.path().toStdString()) / "surface.nc") {
    std::ofstream(file_) << surface_program(blocks);
    window_.setAttribute(Qt::WA_DontShowOnScreen);
    window_.show();
    QApplication::processEvents();
  }

  void open() { model_.open(file_); }
  bool has_program() const { return model_.program() != nullptr; }
  ui::Workbench& model() { return model_; }

  template <typename Condition>
  void wait_until(Condition condition) {
    while (!condition()) {
      QApplication::processEvents(QEventLoop::WaitForMoreEvents);
    }
    window_.charts().refresh();
    window_.grab();  // all of it is drawn
  }

 private:
  QTemporaryDir folder_;
  std::filesystem::path file_;
  ui::Workbench model_{shipped_machines(), make_setup({})};
  ui::MainWindow window_{model_, ui::RenderBackend::software};
};

/// From the wish to open a program to the picture of its programmed path, and `whole` of its run.
void open_program(State& state, bool whole) {
  for (auto _ : state) {
    state.PauseTiming();
    {
      Window window(static_cast<std::size_t>(state.range(0)));
      state.ResumeTiming();
      window.open();
      window.wait_until([&] { return whole ? window.model().shown() != nullptr : window.has_program(); });
      state.PauseTiming();
      window.model().cancel();
    }
    state.ResumeTiming();
  }
}

/// From another value of the machine to the pictures of the run that follows from it.
void edit(State& state) {
  Window window(static_cast<std::size_t>(state.range(0)));
  window.open();
  window.wait_until([&] { return window.model().shown() != nullptr && !window.model().busy(); });
  double jerk = 10;
  for (auto _ : state) {
    jerk = jerk > 15 ? 10 : jerk + 1;
    window.model().setup().set("X.jerk", jerk);
    window.wait_until([&] { return !window.model().busy(); });
  }
}

BENCHMARK_CAPTURE(open_program, to_first_picture, false)
    ->ArgName("blocks")
    ->Arg(1000)
    ->Arg(1000000)
    ->MeasureProcessCPUTime()
    ->UseRealTime()
    ->Unit(::benchmark::kMillisecond);
BENCHMARK_CAPTURE(open_program, to_simulated, true)
    ->ArgName("blocks")
    ->Arg(1000)
    ->Arg(1000000)
    ->MeasureProcessCPUTime()
    ->UseRealTime()
    ->Unit(::benchmark::kMillisecond);
BENCHMARK(edit)->ArgName("blocks")->Arg(1000)->Arg(10000)->MeasureProcessCPUTime()->UseRealTime()->Unit(
    ::benchmark::kMillisecond);

}  // namespace
}  // namespace feedscope::benchmark

int main(int argc, char** argv) {
  qputenv("QT_QPA_PLATFORM", "offscreen");
  QLocale::setDefault(QLocale::c());
  const QApplication application(argc, argv);
  feedscope::ui::apply_theme();
  ::benchmark::Initialize(&argc, argv);
  ::benchmark::RunSpecifiedBenchmarks();
  return 0;
}
