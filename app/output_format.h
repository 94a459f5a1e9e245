#pragma once

#include <string>
#include <vector>

namespace feedscope {

/// What is written to --out: `asked` by --format, else by the ending of `out` in any case; the first of
/// `known` for standard output. Throws InputError naming `out` and the endings that can be written.
std::string output_format(const std::string& out, const std::string& asked,
                          const std::vector<std::string>& known);

/// Whether `out` ends as files of pages that the window prints (ui::RecordedPages): it asks for them, people
/// do not.
bool asks_for_pages(const std::string& out);

}  // namespace feedscope
