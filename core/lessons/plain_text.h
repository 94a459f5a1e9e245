#pragma once

#include <string>
#include <vector>

namespace feedscope {

/// A paragraph, list item or line of code of a Markdown text, without markup.
struct PlainBlock {
  std::string marker;      ///< "- " or "2. " of a list item's first paragraph
  std::size_t indent = 0;  ///< within lists
  std::string text;        ///< one line; code as it is
  bool code = false;
  bool follows = false;  ///< no empty line before it: items of a list, lines of code
};

/// Converts a Markdown text (CommonMark) for a terminal: removes markup of emphasis and code, keeps the text
/// of links.
std::vector<PlainBlock> plain_blocks(const std::string& markdown);
/// The whole text in one line.
std::string plain_line(const std::string& markdown);

}  // namespace feedscope
