#include "core/base/this_process.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <system_error>

#ifdef __APPLE__
#include <mach-o/dyld.h>
#endif
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace feedscope {

namespace fs = std::filesystem;

std::span<char*> start_process(int argc, char** argv) {
  return {argv, static_cast<std::size_t>(argc)};
}

int process_id() {
  return static_cast<int>(getpid());
}

fs::path executable_path() {
#ifdef __APPLE__
  std::array<char, 4096> name{};
  auto size = static_cast<std::uint32_t>(name.size());
  return _NSGetExecutablePath(name.data(), &size) == 0 ? fs::path(name.data()) : fs::path();
#else
  std::error_code ignored;
  return fs::read_symlink("/proc/self/exe", ignored);
#endif
}

std::optional<fs::path> path_in_environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr || *value == '\0' ? std::nullopt : std::optional<fs::path>(value);
}

bool is_terminal(std::FILE* stream) {
  return isatty(fileno(stream)) != 0;
}

bool may_write(const fs::path& file) {
  return access(file.c_str(), W_OK) == 0;
}

std::FILE* open_to_read(const fs::path& file) {
  return std::fopen(file.c_str(), "rb");
}

int descriptor_to_read(const fs::path& file) {
  return open(file.c_str(), O_RDONLY | O_CLOEXEC);
}

int flush_to_disk(const fs::path& file) {
  const int descriptor = open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) {
    return 0;
  }
  int result = 0;
  do {
    result = fsync(descriptor);
  } while (result != 0 && errno == EINTR);
  const int error = result == 0 || errno == EINVAL || errno == ENOTSUP ? 0 : errno;
  close(descriptor);
  return error;
}

void give_back_memory() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

}  // namespace feedscope
