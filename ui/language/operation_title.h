#pragma once

#include <QString>

#include "core/analysis/study/operations.h"

namespace feedscope::ui {

/// What an operation that begins at `line` is called: "Tool 3", the words of its comment, or in the user's
/// language what runs before the first of them.
QString operation_title(const std::string& title, std::uint32_t line, OperationSplit split);

}  // namespace feedscope::ui
