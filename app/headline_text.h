#pragma once

#include <optional>
#include <span>
#include <string>

#include "core/analysis/study/compare.h"

namespace feedscope {

/// The decision between runs in one or two sentences: the run to take, what it gains and its contour error,
/// or that none keeps the bound `within` [mm] (recommendation.h). `names`: short names of the runs, unique
/// among them. "" without a choice: no run, or one possible run without a bound.
std::string headline_text(std::span<const ComparedRun> runs, std::span<const std::string> names,
                          std::optional<double> within);

}  // namespace feedscope
