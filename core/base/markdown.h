#pragma once

#include <string>
#include <string_view>

namespace feedscope {

/// A Markdown text as HTML: the inside of a body. CommonMark, and tables of lines "| a | b |" whose second
/// line is "|---|---|"; a cell has no bar in it. The index of a symbol is set low: K_v, but not in code.
std::string markdown_as_html(std::string_view markdown);

}  // namespace feedscope
