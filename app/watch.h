#pragma once

#include <atomic>
#include <string>
#include <thread>

#include "app/stop_signals.h"
#include "core/base/progress.h"

namespace feedscope {

/// Watches long work: a progress bar on standard error once it takes longer than a second (on a terminal),
/// and Ctrl-C, a hang-up or a termination cancels it through the progress. While it lives, SIGINT, SIGHUP and
/// SIGTERM do nothing else; those that are ignored (nohup) stay so.
class Watch {
 public:
  Watch();
  ~Watch();
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;

  /// Begins the next stage of the work; `title` must outlive the watch.
  Progress* stage(const char* title);
  /// The signal that cancelled work of this process, 0 if none did.
  static int stopped_by();

 private:
  void watch();
  void draw(bool last);

  Progress progress_;
  std::atomic<const char*> title_{""};
  StopSignals signals_;
  bool drawn_ = false;
  std::thread thread_;
};

}  // namespace feedscope
