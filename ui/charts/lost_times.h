#pragma once

#include <QColor>
#include <QString>
#include <vector>

#include "core/base/progress.h"
#include "ui/charts/run_overlay.h"

namespace feedscope::ui {

/// Time that a run has lost against another one, at places along it.
struct LostTime {
  QString name;  ///< of the other run
  QColor color;
  std::vector<double> lost;  ///< at LostTimes::times [s]; negative: gained
};
struct LostTimes {
  std::vector<double> times;      ///< of the run [s]
  std::vector<double> positions;  ///< of these times along the abscissa of the charts
  std::vector<LostTime> others;
};

/// `at` with the times that `run` has lost against each of `others` with the same programmed path
/// (RunDifference::lost). Linear in the pieces of both. Throws Cancelled.
LostTimes lost_times(const Trajectory& run, const std::vector<RunOverlay>& others, LostTimes at,
                     Progress* progress = nullptr);

}  // namespace feedscope::ui
