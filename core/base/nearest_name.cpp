#include "core/base/nearest_name.h"

#include <algorithm>
#include <utility>

namespace feedscope {
namespace {

std::string lower_case(std::string_view text) {
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return lower;
}

struct EditDistances {
  std::size_t whole;   ///< to the whole candidate
  std::size_t prefix;  ///< to its closest prefix
};

EditDistances edit_distances(std::string_view word, std::string_view candidate) {
  std::vector<std::size_t> row(candidate.size() + 1);
  for (std::size_t j = 0; j < row.size(); ++j) {
    row[j] = j;
  }
  std::vector<std::size_t> above = row;
  for (std::size_t i = 0; i < word.size(); ++i) {
    const std::vector<std::size_t> before_above = std::exchange(above, row);
    row[0] = i + 1;
    for (std::size_t j = 0; j < candidate.size(); ++j) {
      const std::size_t changed = above[j] + (word[i] == candidate[j] ? 0 : 1);
      row[j + 1] = std::min({changed, row[j] + 1, above[j + 1] + 1});
      if (i > 0 && j > 0 && word[i] == candidate[j - 1] && word[i - 1] == candidate[j]) {
        row[j + 1] = std::min(row[j + 1], before_above[j - 1] + 1);
      }
    }
  }
  return {row.back(), *std::min_element(row.begin(), row.end())};
}

}  // namespace

std::string nearest_name(std::string_view word, const std::vector<std::string>& candidates) {
  const std::string wanted = lower_case(word);
  const std::size_t near = wanted.size() / 3;
  std::string best;
  EditDistances least{0, near + 1};
  for (const std::string& candidate : candidates) {
    const std::string name = lower_case(candidate);
    EditDistances d = edit_distances(wanted, name);
    if (d.prefix > 0 && !name.starts_with(wanted.substr(0, 1))) {
      d.prefix = d.whole;
    }
    if (d.prefix < least.prefix || (d.prefix == least.prefix && !best.empty() && d.whole < least.whole)) {
      best = candidate;
      least = d;
    }
  }
  return wanted.empty() ? "" : best;
}

}  // namespace feedscope
