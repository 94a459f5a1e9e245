#pragma once

#include "ui/scene/sampled_path.h"

namespace feedscope::ui {

/// sample_compared() for a run already drawn: `sampled` is sample_executed(trajectory) with `sources`. If
/// both runs have enough points, it is compared directly and not sampled again.
SampledPath compare_sampled(const SampledPath& sampled, const std::shared_ptr<const Trajectory>& trajectory,
                            const Trajectory& reference, std::span<const double> reference_times,
                            Progress* progress = nullptr, const RunSources& sources = {});

}  // namespace feedscope::ui
