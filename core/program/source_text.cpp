#include "core/program/source_text.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <limits>
#include <memory>
#include <system_error>

#include "core/base/error.h"

namespace feedscope {

namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
constexpr std::size_t size_limit = std::numeric_limits<std::uint32_t>::max();

/// Offset of the next line's first byte; the end of the text if there is none.
std::size_t next_line(std::string_view text, std::size_t from, bool has_returns) {
  if (!has_returns) {
    const std::size_t feed = text.find('\n', from);
    return feed == std::string_view::npos ? text.size() : feed + 1;
  }
  const std::size_t end = text.find_first_of("\r\n", from);
  if (end == std::string_view::npos) {
    return text.size();
  }
  // Returns in front of a line feed belong to it; a return alone ends a line.
  const std::size_t feed = text.find_first_not_of('\r', end);
  return feed != std::string_view::npos && text[feed] == '\n' ? feed + 1 : end + 1;
}

void check_size(const std::string& name, std::size_t size) {
  if (size > size_limit) {
    throw InputError(fmt::format("{}: is larger than 4 GiB; split the program", name));
  }
}

/// Reads to the end; `expected` bytes at once if known, else in growing pieces.
std::string read_all(std::FILE* file, const std::string& name, std::size_t expected) {
  std::string text;
  std::size_t used = 0;
  std::size_t piece = expected > 0 ? expected + 1 : std::size_t{1} << 20;
  while (true) {
    text.resize(used + piece);
    errno = 0;
    const std::size_t count = std::fread(text.data() + used, 1, piece, file);
    if (std::memchr(text.data() + used, '\0', count) != nullptr) {
      throw InputError(fmt::format(
          "{}: is not a text file (it holds a zero byte); give an NC program as plain ASCII or UTF-8 text",
          name));
    }
    used += count;
    check_size(name, used);
    if (count < piece) {
      break;
    }
    piece = used;
  }
  if (std::ferror(file) != 0) {
    throw InputError(fmt::format("{}: cannot be read: {}", name, std::generic_category().message(errno)));
  }
  text.resize(used);
  return text;
}

}  // namespace

SourceText::SourceText(std::string name, std::string text) : name_(std::move(name)), text_(std::move(text)) {
  check_size(name_, text_.size());
  const std::string_view view = text_;
  const bool has_returns = view.find('\r') != std::string_view::npos;
  std::size_t at = view.substr(0, byte_order_mark.size()) == byte_order_mark ? byte_order_mark.size() : 0;
  while (at < view.size()) {
    starts_.push_back(static_cast<std::uint32_t>(at));
    at = next_line(view, at, has_returns);
  }
}

SourceText SourceText::from_file(const std::filesystem::path& path) {
  if (path == "-") {
    return {"standard input", read_all(stdin, "standard input", 0)};
  }
  const std::string name = path.string();
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) {
    throw InputError(fmt::format("{}: there is no such file; check the path", name));
  }
  if (std::filesystem::is_directory(status)) {
    throw InputError(fmt::format("{}: is a directory; give the NC program inside it", name));
  }
  errno = 0;
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(name.c_str(), "rb"), &std::fclose);
  if (!file) {
    throw InputError(fmt::format("{}: cannot be opened: {}", name, std::generic_category().message(errno)));
  }
  std::size_t size = 0;
  if (std::filesystem::is_regular_file(status)) {
    const auto bytes = std::filesystem::file_size(path, error);
    size = error ? 0 : static_cast<std::size_t>(bytes);
  }
  check_size(name, size);
  return {name, read_all(file.get(), name, size)};
}

std::string_view SourceText::line(std::uint32_t number) const {
  if (number == 0 || number > starts_.size()) {
    return {};
  }
  const std::size_t start = starts_[number - 1];
  std::size_t end = number < starts_.size() ? starts_[number] : text_.size();
  while (end > start && (text_[end - 1] == '\n' || text_[end - 1] == '\r')) {
    --end;
  }
  return std::string_view(text_).substr(start, end - start);
}

}  // namespace feedscope
