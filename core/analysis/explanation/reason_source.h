#pragma once

#include "core/analysis/explanation/element_limits.h"
#include "core/analysis/explanation/explanation.h"

namespace feedscope {

/// Paper and equation of a formula as a model uses it.
std::string_view source_of(FormulaId id, const LimitTraits& traits);

/// Reason at an element of a run, with its source.
Reason made_reason(const Trajectory& run, const ElementLimits& limits, Cause cause, Formula formula,
                   double reached, std::uint32_t element);

}  // namespace feedscope
