#include "app/stop_signals.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstring>
#include <exception>
#include <new>
#include <system_error>

#include "app/exit_codes.h"

namespace feedscope {
namespace {

constexpr std::array ending_signals{SIGHUP, SIGINT, SIGQUIT, SIGPIPE, SIGTERM};
constexpr std::array crash_signals{SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGSEGV};

// Read by the handler, therefore lock-free.
std::atomic<int> told_end{-1};  // write end of the pipe
std::atomic<void (*)()> last_action{nullptr};
std::atomic<int> latest_signal{0};
std::atomic<const char*> memory_message{""};
static_assert(std::atomic<int>::is_always_lock_free && std::atomic<void (*)()>::is_always_lock_free &&
              std::atomic<const char*>::is_always_lock_free);

std::array<int, 2> event_pipe{-1, -1};  // of the living StopSignals
std::terminate_handler usual_end = nullptr;

bool is_told(int signal) {
  return signal == SIGHUP || signal == SIGINT || signal == SIGTERM;
}

void run_last_action() {
  if (auto* const action = last_action.load()) {
    action();
  }
}

/// Takes the default action of the signal.
void end_by(int signal) {
  std::signal(signal, SIG_DFL);
  raise(signal);
}

/// Passes the signal to a living StopSignals; else ends the process as by default.
void on_signal(int signal) {
  const int saved_error = errno;
  const int end = told_end;
  if (end >= 0 && is_told(signal)) {
    const auto byte = static_cast<unsigned char>(signal);
    [[maybe_unused]] const ssize_t written = write(end, &byte, 1);  // a full pipe has reported it
    errno = saved_error;
    return;
  }
  run_last_action();
  end_by(signal);
}

/// Whether a small part of a picture's memory is still available.
bool has_memory() {
  constexpr std::size_t bytes = std::size_t{64} << 20U;
  void* const found = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (found == MAP_FAILED) {
    return false;
  }
  munmap(found, bytes);
  return true;
}

[[noreturn]] void end_without_memory() {
  const char* const message = memory_message;
  [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, message, std::strlen(message));
  _exit(exit_code::failed);
}

void on_crash(int signal) {
  run_last_action();
  if (!has_memory()) {
    end_without_memory();
  }
  end_by(signal);
}

/// Memory that runs out in a destructor throws where no exception may leave.
void on_terminate() {
  try {
    if (const std::exception_ptr thrown = std::current_exception()) {
      std::rethrow_exception(thrown);
    }
  } catch (const std::bad_alloc&) {
    run_last_action();
    end_without_memory();
  } catch (...) {
  }
  usual_end();
}

/// Leaves ignored signals alone, and those of a sanitizer.
void handle(int signal, void (*handler)(int)) {
  struct sigaction action {};
  sigaction(signal, nullptr, &action);
  if (action.sa_handler == SIG_DFL) {
    action.sa_handler = handler;
    action.sa_flags = SA_RESTART | SA_ONSTACK;
    sigaction(signal, &action, nullptr);
  }
}

void install_handlers() {
  for (const int signal : ending_signals) {
    handle(signal, on_signal);
  }
}

/// A separate stack for the handlers of this thread: a library that recurses without memory exhausts the
/// usual one.
void give_handlers_a_stack() {
  static std::array<char, 64 << 10> room;
  stack_t present{};
  if (sigaltstack(nullptr, &present) == 0 && (present.ss_flags & SS_DISABLE) != 0) {
    stack_t own{};
    own.ss_sp = room.data();
    own.ss_size = room.size();
    sigaltstack(&own, nullptr);
  }
}

}  // namespace

StopSignals::StopSignals() {
  if (pipe(event_pipe.data()) != 0) {
    throw std::system_error(errno, std::generic_category(), "pipe");
  }
  for (const int end : event_pipe) {
    fcntl(end, F_SETFD, FD_CLOEXEC);
    fcntl(end, F_SETFL, O_NONBLOCK);
  }
  told_end = event_pipe[1];
  install_handlers();
}

StopSignals::~StopSignals() {
  told_end = -1;
  close(event_pipe[0]);
  close(event_pipe[1]);
}

StopSignals::Event StopSignals::wait(int milliseconds) const {
  pollfd readable{event_pipe[0], POLLIN, 0};
  poll(&readable, 1, milliseconds);
  unsigned char byte = 0;
  if (read(event_pipe[0], &byte, 1) != 1) {
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
  [[maybe_unused]] const ssize_t written = write(event_pipe[1], &byte, 1);
}

int StopSignals::latest() {
  return latest_signal;
}

void StopSignals::end_now() {
  run_last_action();
  _exit(exit_code::stopped_by(latest_signal));
}

void StopSignals::run_before_end(void (*action)()) {
  last_action = action;
  install_handlers();
}

void report_file_limits() {
  handle(SIGXFSZ, [](int) {});  // not SIG_IGN: child processes would inherit that
}

void report_memory_limits(const char* message) {
  memory_message = message;
  give_handlers_a_stack();
  usual_end = std::set_terminate(on_terminate);
  for (const int signal : crash_signals) {
    handle(signal, on_crash);
  }
}

void remove_in_handler(const std::filesystem::path::value_type* file) {
  unlink(file);
}

}  // namespace feedscope
