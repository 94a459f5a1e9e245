#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace feedscope::ui {

/// The text literals of a C++ source, as the compiler joins them; those of #include lines and comments are
/// not among them. Raw literals are not known.
std::vector<std::string> source_literals(const std::filesystem::path& file);

}  // namespace feedscope::ui
