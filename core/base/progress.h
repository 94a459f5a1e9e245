#pragma once

#include <atomic>
#include <cstddef>
#include <exception>

namespace feedscope {

/// Thrown from long work after Progress::cancel().
class Cancelled : public std::exception {
 public:
  const char* what() const noexcept override { return "cancelled"; }
};

/// Progress of long work, shared between the working threads and an observer.
class Progress {
 public:
  Progress() = default;
  /// One of several parts processed at the same time: its progress adds to `whole` with its `share` in (0,
  /// 1], and cancelling the whole cancels it. `whole` outlives it.
  Progress(Progress& whole, double share) : whole_(&whole), share_(share) {}

  /// Called by the worker every few thousand blocks. `fraction` in [0, 1]. Throws Cancelled after a call of
  /// cancel().
  void report(double fraction) {
    const double before = fraction_.exchange(fraction, std::memory_order_relaxed);
    if (whole_ != nullptr) {
      whole_->add(share_ * (fraction - before));
    }
    if (cancelled()) {
      throw Cancelled();
    }
  }
  double fraction() const { return fraction_.load(std::memory_order_relaxed); }
  void cancel() { cancelled_.store(true, std::memory_order_relaxed); }
  bool cancelled() const {
    return cancelled_.load(std::memory_order_relaxed) || (whole_ != nullptr && whole_->cancelled());
  }

 private:
  void add(double part) {
    fraction_.fetch_add(part, std::memory_order_relaxed);
    if (whole_ != nullptr) {
      whole_->add(share_ * part);
    }
  }

  Progress* whole_ = nullptr;
  double share_ = 0;
  std::atomic<double> fraction_{0.0};
  std::atomic<bool> cancelled_{false};
};

/// For use within long steps. `progress` may be null.
inline void stop_if_cancelled(const Progress* progress) {
  if (progress != nullptr && progress->cancelled()) {
    throw Cancelled();
  }
}

/// Reports to a Progress, or null, only every few thousand steps.
class ProgressSteps {
 public:
  ProgressSteps(Progress* progress, std::size_t total) : ProgressSteps(progress, 0, total) {}
  /// Steps [first, first + total) of a whole.
  ProgressSteps(Progress* progress, std::size_t first, std::size_t total)
      : progress_(progress), first_(first), total_(total), next_(first) {}
  /// Everything before `done` is done; throws Cancelled as Progress::report does.
  void at(std::size_t done) {
    if (progress_ != nullptr && (done >= next_ || progress_->cancelled())) {
      next_ = done + every;
      progress_->report(static_cast<double>(done - first_) / static_cast<double>(total_));
    }
  }

 private:
  static constexpr std::size_t every = 4096;
  Progress* progress_;
  std::size_t first_;
  std::size_t total_;
  std::size_t next_;
};

}  // namespace feedscope
