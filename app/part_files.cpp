#include "app/part_files.h"

#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>
#include <mutex>

namespace feedscope::part_files {
namespace {

constexpr std::array ending_signals{SIGHUP, SIGINT, SIGQUIT, SIGPIPE, SIGTERM};

// The handler reads what stands here; lock-free, so that it may.
std::array<std::atomic<const char*>, 16> files;
static_assert(std::atomic<const char*>::is_always_lock_free);

/// Calls only what is safe in a signal handler; then the signal ends the process as it would have.
void remove_and_end(int signal) {
  for (const auto& file : files) {
    if (const char* name = file.load()) {
      unlink(name);
    }
  }
  std::signal(signal, SIG_DFL);
  raise(signal);
}

/// A signal that is ignored (nohup, a job in the background) stays ignored.
void install_handlers() {
  for (const int signal : ending_signals) {
    struct sigaction action {};
    sigaction(signal, nullptr, &action);
    if (action.sa_handler == SIG_DFL) {
      action.sa_handler = remove_and_end;
      sigaction(signal, &action, nullptr);
    }
  }
}

void replace(const char* now, const char* then) {
  for (auto& file : files) {
    const char* expected = now;
    if (file.compare_exchange_strong(expected, then)) {
      return;
    }
  }
}

}  // namespace

void remember(const std::filesystem::path& file) {
  static std::once_flag installed;
  std::call_once(installed, install_handlers);
  replace(nullptr, file.c_str());
}

void forget(const std::filesystem::path& file) {
  replace(file.c_str(), nullptr);
}

}  // namespace feedscope::part_files
