#include "ui/film/frame_pattern.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "core/base/error.h"

namespace feedscope::ui {

FramePattern::FramePattern(const std::string& pattern) {
  const auto refuse = [&](const char* what) {
    throw InputError(
        fmt::format("--film '{}': {}; give frames a name such as frames/%05d.png", pattern, what));
  };
  const std::size_t name = pattern.find_last_of('/') + 1;  // 0 without a folder
  const std::size_t at = pattern.find('%');
  if (at == std::string::npos) {
    refuse("a series of pictures needs a number in its name");
  }
  if (at < name) {
    refuse("the number belongs in the name of the files, not in that of a folder");
  }
  std::size_t end = at + 1;
  zeros_ = end < pattern.size() && pattern[end] == '0';
  for (; end < pattern.size() && std::isdigit(static_cast<unsigned char>(pattern[end])) != 0; ++end) {
    width_ = std::min<std::size_t>(width_ * 10 + static_cast<std::size_t>(pattern[end] - '0'), 100);
  }
  constexpr std::size_t most_digits = 20;
  if (end >= pattern.size() || pattern[end] != 'd' || width_ > most_digits) {
    refuse("'%' must be followed by d, or by a width of up to 20 and d");
  }
  if (pattern.find('%', end) != std::string::npos) {
    refuse("its name has two numbers");
  }
  before_ = pattern.substr(0, at);
  after_ = pattern.substr(end + 1);
}

std::string FramePattern::file(std::size_t k) const {
  const std::string number = std::to_string(k);
  const std::size_t fill = width_ > number.size() ? width_ - number.size() : 0;
  return before_ + std::string(fill, zeros_ ? '0' : ' ') + number + after_;
}

}  // namespace feedscope::ui
