#include "ui/models/shown_run.h"

namespace feedscope::ui {

namespace {

constexpr std::size_t slow_places_kept = 10'000;

}  // namespace

std::shared_ptr<const ShownRun> make_shown(Run run, Progress* progress) {
  auto shown = std::make_shared<ShownRun>();
  shown->run = std::move(run);
  shown->envelope = std::make_shared<const Envelope>(shown->run.trajectory, progress);
  shown->samples = std::make_shared<const SampledPath>(sample_executed(*shown->run.trajectory));
  shown->line_times = std::make_shared<const LineTimes>(*shown->run.trajectory, progress);
  shown->slow_places = std::make_shared<const SlowPlaces>(
      find_slow_places(*shown->run.trajectory, slow_places_kept, progress));
  return shown;
}

ShownProgram make_shown(LoadedProgram input) {
  auto samples = std::make_shared<const SampledPath>(sample_programmed(*input.toolpath));
  return {std::move(input), std::move(samples)};
}

}  // namespace feedscope::ui
