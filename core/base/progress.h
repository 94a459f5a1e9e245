#pragma once

#include <atomic>
#include <cstddef>
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

/// Reports to a Progress, or to nobody, only every few thousand steps.
class ProgressSteps {
 public:
  ProgressSteps(Progress* progress, std::size_t total) : progress_(progress), total_(total) {}
  /// `done` of the total is done; throws Cancelled as Progress::report.
  void at(std::size_t done) {
    if (progress_ != nullptr && (done >= next_ || progress_->cancelled())) {
      next_ = done + every;
      progress_->report(static_cast<double>(done) / static_cast<double>(total_));
    }
  }

 private:
  static constexpr std::size_t every = 4096;
  Progress* progress_;
  std::size_t total_;
  std::size_t next_ = 0;
};

}  // namespace feedscope
