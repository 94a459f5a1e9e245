#include "core/base/this_process.h"

#include <windows.h>

#include <fcntl.h>
#include <io.h>
#include <malloc.h>
#include <process.h>
#include <shellapi.h>

#include <array>
#include <cerrno>
#include <cwchar>
#include <string>
#include <vector>

namespace feedscope {

namespace fs = std::filesystem;
namespace {

std::string to_utf8(const wchar_t* text) {
  const int size = WideCharToMultiByte(CP_UTF8, 0, text, -1, nullptr, 0, nullptr, nullptr);
  std::string out(static_cast<std::size_t>(size), '\0');
  WideCharToMultiByte(CP_UTF8, 0, text, -1, out.data(), size, nullptr, nullptr);
  out.pop_back();  // the final zero
  return out;
}

/// The words of the command line; they live as long as the process.
std::vector<std::string> command_line_words() {
  int count = 0;
  wchar_t** const words = CommandLineToArgvW(GetCommandLineW(), &count);
  std::vector<std::string> out;
  for (int i = 0; i < count; ++i) {
    out.push_back(to_utf8(words[i]));
  }
  LocalFree(words);
  return out;
}

}  // namespace

std::span<char*> start_process(int, char**) {
  for (std::FILE* stream : {stdin, stdout, stderr}) {
    _setmode(_fileno(stream), _O_BINARY);
  }
  SetConsoleOutputCP(CP_UTF8);
  static std::vector<std::string> words = command_line_words();
  static std::vector<char*> arguments;
  for (std::string& word : words) {
    arguments.push_back(word.data());
  }
  arguments.push_back(nullptr);
  return {arguments.data(), words.size()};
}

int process_id() {
  return _getpid();
}

fs::path executable_path() {
  std::array<wchar_t, 32768> name{};
  return GetModuleFileNameW(nullptr, name.data(), static_cast<DWORD>(name.size())) > 0 ? fs::path(name.data())
                                                                                       : fs::path();
}

std::optional<fs::path> path_in_environment(const char* name) {
  const wchar_t* value = _wgetenv(fs::path(name).c_str());
  return value == nullptr || *value == L'\0' ? std::nullopt : std::optional<fs::path>(value);
}

bool is_terminal(std::FILE* stream) {
  return _isatty(_fileno(stream)) != 0;
}

bool may_write(const fs::path& file) {
  constexpr int writing = 2;
  return _waccess(file.c_str(), writing) == 0;
}

std::FILE* open_to_read(const fs::path& file) {
  return _wfopen(file.c_str(), L"rb");
}

int descriptor_to_read(const fs::path& file) {
  return _wopen(file.c_str(), _O_RDONLY | _O_BINARY);
}

int flush_to_disk(const fs::path& file) {
  const int descriptor = _wopen(file.c_str(), _O_RDWR | _O_BINARY);
  if (descriptor < 0) {
    return 0;
  }
  const int error = _commit(descriptor) == 0 || errno == EINVAL ? 0 : errno;
  _close(descriptor);
  return error;
}

void give_back_memory() {
  _heapmin();
}

}  // namespace feedscope
