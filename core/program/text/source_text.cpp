#include "core/program/text/source_text.h"

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

/// Offset of every line. LF, CR LF, CR CR LF (left behind by a text-mode copy) and CR alone end a line.
std::vector<std::uint32_t> line_starts(std::string_view text, std::size_t at) {
  const auto find = [text](char c, std::size_t from, std::size_t to) {
    const void* const found = from < to ? std::memchr(text.data() + from, c, to - from) : nullptr;
    return found == nullptr ? to : static_cast<std::size_t>(static_cast<const char*>(found) - text.data());
  };
  const bool has_returns = find('\r', 0, text.size()) < text.size();
  std::vector<std::uint32_t> starts;
  std::size_t feed = find('\n', at, text.size());
  while (at < text.size()) {
    starts.push_back(static_cast<std::uint32_t>(at));
    if (feed < at) {
      feed = find('\n', at, text.size());
    }
    const std::size_t first_return = has_returns ? find('\r', at, feed) : feed;
    const bool return_alone = first_return + 2 < feed ||
                              (first_return + 2 == feed && text[feed - 1] != '\r') ||
                              (first_return < feed && feed == text.size());
    at = return_alone ? first_return + 1 : feed + 1;
  }
  return starts;
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
  starts_ = line_starts(view, view.starts_with(byte_order_mark) ? byte_order_mark.size() : 0);
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
  SourceText source(name, read_all(file.get(), name, size));
  source.folder_ = std::filesystem::absolute(path).parent_path();
  return source;
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
