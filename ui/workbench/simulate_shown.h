#pragma once

#include <functional>
#include <memory>

#include "ui/workbench/shown_run.h"

namespace feedscope::ui {

using DrawableRun = std::function<void(const std::shared_ptr<const ShownRun>&)>;

/// Simulates a run and makes the data of its pictures, on all cores, the summary in parallel. Throws as
/// simulate_run(). `before`: another run of the same program, whose motion is reused if only the cutting load
/// differs. `parts`: the others remain null, or empty. `drawable`: called once, on any thread, with the
/// drawable part: the run without its summary and lines, which follow.
std::shared_ptr<const ShownRun> simulate_shown(const LoadedProgram& input, Setup setup,
                                               Progress* progress = nullptr, const ShownRun* before = nullptr,
                                               const ShownParts& parts = {},
                                               const DrawableRun& drawable = {});

}  // namespace feedscope::ui
