#include "app/stop_signals.h"

#include <windows.h>

#include <atomic>
#include <csignal>
#include <cstring>
#include <exception>
#include <new>
#include <system_error>

#include "app/exit_codes.h"

namespace feedscope {
namespace {

// Set by the console's thread, which Windows starts for an event.
std::atomic<HANDLE> told_event{nullptr};  // of the living StopSignals
std::atomic<int> told_signal{0};
std::atomic<bool> woken{false};
std::atomic<int> latest_signal{0};
std::atomic<void (*)()> last_action{nullptr};
std::atomic<const char*> memory_message{""};

std::terminate_handler usual_end = nullptr;

void run_last_action() {
  if (auto* const action = last_action.load()) {
    action();
  }
}

/// Ctrl-C and Ctrl-Break interrupt; a closed console, the end of the session and of Windows terminate.
BOOL WINAPI on_console_event(DWORD event) {
  const int signal = event == CTRL_C_EVENT || event == CTRL_BREAK_EVENT ? SIGINT : SIGTERM;
  const HANDLE told = told_event;
  if (told == nullptr) {
    run_last_action();
    ExitProcess(static_cast<UINT>(exit_code::stopped_by(signal)));
  }
  told_signal = signal;
  SetEvent(told);
  if (signal == SIGTERM) {
    Sleep(INFINITE);  // Windows ends the process when this returns, and after some seconds
  }
  return TRUE;
}

void install_handler() {
  static const bool installed = SetConsoleCtrlHandler(on_console_event, TRUE) != 0;
  static_cast<void>(installed);
}

/// Whether a small part of a picture's memory is still available.
bool has_memory() {
  constexpr std::size_t bytes = std::size_t{64} << 20U;
  void* const found = VirtualAlloc(nullptr, bytes, MEM_RESERVE | MEM_COMMIT, PAGE_READWRITE);
  if (found == nullptr) {
    return false;
  }
  VirtualFree(found, 0, MEM_RELEASE);
  return true;
}

[[noreturn]] void end_without_memory() {
  const char* const message = memory_message;
  DWORD written = 0;
  WriteFile(GetStdHandle(STD_ERROR_HANDLE), message, static_cast<DWORD>(std::strlen(message)), &written,
            nullptr);
  TerminateProcess(GetCurrentProcess(), exit_code::failed);
  std::abort();
}

LONG WINAPI on_crash(EXCEPTION_POINTERS*) {
  run_last_action();
  if (!has_memory()) {
    end_without_memory();
  }
  return EXCEPTION_CONTINUE_SEARCH;
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

}  // namespace

StopSignals::StopSignals() {
  const HANDLE event = CreateEventW(nullptr, FALSE, FALSE, nullptr);
  if (event == nullptr) {
    throw std::system_error(static_cast<int>(GetLastError()), std::system_category(), "CreateEvent");
  }
  told_signal = 0;
  woken = false;
  told_event = event;
  install_handler();
}

StopSignals::~StopSignals() {
  CloseHandle(told_event.exchange(nullptr));
}

StopSignals::Event StopSignals::wait(int milliseconds) const {
  WaitForSingleObject(told_event, milliseconds < 0 ? INFINITE : static_cast<DWORD>(milliseconds));
  if (const int signal = told_signal.exchange(0); signal != 0) {
    latest_signal = signal;
    return Event::stop;
  }
  return woken.exchange(false) ? Event::wake : Event::none;
}

void StopSignals::wake() {
  woken = true;
  SetEvent(told_event);
}

int StopSignals::latest() {
  return latest_signal;
}

void StopSignals::end_now() {
  run_last_action();
  TerminateProcess(GetCurrentProcess(), static_cast<UINT>(exit_code::stopped_by(latest_signal)));
  std::abort();
}

void StopSignals::run_before_end(void (*action)()) {
  last_action = action;
  install_handler();
}

void report_file_limits() {}  // a write that Windows refuses fails with its reason

void report_memory_limits(const char* message) {
  memory_message = message;
  usual_end = std::set_terminate(on_terminate);
  SetUnhandledExceptionFilter(on_crash);
}

void remove_in_handler(const std::filesystem::path::value_type* file) {
  DeleteFileW(file);
}

}  // namespace feedscope
