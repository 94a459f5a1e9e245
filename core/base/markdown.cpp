#include "core/base/markdown.h"

#include <cmark.h>

#include <cstdlib>
#include <memory>

namespace feedscope {

std::string markdown_as_html(std::string_view markdown) {
  const std::unique_ptr<char, void (*)(void*)> html(
      cmark_markdown_to_html(markdown.data(), markdown.size(), CMARK_OPT_DEFAULT), std::free);
  return html.get();
}

}  // namespace feedscope
