#pragma once

#include <memory>
#include <optional>

#include "core/analysis/load/load_sampler.h"
#include "core/analysis/quantity.h"
#include "core/analysis/rotary_course.h"

namespace feedscope {

/// What a run has beside the motion that the control sets.
struct RunSources {
  std::shared_ptr<const ActualPath> actual;    ///< null where all axes follow their set values exactly
  std::shared_ptr<const RunLoad> load;         ///< null where no operations are known
  std::shared_ptr<const RotaryCourse> rotary;  ///< null where no rotary axis turns
  bool limits_jerk = true;  ///< else the acceleration jumps, and jerks are those between the jumps

  /// Whether a run has quantities of this source.
  bool has(QuantitySource source) const;
  /// The same of one quantity: of a rotary axis only where the machine has it.
  bool has(const QuantityInfo& quantity) const;
};

/// Instants of a run, in order.
class InstantSampler {
 public:
  /// `from`: the first instant [s]. `sources` must outlive this.
  explicit InstantSampler(const RunSources& sources, double from = 0);

  /// `state`: of the trajectory, not before that of the last call. What is returned refers to it, and to this
  /// until the next call.
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
