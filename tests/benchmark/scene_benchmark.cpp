#include <benchmark/benchmark.h>
#include <vtkGenericOpenGLRenderWindow.h>

#include <memory>

#include "tests/benchmark/programs.h"
#include "tests/ui/run_fixture.h"
#include "ui/scene/path_scene.h"
#include "ui/scene/render_window.h"

namespace feedscope::benchmark {
namespace {

using State = ::benchmark::State;

constexpr int width = 940;
constexpr int height = 560;

/// A run of so many short lines, made once.
const Run& run_of(std::size_t blocks) {
  static std::size_t made = 0;
  static Run run;
  if (made != blocks) {
    run = test::simulate_text(surface_program(blocks));
    made = blocks;
  }
  return run;
}

struct Window {
  explicit Window(const Run& run) {
    window->SetSize(width, height);
    scene.attach(*window);
    scene.set_programmed(run.path.toolpath);
    scene.set_executed(run.trajectory);
    scene.set_standard_view(ui::StandardView::iso);
    window->Render();
  }
  vtkSmartPointer<vtkGenericOpenGLRenderWindow> window = ui::make_render_window(ui::RenderBackend::software);
  ui::PathScene scene;
};

void sample(State& state) {
  const Run& run = run_of(static_cast<std::size_t>(state.range(0)));
  for (auto _ : state) {
    const ui::SampledPath path = ui::sample_executed(run.trajectory);
    state.counters["points"] = static_cast<double>(path.size());
  }
}

/// One frame of a drag that turns the view, in software. Arguments: blocks; whether coarse levels are used.
void orbit_frame(State& state) {
  Window shown(run_of(static_cast<std::size_t>(state.range(0))));
  shown.scene.set_moving(state.range(1) != 0);
  shown.window->Render();
  for (auto _ : state) {
    shown.scene.orbit({3, 1});
    shown.window->Render();
  }
}

void colour_switch(State& state) {
  Window shown(run_of(static_cast<std::size_t>(state.range(0))));
  bool jerk = false;
  for (auto _ : state) {
    jerk = !jerk;
    shown.scene.set_colouring(jerk ? ui::Colouring::jerk : ui::Colouring::cause);
  }
}

void hover(State& state) {
  Window shown(run_of(static_cast<std::size_t>(state.range(0))));
  double x = 0;
  for (auto _ : state) {
    x = x > width - 200 ? 100 : x + 7;
    ::benchmark::DoNotOptimize(shown.scene.pick_time({x, height / 2.0}));
  }
}

BENCHMARK(sample)->ArgName("blocks")->Arg(1000)->Arg(1'000'000)->Unit(::benchmark::kMillisecond);
BENCHMARK(orbit_frame)
    ->ArgNames({"blocks", "coarse"})
    ->ArgsProduct({{1, 10, 100, 1000, 67000, 1000000}, {0, 1}})
    ->MeasureProcessCPUTime()
    ->Unit(::benchmark::kMillisecond);
BENCHMARK(colour_switch)->ArgName("blocks")->Arg(1000)->Arg(1'000'000)->Unit(::benchmark::kMillisecond);
BENCHMARK(hover)->ArgName("blocks")->Arg(1000)->Arg(1'000'000)->Unit(::benchmark::kMillisecond);

}  // namespace
}  // namespace feedscope::benchmark

BENCHMARK_MAIN();
