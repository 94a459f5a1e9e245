#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace feedscope {

/// Where a line of a control's configuration stands.
struct ConfigurationPlace {
  std::uint32_t line = 0;  ///< 1-based; 0: the file as a whole
  std::string file = {};   ///< as it was included; empty: the file that is imported
};

struct ConfigurationLine {
  std::string_view text;     ///< without blanks around it
  std::uint32_t number = 0;  ///< 1-based
  bool indented = false;     ///< begins with a blank
};

/// The bytes of a file as UTF-8: UTF-16 by its mark, else bytes that are no UTF-8 as Latin-1.
std::string utf8_text(std::string_view bytes);
/// Lines of a text, whatever ends them; a mark of the byte order is not part of the first.
std::vector<ConfigurationLine> lines_of(std::string_view text);
std::string_view without_blanks(std::string_view text);
std::string in_upper_case(std::string_view text);
/// Words between blanks.
std::vector<std::string_view> words_of_line(std::string_view text);

}  // namespace feedscope
