#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace feedscope {

/// Candidate nearest to `word` by edit distance, or ""; a match of a prefix only requires the same first
/// letter.
std::string nearest_name(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace feedscope
