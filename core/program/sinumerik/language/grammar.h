#pragma once

#include "core/program/language/expression.h"

namespace feedscope::sinumerik {

/// Operators and functions of the control's expressions. Comparisons have the lowest rank, below AND and OR.
/// Angles are in degrees.
const ExpressionGrammar& grammar();

}  // namespace feedscope::sinumerik
