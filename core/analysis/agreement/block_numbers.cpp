#include "core/analysis/agreement/block_numbers.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>

namespace feedscope {
namespace {

std::optional<std::uint32_t> number_of(std::string_view line) {
  const auto skip = [&](std::string_view what) {
    line.remove_prefix(std::min(line.find_first_not_of(what), line.size()));
  };
  skip(" \t");
  if (line.starts_with('/')) {  // optional block skip, with its level
    skip("/0123456789 \t");
  }
  const bool is_marked = line.starts_with('N') || line.starts_with('n') || line.starts_with(':');
  line.remove_prefix(is_marked ? 1 : 0);
  std::uint32_t number = 0;
  const auto [end, failure] = std::from_chars(line.data(), line.data() + line.size(), number);
  const bool ends = end == line.data() + line.size() || *end == ' ' || *end == '\t';
  return failure == std::errc() && number > 0 && (is_marked || ends) ? std::optional(number) : std::nullopt;
}

}  // namespace

BlockNumbers::BlockNumbers(const SourceText& source) {
  for (std::uint32_t line = 1; line <= source.line_count(); ++line) {
    if (const auto number = number_of(source.line(line))) {
      lines_.emplace_back(*number, line);
    }
  }
  std::ranges::sort(lines_);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> once;
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const bool again = (i > 0 && lines_[i - 1].first == lines_[i].first) ||
                       (i + 1 < lines_.size() && lines_[i + 1].first == lines_[i].first);
    if (!again) {
      once.push_back(lines_[i]);
    }
  }
  lines_ = std::move(once);
}

std::uint32_t BlockNumbers::line_of(std::uint32_t number) const {
  const auto found =
      std::ranges::lower_bound(lines_, number, {}, &std::pair<std::uint32_t, std::uint32_t>::first);
  return found != lines_.end() && found->first == number ? found->second : 0;
}

std::vector<std::uint32_t> BlockNumbers::lines_of(const std::vector<std::uint32_t>& numbers) const {
  std::vector<std::uint32_t> lines;
  lines.reserve(numbers.size());
  std::uint32_t before = 0;
  std::uint32_t line = 0;
  for (const std::uint32_t number : numbers) {
    if (number != before) {
      line = line_of(number);
      before = number;
    }
    lines.push_back(line);
  }
  return lines;
}

}  // namespace feedscope
