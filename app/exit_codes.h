#pragma once

namespace feedscope::exit_code {

inline constexpr int done = 0;
inline constexpr int program_errors =
    1;  ///< the NC program or imported file had errors; results of the rest are written
inline constexpr int claim_fails = 1;  ///< a claim of a lesson fails
inline constexpr int wrong_use =
    2;  ///< wrong option, call, machine file or trace; unreadable or unwritable file
inline constexpr int failed = 3;  ///< out of memory, or a defect of Feedscope itself

/// Exit code after a signal, as shells report it: 130 for Ctrl-C, 143 for a termination.
constexpr int stopped_by(int signal) {
  return 128 + signal;
}

}  // namespace feedscope::exit_code
