#pragma once

#include <memory>
#include <optional>

#include "core/analysis/load/load_sampler.h"
#include "core/analysis/rotary/rotary_course.h"
#include "core/analysis/run/quantity.h"

namespace feedscope {

/// Data of a run in addition to the set motion.
struct RunSources {
  std::shared_ptr<const ActualPath> actual;    ///< null if all axes follow their set values exactly
  std::shared_ptr<const RunLoad> load;         ///< null without known operations
  std::shared_ptr<const RotaryCourse> rotary;  ///< null if no rotary axis turns
  bool limits_jerk = true;  ///< otherwise the acceleration jumps, and jerks are those between the jumps

  /// Whether a run has quantities of this source.
  bool has(QuantitySource source) const;
  /// Whether a run has this quantity: of a rotary axis only if the machine has the axis.
  bool has(const QuantityInfo& quantity) const;
};

/// Instants of a run, in order.
class InstantSampler {
 public:
  /// `from`: the first instant [s]. `sources` must outlive this.
  explicit InstantSampler(const RunSources& sources, double from = 0);

  /// `state`: of the trajectory, not before that of the previous call. The result refers to it, and to this
  /// object until the next call.
  Instant at(const State& state);

 private:
  std::optional<ActualSampler> actual_;
  std::optional<LoadSampler> load_;
  const RotaryCourse* rotary_ = nullptr;
  ActualSample actual_sample_;
  LoadSample load_sample_;
  RotarySample rotary_sample_;
};

}  // namespace feedscope
