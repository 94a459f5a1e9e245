#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace feedscope {

/// Place of a line in a control's configuration.
struct ConfigurationPlace {
  std::uint32_t line = 0;  ///< 1-based; 0: the file as a whole
  std::string file = {};   ///< as it was included; empty: the imported file
};

struct ConfigurationLine {
  std::string_view text;     ///< without surrounding blanks
  std::uint32_t number = 0;  ///< 1-based
  bool indented = false;     ///< begins with a blank
};

/// Bytes of a file as UTF-8: from UTF-16 if it has the mark; invalid UTF-8 is read as Latin-1.
std::string utf8_text(std::string_view bytes);
/// Lines of a text with any line ending, without a byte order mark.
std::vector<ConfigurationLine> lines_of(std::string_view text);
std::string_view without_blanks(std::string_view text);
std::string in_upper_case(std::string_view text);
/// Words between blanks.
std::vector<std::string_view> words_of_line(std::string_view text);

}  // namespace feedscope
