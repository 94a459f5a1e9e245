#include "app/stop_signals.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <system_error>

namespace feedscope {
namespace {

constexpr std::array ending_signals{SIGHUP, SIGINT, SIGQUIT, SIGPIPE, SIGTERM};

// What the handler reads; lock-free, so that it may.
std::atomic<int> told_end{-1};  // of the pipe of the living StopSignals
std::atomic<void (*)()> last_action{nullptr};
std::atomic<int> latest_signal{0};
static_assert(std::atomic<int>::is_always_lock_free && std::atomic<void (*)()>::is_always_lock_free);

bool is_told(int signal) {
  return signal == SIGHUP || signal == SIGINT || signal == SIGTERM;
}

/// The signal ends the process as it would have without us, unless it is told to a StopSignals.
void on_signal(int signal) {
  const int saved_error = errno;
  const int end = told_end;
  if (end >= 0 && is_told(signal)) {
    const auto byte = static_cast<unsigned char>(signal);
    [[maybe_unused]] const ssize_t written = write(end, &byte, 1);  // a full pipe has told it already
    errno = saved_error;
    return;
  }
  if (auto* const action = last_action.load()) {
    action();
  }
  std::signal(signal, SIG_DFL);
  raise(signal);
}

void install_handlers() {
  for (const int signal : ending_signals) {
    struct sigaction action {};
    sigaction(signal, nullptr, &action);
    if (action.sa_handler == SIG_DFL) {
      action.sa_handler = on_signal;
      action.sa_flags = SA_RESTART;
      sigaction(signal, &action, nullptr);
    }
  }
}

}  // namespace

StopSignals::StopSignals() {
  if (pipe(pipe_) != 0) {
    throw std::system_error(errno, std::generic_category(), "pipe");
  }
  for (const int end : pipe_) {
    fcntl(end, F_SETFD, FD_CLOEXEC);
    fcntl(end, F_SETFL, O_NONBLOCK);
  }
  told_end = pipe_[1];
  install_handlers();
}

StopSignals::~StopSignals() {
  told_end = -1;
  close(pipe_[0]);
  close(pipe_[1]);
}

StopSignals::Event StopSignals::wait(int milliseconds) const {
  pollfd readable{pipe_[0], POLLIN, 0};
  poll(&readable, 1, milliseconds);
  unsigned char byte = 0;
  if (read(pipe_[0], &byte, 1) != 1) {
    return Event::none;
  }
  if (byte == 0) {
    return Event::wake;
  }
  latest_signal = byte;
  return Event::stop;
}

void StopSignals::wake() {
  const unsigned char byte = 0;
  [[maybe_unused]] const ssize_t written = write(pipe_[1], &byte, 1);
}

int StopSignals::latest() {
  return latest_signal;
}

void StopSignals::run_before_end(void (*action)()) {
  last_action = action;
  install_handlers();
}

void remove_in_handler(const char* file) {
  unlink(file);
}

}  // namespace feedscope
