#pragma once

#include <atomic>
#include <exception>

namespace feedscope {

/// Thrown out of long work after Progress::cancel().
class Cancelled : public std::exception {
 public:
  const char* what() const noexcept override { return "cancelled"; }
};

/// Shared between the thread that works and the one that watches.
class Progress {
 public:
  /// Called by the worker every few thousand blocks. `fraction` in [0, 1].
  /// Throws Cancelled once cancel() was called.
  void report(double fraction) {
    fraction_.store(fraction, std::memory_order_relaxed);
    if (cancelled()) {
      throw Cancelled();
    }
  }
  double fraction() const { return fraction_.load(std::memory_order_relaxed); }
  void cancel() { cancelled_.store(true, std::memory_order_relaxed); }
  bool cancelled() const { return cancelled_.load(std::memory_order_relaxed); }

 private:
  std::atomic<double> fraction_{0.0};
  std::atomic<bool> cancelled_{false};
};

}  // namespace feedscope
