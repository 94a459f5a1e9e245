#pragma once

#include <QString>

#include "core/analysis/study/operations.h"

namespace feedscope::ui {

/// Name of an operation that begins at `line`: "Tool 3", the words of its comment, or in the user's language
/// a name for the part before the first.
QString operation_title(const std::string& title, std::uint32_t line, OperationSplit split);

}  // namespace feedscope::ui
