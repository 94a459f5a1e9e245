#pragma once

#include <string>
#include <string_view>

namespace feedscope {

/// A Markdown text (CommonMark) as HTML: the inside of a body.
std::string markdown_as_html(std::string_view markdown);

}  // namespace feedscope
