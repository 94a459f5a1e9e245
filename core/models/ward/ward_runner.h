#pragma once

#include <memory>

#include "core/base/progress.h"
#include "core/models/ward/ward_pulses.h"
#include "core/models/ward/ward_settings.h"
#include "core/trajectory/stretch.h"

namespace feedscope {

/// Runs stretches from standstill to standstill into a trajectory, one after the other: chooses the pulses,
/// lowers them by WardTolerance until the contour tolerance is kept, and lays the filtered motion by
/// WardMotion.
class WardRunner {
 public:
  /// `smoothed`: a copy of `toolpath` whose points the compressor moves, stretch by stretch; null: compressor
  /// off.
  WardRunner(std::shared_ptr<const Toolpath> toolpath, std::shared_ptr<Toolpath> smoothed,
             const AxisVectors& axes, const WardSettings& settings, const PathRules& rules,
             TrajectoryBuilder& builder);

  /// Lines and arcs without a stop between them. `steps` counts segments.
  void run(const StretchRange& range, ProgressSteps& steps);

 private:
  /// Moves the points of dense blocks onto the compressor's curves.
  void smooth_points(const StretchRange& range);
  /// Pulses of a stretch without heights.
  WardPulses empty_pulses(const StretchRange& range) const;
  void hold_turns(WardPulses& pulses) const;
  void limit_arcs(WardPulses& pulses) const;
  void choose_corner_speeds(WardPulses& pulses) const;
  /// Returns the largest distance of a programmed point from the path [mm].
  double keep_tolerance(WardPulses& pulses, ProgressSteps& steps) const;

  std::shared_ptr<const Toolpath> programmed_;
  std::shared_ptr<Toolpath> smoothed_;         ///< null: compressor off
  std::shared_ptr<const Toolpath> commanded_;  ///< one of these
  Compressor compressor_;
  AxisVectors axes_;
  WardSettings settings_;
  const PathRules& rules_;
  TrajectoryBuilder& builder_;
};

}  // namespace feedscope
