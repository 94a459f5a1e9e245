#pragma once

#include <filesystem>

#include "core/base/message.h"

namespace feedscope {

/// What the beginning of a file looks like.
enum class TraceGuess {
  none,            ///< no trace: no rows of numbers
  readable,        ///< a trace that says itself what its columns are, or whose values say it
  columns_wanted,  ///< a table of numbers, but what its columns are must be told
};

struct GuessedTrace {
  TraceGuess guess = TraceGuess::none;
  Message problem;  ///< why the columns must be told, for people; else empty
};

/// Looks at the first mebibyte of a file, packed by gzip or not. Does not throw: a file that cannot be read
/// is none.
GuessedTrace guess_trace(const std::filesystem::path& file);

}  // namespace feedscope
