#include <algorithm>

#include "core/analysis/difference/run_difference.h"
#include "core/trajectory/part_walk.h"
#include "ui/scene/path/compare_sampled.h"

namespace feedscope::ui {
namespace {

constexpr std::size_t close_enough = 100'000;  // points of one path

bool are_close(std::span<const double> reference_times) {
  return reference_times.size() > close_enough;
}

/// `path` with its differences from the reference at its points.
SampledPath with_differences(SampledPath path, const Trajectory& trajectory, const Trajectory& reference,
                             Progress& progress) {
  const RunDifference difference = compare_places(trajectory, reference, path.times, &progress);
  const auto store = [](std::vector<Stored>& to, const std::vector<float>& from) {
    to.reserve(from.size());
    std::ranges::transform(from, std::back_inserter(to), [](float value) { return Stored(value); });
  };
  store(path.values[sample_index(Colouring::time_lost)], difference.pace);
  store(path.values[sample_index(Colouring::path_distance)], difference.distance);
  path.lost.reserve(difference.lost.size());
  std::ranges::transform(difference.lost, std::back_inserter(path.lost),
                         [](double lost) { return static_cast<float>(lost); });
  for (PartWalk walk(reference); !walk.done(); walk.next()) {
    path.reference_cause_times[static_cast<std::size_t>(walk.part().cause.kind)] += walk.part().duration;
  }
  return path;
}

}  // namespace

SampledPath sample_compared(const std::shared_ptr<const Trajectory>& trajectory, const Trajectory& reference,
                            std::span<const double> reference_times, Progress* progress,
                            const RunSources& sources) {
  Progress unwatched;
  Progress& whole = progress != nullptr ? *progress : unwatched;
  Progress sampling(whole, 0.5);
  Progress comparing(whole, 0.5);
  const std::vector<double> places = are_close(reference_times)
                                         ? std::vector<double>()
                                         : times_at_places(reference, *trajectory, reference_times);
  return with_differences(sample_executed(trajectory, default_max_points, places, &sampling, sources),
                          *trajectory, reference, comparing);
}

SampledPath compare_sampled(const SampledPath& sampled, const std::shared_ptr<const Trajectory>& trajectory,
                            const Trajectory& reference, std::span<const double> reference_times,
                            Progress* progress, const RunSources& sources) {
  if (!are_close(reference_times)) {
    return sample_compared(trajectory, reference, reference_times, progress, sources);
  }
  Progress unwatched;
  return with_differences(sampled, *trajectory, reference, progress != nullptr ? *progress : unwatched);
}

}  // namespace feedscope::ui
