#pragma once

namespace feedscope::exit_code {

inline constexpr int done = 0;
inline constexpr int program_errors =
    1;  ///< the NC program or imported file had errors; results of the rest are written
inline constexpr int claim_fails = 1;  ///< something that a lesson claims does not hold
inline constexpr int wrong_use =
    2;  ///< wrong option, call, machine file or trace; a file that cannot be read or written
inline constexpr int failed = 3;  ///< out of memory, or a mistake in Feedscope itself

/// Ended by a signal, as shells report it: 130 for Ctrl-C, 143 for a termination.
constexpr int stopped_by(int signal) {
  return 128 + signal;
}

}  // namespace feedscope::exit_code
