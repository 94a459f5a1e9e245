#pragma once

#include <atomic>
#include <string>
#include <thread>

#include "app/stop_signals.h"
#include "core/base/progress.h"

namespace feedscope {

/// Watches long work. After a second, a terminal shows a progress bar on standard error. Ctrl-C, a hang-up or
/// a termination cancels the work through the progress. Work that does not stop within a second (a library
/// that draws may not) is ended with the process, and no half-written file is left. During its lifetime,
/// SIGINT, SIGHUP and SIGTERM do nothing else; ignored signals (nohup) stay ignored.
class Watch {
 public:
  Watch();
  ~Watch();
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;

  /// Begins the next stage of the work; `title` must outlive the watch.
  Progress* stage(const char* title);
  static constexpr const char* cancelled_message = "cancelled; no file was written";
  /// The signal that cancelled work of this process, 0 if none did.
  static int stopped_by();
  /// From now on prints progress on standard error as lines "progress: STAGE 43 %", terminal or not, for
  /// programs that start this one.
  static void tell_in_lines() { in_lines_ = true; }

 private:
  void watch();
  [[noreturn]] void end();
  void draw(bool last);
  void tell();

  inline static bool in_lines_ = false;

  Progress progress_;
  std::atomic<const char*> title_{""};
  StopSignals signals_;
  bool drawn_ = false;
  int told_percent_ = -1;
  const char* told_title_ = "";
  std::thread thread_;
};

}  // namespace feedscope
