#include "app/watch.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <optional>

#include "core/base/this_process.h"

namespace feedscope {
namespace {

constexpr int redraw_ms = 100;
constexpr auto quiet_time = std::chrono::seconds(1);
constexpr auto patience = std::chrono::milliseconds(900);  // time that cancelled work has to stop
constexpr int bar_width = 40;

}  // namespace

Watch::Watch() : thread_([this] { watch(); }) {}

Watch::~Watch() {
  signals_.wake();
  thread_.join();
}

int Watch::stopped_by() {
  return StopSignals::latest();
}

Progress* Watch::stage(const char* title) {
  title_ = title;
  progress_.report(0);
  return &progress_;
}

void Watch::watch() {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  std::optional<Clock::time_point> cancelled;
  const bool terminal = is_terminal(stderr);
  for (auto event = StopSignals::Event::none; event != StopSignals::Event::wake;) {
    event = signals_.wait(terminal || in_lines_ || cancelled ? redraw_ms : -1);
    if (event == StopSignals::Event::stop) {
      progress_.cancel();
      cancelled = cancelled.value_or(Clock::now());
    }
    if (cancelled && event != StopSignals::Event::wake && Clock::now() - *cancelled > patience) {
      end();
    }
    if (in_lines_) {
      tell();
    } else if (terminal && Clock::now() - start > quiet_time) {
      draw(false);
    }
  }
  if (drawn_) {
    draw(true);
  }
}

void Watch::end() {
  if (drawn_) {
    draw(true);
  }
  fmt::print(stderr, "feedscope: {}\n", cancelled_message);
  StopSignals::end_now();
}

void Watch::tell() {
  const int percent = static_cast<int>(100 * std::clamp(progress_.fraction(), 0.0, 1.0));
  const char* const title = title_.load();
  if (*title != '\0' && (percent != told_percent_ || title != told_title_)) {
    fmt::print(stderr, "progress: {} {} %\n", title, percent);
    std::fflush(stderr);
    told_percent_ = percent;
    told_title_ = title;
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
