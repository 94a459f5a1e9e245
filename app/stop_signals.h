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

  /// Has `action` run before a signal ends the process. It may only do what is safe in a signal handler.
  static void run_before_end(void (*action)());

 private:
  int pipe_[2] = {-1, -1};
};

/// Removes a file; safe in a signal handler.
void remove_in_handler(const char* file);

}  // namespace feedscope
