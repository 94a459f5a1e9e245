#include "core/analysis/study/heading.h"

#include <algorithm>
#include <cctype>
#include <string>

namespace feedscope {
namespace {

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r';
}
bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) {
    text.remove_prefix(1);
  }
  while (!text.empty() && is_blank(text.back())) {
    text.remove_suffix(1);
  }
  return text;
}

/// Removes "N120 ...", "120 ..." and "/" at the start of a line.
std::string_view without_number(std::string_view text) {
  text = trimmed(text);
  if (!text.empty() && text.front() == '/') {
    text = trimmed(text.substr(1));
  }
  std::size_t digits = !text.empty() && (text.front() == 'N' || text.front() == 'n') ? 1 : 0;
  const std::size_t begin = digits;
  while (digits < text.size() && is_digit(text[digits])) {
    ++digits;
  }
  return digits > begin ? trimmed(text.substr(digits)) : text;
}

bool has_letter(std::string_view text) {
  return std::ranges::any_of(text, [](char c) {
    return std::isalpha(static_cast<unsigned char>(c)) != 0 || static_cast<unsigned char>(c) >= 0x80;
  });
}

bool is_rule(char c) {
  return std::string_view("-=*#_~+<>").find(c) != std::string_view::npos;
}

/// Length of the decoration at the start of `text`, read from first to last: at least two rule characters, or
/// a single one that is separate. A character that belongs to a word ("-X side", "#1") does not count.
template <class Iterator>
std::ptrdiff_t decoration(Iterator first, Iterator last) {
  const auto end = std::find_if_not(first, last, is_rule);
  const std::ptrdiff_t count = end - first;
  const bool alone = end == last || is_blank(*end);
  return count > 1 || alone ? count : 0;
}

/// A title without surrounding dashes and stars, with single blanks: "--- Operation   1 ---" is "Operation
/// 1".
std::string undecorated(std::string_view text) {
  text = trimmed(text);
  text.remove_prefix(static_cast<std::size_t>(decoration(text.begin(), text.end())));
  text.remove_suffix(static_cast<std::size_t>(decoration(text.rbegin(), text.rend())));
  std::string title;
  for (const char c : trimmed(text)) {
    if (!is_blank(c)) {
      title += c;
    } else if (title.back() != ' ') {
      title += ' ';
    }
  }
  return title;
}

/// Text after the comma of a comment that LinuxCNC displays, as "(MSG, change the tool)"; other comments
/// unchanged.
std::string_view without_command(std::string_view comment) {
  const std::size_t comma = comment.find(',');
  std::string word(trimmed(comment.substr(0, comma)));
  std::ranges::transform(word, word.begin(), [](unsigned char c) { return std::tolower(c); });
  const bool shows = comma != std::string_view::npos && (word == "msg" || word == "debug" || word == "print");
  return shows ? comment.substr(comma + 1) : comment;
}

/// Content of a comment line; none for a line with anything else.
std::optional<std::string_view> comment_of(std::string_view text) {
  if (text.starts_with(';')) {
    return text.substr(1);
  }
  if (text.starts_with('*')) {  // structure block of Heidenhain
    text = trimmed(text.substr(1));
    return text.starts_with('-') ? text.substr(1) : text;
  }
  if (text.starts_with('(') && text.find(')') == text.size() - 1) {
    return without_command(text.substr(1, text.size() - 2));
  }
  constexpr std::string_view message = "MSG(\"";
  if (text.size() > message.size() + 1 && text.starts_with(message) && text.ends_with("\")")) {
    return text.substr(message.size(), text.size() - message.size() - 2);
  }
  return std::nullopt;
}

/// The line in capitals, without comments.
std::string code_of(std::string_view line) {
  std::string code;
  int depth = 0;
  for (const char c : line) {
    if (c == ';') {
      break;
    }
    depth += c == '(' ? 1 : 0;
    if (depth == 0) {
      code += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    }
    depth -= c == ')' && depth > 0 ? 1 : 0;
  }
  return code;
}

/// Number or quoted name at the start of `text`, after blanks and "="; "" if there is none.
std::string name_at(std::string_view text) {
  while (!text.empty() && (is_blank(text.front()) || text.front() == '=')) {
    text.remove_prefix(1);
  }
  if (!text.empty() && text.front() == '"') {
    return std::string(text.substr(1, std::min(text.find('"', 1), text.size()) - 1));
  }
  std::size_t digits = 0;
  while (digits < text.size() && is_digit(text[digits])) {
    ++digits;
  }
  std::string_view number = text.substr(0, digits);
  while (number.size() > 1 && number.front() == '0') {
    number.remove_prefix(1);
  }
  return std::string(number);
}

/// Whether a word may begin at `at`: no letter before it.
bool begins_word(std::string_view code, std::size_t at) {
  return at == 0 || std::isalpha(static_cast<unsigned char>(code[at - 1])) == 0;
}

}  // namespace

ToolWords tool_words(std::string_view line) {
  const std::string code = code_of(line);
  ToolWords words;
  constexpr std::string_view call = "TOOL CALL";
  if (const std::size_t at = code.find(call); at != std::string::npos) {
    words.tool = name_at(std::string_view(code).substr(at + call.size()));
    words.comes_in = !words.tool.empty();
    return words;
  }
  for (std::size_t i = 0; i + 1 < code.size(); ++i) {
    if (!begins_word(code, i)) {
      continue;
    }
    const std::string_view rest = std::string_view(code).substr(i + 1);
    if (code[i] == 'T') {
      std::string name = name_at(rest);
      words.tool = name.empty() ? words.tool : std::move(name);
    } else if (code[i] == 'M') {
      words.comes_in = words.comes_in || name_at(rest) == "6";
    }
  }
  return words;
}

std::optional<std::string> operation_heading(std::string_view line) {
  const auto comment = comment_of(without_number(line));
  if (!comment) {
    return std::nullopt;
  }
  return has_letter(*comment) ? undecorated(*comment) : std::string();
}

}  // namespace feedscope
