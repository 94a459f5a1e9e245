#include "core/base/this_process.h"

#include <array>
#include <cstdint>
#include <system_error>

#ifdef _WIN32
#include <io.h>
#include <process.h>
#include <windows.h>
#else
#include <unistd.h>
#ifdef __APPLE__
#include <mach-o/dyld.h>
#endif
#endif

namespace feedscope {

namespace fs = std::filesystem;

int process_id() {
#ifdef _WIN32
  return _getpid();
#else
  return static_cast<int>(getpid());
#endif
}

fs::path executable_path() {
#if defined(_WIN32)
  std::array<wchar_t, 32768> name{};
  return GetModuleFileNameW(nullptr, name.data(), static_cast<DWORD>(name.size())) > 0 ? fs::path(name.data())
                                                                                       : fs::path();
#elif defined(__APPLE__)
  std::array<char, 4096> name{};
  auto size = static_cast<std::uint32_t>(name.size());
  return _NSGetExecutablePath(name.data(), &size) == 0 ? fs::path(name.data()) : fs::path();
#else
  std::error_code ignored;
  return fs::read_symlink("/proc/self/exe", ignored);
#endif
}

bool is_terminal(std::FILE* stream) {
#ifdef _WIN32
  return _isatty(_fileno(stream)) != 0;
#else
  return isatty(fileno(stream)) != 0;
#endif
}

bool may_write(const fs::path& file) {
#ifdef _WIN32
  constexpr int writing = 2;
  return _waccess(file.c_str(), writing) == 0;
#else
  return access(file.c_str(), W_OK) == 0;
#endif
}

}  // namespace feedscope
