#include "tests/ui/language/source_literals.h"

#include <algorithm>
#include <fstream>
#include <iterator>

namespace feedscope::ui {

namespace {

/// Reads on from `at`, the opening quotation mark, which moves behind the closing one.
std::string read_quoted(const std::string& source, std::size_t& at) {
  const char mark = source[at];
  std::string text;
  for (++at; at < source.size() && source[at] != mark; ++at) {
    if (source[at] == '\\' && at + 1 < source.size()) {
      ++at;
      text += source[at] == 'n' ? '\n' : source[at] == 't' ? '\t' : source[at];
    } else {
      text += source[at];
    }
  }
  ++at;
  return text;
}

bool is_blank(char c) {
  return c == ' ' || c == '\n' || c == '\t';
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

}  // namespace

std::vector<std::string> source_literals(const std::filesystem::path& file) {
  std::ifstream in(file);
  const std::string source{std::istreambuf_iterator<char>(in), {}};
  std::vector<std::string> literals;
  bool joins = false;  // nothing but blanks since the last one
  for (std::size_t at = 0; at < source.size();) {
    const char c = source[at];
    if (source.compare(at, 2, "//") == 0 || c == '#') {
      at = std::min(source.find('\n', at), source.size());
    } else if (source.compare(at, 2, "/*") == 0) {
      at = std::min(source.find("*/", at), source.size() - 2) + 2;
    } else if (c == '\'' && at > 0 && is_digit(source[at - 1])) {
      ++at;  // 1'000
    } else if (c == '\'') {
      read_quoted(source, at);
      joins = false;
    } else if (c == '"') {
      const std::string text = read_quoted(source, at);
      if (joins) {
        literals.back() += text;
      } else {
        literals.push_back(text);
      }
      joins = true;
    } else {
      joins = joins && is_blank(c);
      ++at;
    }
  }
  return literals;
}

}  // namespace feedscope::ui
