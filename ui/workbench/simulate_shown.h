#pragma once

#include <functional>
#include <memory>

#include "ui/workbench/shown_run.h"

namespace feedscope::ui {

using DrawableRun = std::function<void(const std::shared_ptr<const ShownRun>&)>;

/// Simulates a run and makes what its pictures need, on all cores: the summary beside the pictures. Throws
/// what simulate_run() throws. `before`: another run of the same program; where only the cutting load
/// differs, its motion is used again. `parts`: the others stay null, or empty. `drawable`: called once, on
/// any thread, when what pictures draw is there: the run without its summary and lines, which follow.
std::shared_ptr<const ShownRun> simulate_shown(const LoadedProgram& input, Setup setup,
                                               Progress* progress = nullptr, const ShownRun* before = nullptr,
                                               const ShownParts& parts = {},
                                               const DrawableRun& drawable = {});

}  // namespace feedscope::ui
