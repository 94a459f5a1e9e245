#pragma once

#include <string>
#include <vector>

namespace feedscope {

/// A paragraph, list item or line of code of a Markdown text, without its marks.
struct PlainBlock {
  std::string marker;      ///< "- " or "2. " of a list item's first paragraph
  std::size_t indent = 0;  ///< of what is inside lists
  std::string text;        ///< one line; of code each line as it is
  bool code = false;
  bool follows = false;  ///< no empty line between it and the block before: items of a list, lines of code
};

/// A Markdown text (CommonMark) for a terminal: emphasis and code lose their marks, links keep their text.
std::vector<PlainBlock> plain_blocks(const std::string& markdown);
/// All of it in one line.
std::string plain_line(const std::string& markdown);

}  // namespace feedscope
