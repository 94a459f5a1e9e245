#pragma once

#include "ui/scene/sampled_path.h"

namespace feedscope::ui {

/// sample_compared() of a run that has been drawn: `sampled` is sample_executed(trajectory) with `sources`.
/// Where both runs have so many points that no others are needed, it is compared as it is and not sampled
/// again.
SampledPath compare_sampled(const SampledPath& sampled, const std::shared_ptr<const Trajectory>& trajectory,
                            const Trajectory& reference, std::span<const double> reference_times,
                            Progress* progress = nullptr, const RunSources& sources = {});

}  // namespace feedscope::ui
