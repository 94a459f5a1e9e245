#include <benchmark/benchmark.h>

#include <QApplication>
#include <QLocale>
#include <QTemporaryDir>
#include <QWheelEvent>
#include <filesystem>
#include <fstream>

#include "tests/benchmark/programs.h"
#include "ui/charts/charts_panel.h"
#include "ui/theme/theme.h"
#include "ui/window/main_window.h"

namespace feedscope::benchmark {
namespace {

using State = ::benchmark::State;

/// A window of 1920x1080 on a program of so many short lines.
class Window {
 public:
  explicit Window(std::size_t blocks)
      : file_(std::filesystem::path(folder_.path().toStdString()) / "surface.nc") {
    std::ofstream(file_) << surface_program(blocks);
    window_.setAttribute(Qt::WA_DontShowOnScreen);
    window_.resize(1920, 1080);
    window_.show();
    QApplication::processEvents();
  }

  void open() { model_.open(file_); }
  bool has_program() const { return model_.program() != nullptr; }
  ui::Workbench& model() { return model_; }
  ui::MainWindow& window() { return window_; }
  /// Nothing is simulated or compared for the pictures; what would help may still be tried, after a pause.
  bool idle() { return !model_.busy() && !window_.scenes().comparison().busy(); }

  template <typename Condition>
  void wait_until(Condition condition) {
    while (!condition()) {
      QApplication::processEvents(QEventLoop::WaitForMoreEvents);
    }
    window_.part<ui::ChartsPanel>().refresh();
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

/// From another value of the machine to the pictures of the run that follows from it, or until `whole` of it
/// is known.
void edit(State& state, bool whole) {
  Window window(static_cast<std::size_t>(state.range(0)));
  window.open();
  window.wait_until([&] { return window.model().shown() != nullptr && !window.model().busy(); });
  double jerk = 10;
  for (auto _ : state) {
    jerk = jerk > 15 ? 10 : jerk + 1;
    window.model().setup().set("X.jerk", jerk);
    window.wait_until([&] { return whole ? !window.model().busy() : window.model().drawn() != nullptr; });
    state.PauseTiming();
    window.wait_until([&] { return !window.model().busy(); });
    state.ResumeTiming();
  }
}

/// A window with runs of two tolerances, both simulated and drawn.
struct WindowWithRuns : Window {
  explicit WindowWithRuns(const State& state) : Window(static_cast<std::size_t>(state.range(0))) {
    open();
    wait_until([&] { return model().shown() != nullptr && idle(); });
    model().runs().duplicate(0);
    model().set_tolerance(0.05);
    wait_until([&] { return !model().busy() && !window().busy(); });
  }
};

/// From the choice of another run to its pictures.
void switch_run(State& state) {
  WindowWithRuns shown(state);
  std::size_t row = shown.model().runs().current();
  for (auto _ : state) {
    row = 1 - row;
    shown.model().runs().select(row);
    shown.wait_until([&] { return shown.idle(); });
  }
}

/// From the wish to see time lost against the other run to its colours, and back to the feed.
void time_lost(State& state) {
  WindowWithRuns shown(state);
  bool lost = false;
  for (auto _ : state) {
    lost = !lost;
    ui::SceneState look = shown.window().scene().state();
    look.colouring = lost ? ui::Colouring::time_lost : ui::Colouring::feed;
    shown.window().scene().set_state(look);
    shown.wait_until([&] { return shown.idle(); });
  }
}

/// From one view to two, and back.
void side_by_side(State& state) {
  WindowWithRuns shown(state);
  bool both = false;
  for (auto _ : state) {
    both = !both;
    shown.window().scenes().set_mode(both ? ui::ScenesMode::side_by_side : ui::ScenesMode::one);
    shown.wait_until([&] { return shown.idle(); });
  }
}

/// One click of the wheel over the middle of `widget`, nearer and farther in turn, drawn at once.
void turn_wheel(State& state, WindowWithRuns& shown, QWidget& widget, QWidget& drawn) {
  int way = 1;
  int left = 20;
  for (auto _ : state) {
    const QPointF place = widget.rect().center();
    QWheelEvent event(place, widget.mapToGlobal(place), {}, {0, 120 * way}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(&widget, &event);
    QApplication::processEvents();
    shown.window().part<ui::ChartsPanel>().refresh();
    drawn.grab();
    if (--left == 0) {
      left = 20;
      way = -way;
    }
  }
}

void wheel_over_chart(State& state) {
  WindowWithRuns shown(state);
  turn_wheel(state, shown, shown.window().part<ui::ChartsPanel>().chart(0),
             shown.window().part<ui::ChartsPanel>());
}

void wheel_over_scene(State& state) {
  WindowWithRuns shown(state);
  turn_wheel(state, shown, shown.window().scene().canvas(), shown.window().scene());
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
void on_edits(::benchmark::internal::Benchmark* benchmark) {
  benchmark->ArgName("blocks")
      ->Arg(1000)
      ->Arg(10000)
      ->Arg(67000)
      ->MeasureProcessCPUTime()
      ->UseRealTime()
      ->Unit(::benchmark::kMillisecond);
}
BENCHMARK_CAPTURE(edit, to_pictures, false)->Apply(on_edits);
BENCHMARK_CAPTURE(edit, to_all, true)->Apply(on_edits);

void on_two_programs(::benchmark::internal::Benchmark* benchmark) {
  benchmark->ArgName("blocks")->Arg(1000)->Arg(67000)->MeasureProcessCPUTime()->UseRealTime()->Unit(
      ::benchmark::kMillisecond);
}
BENCHMARK(switch_run)->Apply(on_two_programs);
BENCHMARK(time_lost)->Apply(on_two_programs);
BENCHMARK(side_by_side)->Apply(on_two_programs);
BENCHMARK(wheel_over_chart)->Apply(on_two_programs);
BENCHMARK(wheel_over_scene)->Apply(on_two_programs);

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
