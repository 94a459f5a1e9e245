#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <string>

#include "core/analysis/run/run.h"
#include "core/drives/drive_response.h"
#include "tests/benchmark/heap_meter.h"
#include "tests/benchmark/programs.h"
#include "tests/support/folders.h"

namespace feedscope::benchmark {
namespace {

using State = ::benchmark::State;
using ::benchmark::Counter;

struct Kind {
  const char* name;
  std::string (*text)(std::size_t blocks);
};
constexpr std::array<Kind, 2> kinds{Kind{"lines", surface_program}, Kind{"arcs", arc_program}};

void set_counters(State& state, std::size_t blocks, const HeapMeter& meter) {
  state.SetItemsProcessed(static_cast<std::int64_t>(blocks * state.iterations()));
  const auto count = static_cast<double>(blocks);
  state.counters["peak_bytes_a_block"] = static_cast<double>(meter.peak()) / count;
  state.counters["held_bytes_a_block"] = static_cast<double>(meter.held()) / count;
}

/// Text to toolpath. Memory: the text and the program with its toolpath.
void read(State& state, const Kind& kind) {
  const auto blocks = static_cast<std::size_t>(state.range(0));
  const HeapMeter meter;
  const auto source = std::make_shared<const SourceText>("benchmark.nc", kind.text(blocks));
  LoadedProgram program;
  for (auto _ : state) {
    program = {};
    program = load_program(source);
  }
  state.SetBytesProcessed(static_cast<std::int64_t>(source->text().size() * state.iterations()));
  set_counters(state, blocks, meter);
}

/// Toolpath to trajectory. Memory: text, program, toolpath and trajectory, all that a run holds.
void simulate(State& state, const Kind& kind, const ControlModel& model, bool compressed) {
  const auto blocks = static_cast<std::size_t>(state.range(0));
  const Machine machine =
      MachineLibrary(FEEDSCOPE_SOURCE_DIR "/machines", all_model_settings()).load("spinner-mvc850");
  Settings settings = complete_settings(model, machine);
  if (compressed) {
    settings.set("compressor", std::string("on"));
  }
  const HeapMeter meter;
  const LoadedProgram program =
      load_program(std::make_shared<const SourceText>("benchmark.nc", kind.text(blocks)));
  Trajectory trajectory;
  for (auto _ : state) {
    trajectory = {};
    trajectory = model.simulate(program.toolpath, machine, settings);
  }
  set_counters(state, blocks, meter);
}

/// Trajectory to the answer of the drives, by pieces of the trajectory and by polynomials of the set path, of
/// which a piece may hold several.
void respond(State& state, const Kind& kind, const ControlModel& model) {
  Machine machine =
      MachineLibrary(FEEDSCOPE_SOURCE_DIR "/machines", all_model_settings()).load("spinner-mvc850");
  for (const AxisInfo& axis : known_axes) {
    set_axis_value(machine, axis.name, "kv", 60.0);
    set_axis_value(machine, axis.name, "velocity_feedforward", 0.9);
    set_axis_value(machine, axis.name, "velocity_lag", 6.0);
  }
  const LoadedProgram program = load_program(std::make_shared<const SourceText>(
      "benchmark.nc", kind.text(static_cast<std::size_t>(state.range(0)))));
  const auto trajectory = std::make_shared<const Trajectory>(
      model.simulate(program.toolpath, machine, complete_settings(model, machine)));
  const HeapMeter meter;
  for (auto _ : state) {
    const DriveResponse response(trajectory, machine);
    ::benchmark::DoNotOptimize(&response);
  }
  set_counters(state, trajectory->pieces().size(), meter);
  std::size_t spans = 0;
  for (SetWalk walk(*trajectory); !walk.done(); walk.next()) {
    ++spans;
  }
  state.counters["polynomials_per_second"] =
      Counter(static_cast<double>(spans), Counter::kIsIterationInvariantRate);
}

void register_all() {
  const auto sizes = [](::benchmark::internal::Benchmark* b) {
    b->RangeMultiplier(10)->Range(1'000, 1'000'000)->Unit(::benchmark::kMillisecond);
  };
  for (const Kind& kind : kinds) {
    sizes(::benchmark::RegisterBenchmark(fmt::format("read/{}", kind.name).c_str(), read, kind));
    for (const ControlModel* model : all_models()) {
      const std::string name = fmt::format("simulate/{}/{}", model->info().id, kind.name);
      for (const bool compressed : {false, true}) {
        const auto& specs = model->info().settings;
        const bool has_compressor = std::any_of(specs.begin(), specs.end(),
                                                [](const auto& spec) { return spec.key == "compressor"; });
        if (!compressed || has_compressor) {
          sizes(::benchmark::RegisterBenchmark(
              (name + (compressed ? "/compressor" : "")).c_str(),
              [&kind, model, compressed](State& state) { simulate(state, kind, *model, compressed); }));
        }
      }
      const std::string drives = fmt::format("drives/{}/{}", model->info().id, kind.name);
      sizes(::benchmark::RegisterBenchmark(drives.c_str(),
                                           [&kind, model](State& state) { respond(state, kind, *model); }));
    }
  }
}

}  // namespace
}  // namespace feedscope::benchmark

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) {
    return 2;
  }
  feedscope::benchmark::register_all();
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
