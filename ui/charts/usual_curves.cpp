#include "ui/charts/usual_curves.h"

#include <algorithm>
#include <utility>

namespace feedscope::ui {

void UsualCurves::follow(const ChartColumns& columns, bool rapids) {
  std::vector<double> times;
  if (columns.crowded()) {
    const std::vector<double>& borders = columns.times();
    const double end = columns.trajectory()->duration();
    for (std::size_t i = 0; i + 1 < borders.size() && borders[i] < end; i += columns_a_stretch) {
      times.push_back(borders[i]);
    }
    times.push_back(std::min(borders.back(), end));
  }
  if (asked_ == columns.trajectory() && asked_times_ == times && asked_rapids_ == rapids) {
    return;
  }
  asked_ = columns.trajectory();
  asked_times_ = times;
  asked_rapids_ = rapids;
  job_.cancel();
  if (times.empty()) {
    set({});
  } else if (at_once_) {
    set(usual_motion(*asked_, times, rapids));
  } else {
    job_.start(
        [run = asked_, times, rapids](JobControl& control) {
          return usual_motion(*run, times, rapids, usual_instants, &control.progress);
        },
        [this](const JobOutcome<UsualMotion>& outcome) {
          if (outcome.result) {
            set(*outcome.result);
          }
        });
  }
}

void UsualCurves::set(UsualMotion found) {
  found_ = std::move(found);
  emit changed();
}

}  // namespace feedscope::ui
