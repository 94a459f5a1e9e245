#include "ui/models/shown_run.h"

#include <future>

namespace feedscope::ui {

namespace {

constexpr std::size_t slow_places_kept = 10'000;

}  // namespace

std::shared_ptr<const ShownRun> make_shown(Run run, Progress* progress) {
  auto shown = std::make_shared<ShownRun>();
  shown->run = std::move(run);
  // What takes longest goes beside the rest.
  std::future<SampledPath> samples = std::async(
      std::launch::async, [&trajectory = *shown->run.trajectory] { return sample_executed(trajectory); });
  shown->envelope = std::make_shared<const Envelope>(shown->run.trajectory, progress);
  shown->line_times = std::make_shared<const LineTimes>(*shown->run.trajectory, progress);
  shown->slow_places = std::make_shared<const SlowPlaces>(
      find_slow_places(*shown->run.trajectory, slow_places_kept, progress));
  shown->samples = std::make_shared<const SampledPath>(samples.get());
  return shown;
}

ShownProgram make_shown(LoadedProgram input) {
  auto samples = std::make_shared<const SampledPath>(sample_programmed(*input.toolpath));
  return {std::move(input), std::move(samples)};
}

}  // namespace feedscope::ui
