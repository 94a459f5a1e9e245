#include "app/watch.h"

#include <fmt/format.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdio>

namespace feedscope {
namespace {

constexpr int redraw_ms = 100;
constexpr auto quiet_time = std::chrono::seconds(1);
constexpr int bar_width = 40;

sigset_t stop_signals() {
  sigset_t set;
  sigemptyset(&set);
  for (const int signal : {SIGINT, SIGHUP, SIGTERM}) {
    struct sigaction action {};
    sigaction(signal, nullptr, &action);
    if (action.sa_handler != SIG_IGN) {
      sigaddset(&set, signal);
    }
  }
  return set;
}

std::atomic<int> stopping_signal{0};

}  // namespace

Watch::Watch() {
  const sigset_t set = stop_signals();
  pthread_sigmask(SIG_BLOCK, &set, nullptr);
  signals_ = signalfd(-1, &set, SFD_CLOEXEC);
  stop_ = eventfd(0, EFD_CLOEXEC);
  thread_ = std::thread([this] { watch(); });
}

Watch::~Watch() {
  eventfd_write(stop_, 1);
  thread_.join();
  close(signals_);
  close(stop_);
  const sigset_t set = stop_signals();
  pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
}

int Watch::stopped_by() {
  return stopping_signal;
}

Progress* Watch::stage(const char* title) {
  title_ = title;
  progress_.report(0);
  return &progress_;
}

void Watch::watch() {
  const auto start = std::chrono::steady_clock::now();
  const bool terminal = isatty(STDERR_FILENO) != 0;
  std::array<pollfd, 2> events{pollfd{signals_, POLLIN, 0}, pollfd{stop_, POLLIN, 0}};
  while ((events[1].revents & POLLIN) == 0) {
    poll(events.data(), events.size(), terminal ? redraw_ms : -1);
    if ((events[0].revents & POLLIN) != 0) {
      signalfd_siginfo taken{};
      if (read(signals_, &taken, sizeof taken) > 0) {
        stopping_signal = static_cast<int>(taken.ssi_signo);
        progress_.cancel();
      }
    }
    if (terminal && std::chrono::steady_clock::now() - start > quiet_time) {
      draw(false);
    }
  }
  if (drawn_) {
    draw(true);
  }
}

void Watch::draw(bool last) {
  const int filled = static_cast<int>(std::clamp(progress_.fraction(), 0.0, 1.0) * bar_width);
  const std::string bar =
      fmt::format("{:10} [{:-<{}}] {:3} %", title_.load(), std::string(static_cast<std::size_t>(filled), '#'),
                  bar_width, filled * 100 / bar_width);
  fmt::print(stderr, "\r\x1b[K{}", last ? "" : bar);
  std::fflush(stderr);
  drawn_ = true;
}

}  // namespace feedscope
