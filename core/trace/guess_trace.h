#pragma once

#include <filesystem>

#include "core/base/message.h"

namespace feedscope {

/// Result of a look at the beginning of a file.
enum class TraceGuess {
  none,            ///< no trace: no rows of numbers
  readable,        ///< a trace whose columns are evident from titles or values
  columns_wanted,  ///< a table of numbers whose columns must be specified
};

struct GuessedTrace {
  TraceGuess guess = TraceGuess::none;
  Message problem;  ///< reason why the columns must be specified, for display; else empty
};

/// Examines the first mebibyte of a file, with or without gzip. Does not throw: an unreadable file is no
/// trace.
GuessedTrace guess_trace(const std::filesystem::path& file);

}  // namespace feedscope
