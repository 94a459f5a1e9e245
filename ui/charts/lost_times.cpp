#include "ui/charts/lost_times.h"

#include <utility>

#include "core/analysis/difference/run_difference.h"

namespace feedscope::ui {

LostTimes lost_times(const Trajectory& run, const std::vector<RunOverlay>& others, LostTimes at,
                     Progress* progress) {
  LostTimes found{std::move(at.times), std::move(at.positions), {}};
  const auto segments = [](const Trajectory& of) { return of.path().programmed()->segments.size(); };
  ProgressSteps steps(progress, others.size());
  for (std::size_t i = 0; i < others.size(); ++i) {
    steps.at(i);
    const Trajectory& other = *others[i].trajectory;
    // A machine that adds moves of its own runs another path.
    if (run.pieces().empty() || other.pieces().empty() || segments(run) != segments(other)) {
      continue;
    }
    LostTime one{others[i].name, others[i].color, times_at_places(run, other, found.times)};
    for (std::size_t k = 0; k < found.times.size(); ++k) {
      one.lost[k] = found.times[k] - one.lost[k];
    }
    found.others.push_back(std::move(one));
  }
  return found;
}

}  // namespace feedscope::ui
