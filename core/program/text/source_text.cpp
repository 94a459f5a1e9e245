#include "core/program/text/source_text.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <limits>
#include <memory>
#include <system_error>

#include "core/base/error.h"
#include "core/base/this_process.h"

namespace feedscope {

namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
constexpr std::size_t size_limit = std::numeric_limits<std::uint32_t>::max();

/// Offset of every line. LF, CR LF, CR CR LF (from a text-mode copy) and CR alone end a line.
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
    throw InputError(message(NC_("core", "{}: is larger than 4 GiB; split the program"), name));
  }
}

constexpr bool is_noise(char c) {
  return (static_cast<unsigned char>(c) < ' ' && c != '\t' && c != '\n' && c != '\r') || c == '\x7F';
}

[[noreturn]] void refuse(const std::string& name, const Message& reason) {
  throw InputError(
      message(NC_("core", "{}: is not a text file ({}); give an NC program as ASCII, UTF-8 or Latin-1 text"),
              name, reason));
}

/// Replaces control characters by blanks. Throws InputError if there are too many for a text between the
/// first and the last printed one, that is without the leader and trailer of a tape.
std::size_t clear_noise(const std::string& name, std::string& text) {
  constexpr std::size_t always_allowed = 16;
  constexpr std::size_t one_in = 200;
  constexpr std::size_t run = 64;
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) {
    refuse(name, NC_("core", "it is UTF-16"));
  }
  const auto printed = [](char c) { return c > ' ' && c != '\x7F'; };
  const auto first = std::find_if(text.begin(), text.end(), printed);
  const auto last = std::find_if(text.rbegin(), text.rend(), printed).base();
  std::size_t inside = 0;
  std::size_t count = 0;
  for (std::size_t at = 0; at < text.size(); at += run) {
    const auto begin = text.begin() + static_cast<std::ptrdiff_t>(at);
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(at + run, text.size()));
    const auto found = std::count_if(begin, end, is_noise);
    if (found > 0) {
      count += static_cast<std::size_t>(found);
      inside +=
          begin < last && end > first
              ? static_cast<std::size_t>(std::count_if(std::max(begin, first), std::min(end, last), is_noise))
              : 0;
      std::replace_if(begin, end, is_noise, ' ');
    }
  }
  if (inside > always_allowed + text.size() / one_in || (count > always_allowed && first == text.end())) {
    refuse(name, message(NC_("core", "it has {} control characters"), count));
  }
  return count;
}

/// True if every non-ASCII byte belongs to a UTF-8 sequence of two to four bytes.
bool is_utf8(std::string_view text) {
  constexpr std::uint64_t beyond_ascii = 0x8080808080808080;
  std::size_t left = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    std::uint64_t eight = beyond_ascii;
    if (left == 0 && i + sizeof eight <= text.size()) {
      std::memcpy(&eight, text.data() + i, sizeof eight);
    }
    if ((eight & beyond_ascii) == 0) {
      i += sizeof eight - 1;
      continue;
    }
    const auto byte = static_cast<unsigned char>(text[i]);
    const bool continues = byte >= 0x80 && byte < 0xC0;
    if (continues != (left > 0)) {
      return false;
    }
    if (left > 0) {
      --left;
    } else if (byte >= 0xC0) {
      left = byte < 0xE0 ? 1 : byte < 0xF0 ? 2 : 3;
      if (byte < 0xC2 || byte > 0xF4) {
        return false;
      }
    }
  }
  return left == 0;
}

/// Reads to the end; `expected` bytes at once if known, else in growing pieces.
std::string read_all(std::FILE* file, const std::string& name, std::size_t expected) {
  std::string text;
  std::size_t used = 0;
  constexpr std::ptrdiff_t piece_looked_at = 4096;
  std::size_t piece = expected > 0 ? expected + 1 : std::size_t{1} << 20;
  while (true) {
    text.resize(used + piece);
    errno = 0;
    const std::size_t count = std::fread(text.data() + used, 1, piece, file);
    const auto begin = text.begin() + static_cast<std::ptrdiff_t>(used);
    used += count;
    check_size(name, used);
    if (count < piece) {
      break;
    }
    if (std::all_of(begin, begin + piece_looked_at, is_noise)) {
      refuse(name, NC_("core", "the rest is control characters only"));
    }
    piece = used;
  }
  if (std::ferror(file) != 0) {
    throw InputError(message(NC_("core", "{}: cannot be read: {}"), name,
                             reason_of(std::error_code(errno, std::generic_category()))));
  }
  text.resize(used);
  return text;
}

}  // namespace

SourceText::SourceText(std::string name, std::string text) : name_(std::move(name)), text_(std::move(text)) {
  check_size(name_, text_.size());
  noise_count_ = clear_noise(name_, text_);
  const std::string_view view = text_;
  encoding_ = is_utf8(view) ? Encoding::utf8 : Encoding::latin1;
  starts_ = line_starts(view, view.starts_with(byte_order_mark) ? byte_order_mark.size() : 0);
  for (std::size_t i = 0; i < starts_.size(); ++i) {
    const std::size_t end = i + 1 < starts_.size() ? starts_[i + 1] : text_.size();
    if (end - starts_[i] > longest_line) {
      throw InputError(message(NC_("core",
                                   "{}:{}: the line is {} bytes long, more than the {} of any NC program; "
                                   "check the file's line ends"),
                               name_, i + 1, end - starts_[i], longest_line));
    }
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
    throw InputError(message(NC_("core", "{}: does not exist; check the path"), name));
  }
  if (std::filesystem::is_directory(status)) {
    throw InputError(message(NC_("core", "{}: is a directory; give the NC program inside it"), name));
  }
  errno = 0;
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(open_to_read(path), &std::fclose);
  if (!file) {
    throw InputError(message(NC_("core", "{}: cannot be opened: {}"), name,
                             reason_of(std::error_code(errno, std::generic_category()))));
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

std::string SourceText::to_utf8(std::string_view part) const {
  if (encoding_ == Encoding::utf8) {
    return std::string(part);
  }
  std::string out;
  out.reserve(part.size());
  for (const char c : part) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80) {
      out += c;
    } else {
      out += static_cast<char>(0xC0 | byte >> 6);
      out += static_cast<char>(0x80 | (byte & 0x3F));
    }
  }
  return out;
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
