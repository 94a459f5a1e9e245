#pragma once

#include <atomic>
#include <string>
#include <thread>

#include "app/stop_signals.h"
#include "core/base/progress.h"

namespace feedscope {

/// Watches long work: a progress bar on standard error once it takes longer than a second (on a terminal),
/// and Ctrl-C, a hang-up or a termination cancels it through the progress. Work that has not ended within a
/// second, as a library that draws may not, is ended with the process; nothing half written is left. While it
/// lives, SIGINT, SIGHUP and SIGTERM do nothing else; those that are ignored (nohup) stay so.
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
  /// From now on progress is told on standard error as lines "progress: STAGE 43 %", terminal or not, for
  /// programs that run this one.
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
