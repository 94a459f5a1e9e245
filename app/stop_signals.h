#pragma once

namespace feedscope {

/// What ends a program from outside: hang-up, interrupt (Ctrl-C), quit, broken pipe, termination. All that
/// the program knows of signals is in here: POSIX, tried on Linux; macOS is untested, and Windows would need
/// SetConsoleCtrlHandler in its place.
class StopSignals {
 public:
  /// While it lives, hang-up, interrupt and termination end nothing and are told by wait(); those that are
  /// ignored (nohup, a job in the background) stay so. One at a time.
  StopSignals();
  ~StopSignals();
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;

  enum class Event { none, stop, wake };
  /// Returns when a signal came, wake() was called, or `milliseconds` have passed; -1: however long it takes.
  Event wait(int milliseconds) const;
  /// Ends a wait() of another thread.
  void wake();
  /// The latest signal that wait() told, 0 if there was none.
  static int latest();
  /// Ends the process as that signal asked for, with the exit code of exit_codes.h, whatever its other
  /// threads do: what run_before_end() named runs, destructors do not.
  [[noreturn]] static void end_now();

  /// Has `action` run before a signal ends the process. It may only do what is safe in a signal handler.
  static void run_before_end(void (*action)());

 private:
  int pipe_[2] = {-1, -1};
};

/// Has a write beyond the limit of a file's size (ulimit -f) fail with its reason instead of ending the
/// process.
void report_file_limits();

/// Has a process that crashes run what run_before_end() named. Where it crashes because memory ran out, as
/// libraries that draw do that do not check what they allocate, `message` goes to standard error and the exit
/// code is that of a failure (exit_codes.h). `message` must stay where it is.
void report_memory_limits(const char* message);

/// Removes a file; safe in a signal handler.
void remove_in_handler(const char* file);

}  // namespace feedscope
