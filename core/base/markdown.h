#pragma once

#include <string>
#include <string_view>

namespace feedscope {

/// Converts a Markdown text to the HTML inside a body. CommonMark, and tables of lines "| a | b |" whose
/// second line is "|---|---|"; cells cannot contain bars.
std::string markdown_as_html(std::string_view markdown);

}  // namespace feedscope
