#pragma once

#include <filesystem>

namespace feedscope {

/// Signals that end a program from outside: hang-up, interrupt (Ctrl-C), quit, broken pipe, termination; on
/// Windows the events of the console. All signal handling of the program is here, with a file each in posix/
/// (tested on Linux, not on macOS) and windows/ (untested).
class StopSignals {
 public:
  /// During its lifetime, wait() reports hang-up, interrupt and termination, and they end nothing; ignored
  /// ones (nohup, a job in the background) stay ignored. One instance at a time.
  StopSignals();
  ~StopSignals();
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;

  enum class Event { none, stop, wake };
  /// Returns at a signal, at wake(), or after `milliseconds`; -1: no time limit.
  Event wait(int milliseconds) const;
  /// Ends a wait() of another thread.
  void wake();
  /// The latest signal that wait() reported, 0 for none.
  static int latest();
  /// Ends the process as that signal demands, with its exit code (exit_codes.h), whatever other threads do.
  /// Runs the action of run_before_end(), but no destructors.
  [[noreturn]] static void end_now();

  /// Has `action` run before a signal ends the process. It may only do what is safe in a signal handler.
  static void run_before_end(void (*action)());
};

/// Makes a write beyond the file size limit (ulimit -f) fail with its reason instead of ending the process.
void report_file_limits();

/// Makes a crash run the action of run_before_end(). Drawing libraries with unchecked allocations crash when
/// memory runs out; `message` then goes to standard error and the exit code is that of a failure
/// (exit_codes.h). `message` must not move in memory.
void report_memory_limits(const char* message);

/// Removes a file; safe in a signal handler.
void remove_in_handler(const std::filesystem::path::value_type* file);

}  // namespace feedscope
