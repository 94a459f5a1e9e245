#include "app/part_files.h"

#include <array>
#include <atomic>
#include <mutex>

#include "app/stop_signals.h"

namespace feedscope::part_files {
namespace {

// Read by a signal handler, therefore lock-free.
using FileName = const std::filesystem::path::value_type*;
std::array<std::atomic<FileName>, 64> files;
static_assert(std::atomic<FileName>::is_always_lock_free);

void remove_all() {
  for (const auto& file : files) {
    if (const FileName name = file.load()) {
      remove_in_handler(name);
    }
  }
}

void replace(FileName now, FileName then) {
  for (auto& file : files) {
    FileName expected = now;
    if (file.compare_exchange_strong(expected, then)) {
      return;
    }
  }
}

}  // namespace

void remember(const std::filesystem::path& file) {
  static std::once_flag installed;
  std::call_once(installed, [] { StopSignals::run_before_end(remove_all); });
  replace(nullptr, file.c_str());
}

void forget(const std::filesystem::path& file) {
  replace(file.c_str(), nullptr);
}

}  // namespace feedscope::part_files
