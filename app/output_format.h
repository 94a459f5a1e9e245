#pragma once

#include <string>
#include <vector>

namespace feedscope {

/// The format of --out: `asked` by --format, else the ending of `out` in any case; the first of `known` for
/// standard output. Throws InputError naming `out` and the supported endings.
std::string output_format(const std::string& out, const std::string& asked,
                          const std::vector<std::string>& known);

/// Whether `out` has the ending of page files that only the window requests (ui::RecordedPages).
bool asks_for_pages(const std::string& out);

}  // namespace feedscope
