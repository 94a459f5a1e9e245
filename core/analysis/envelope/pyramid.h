#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace feedscope {

/// Bands of consecutive groups, and of increasing numbers of them together: the band of any range of groups
/// costs a logarithmic number of additions.
template <typename Band>
class Pyramid {
 public:
  Pyramid() = default;
  explicit Pyramid(std::vector<Band> groups) {
    while (groups.size() > fan_out) {
      std::vector<Band> merged((groups.size() + fan_out - 1) / fan_out);
      for (std::size_t i = 0; i < groups.size(); ++i) {
        merged[i / fan_out].add(groups[i]);
      }
      levels_.push_back(std::exchange(groups, std::move(merged)));
    }
    levels_.push_back(std::move(groups));
  }

  bool empty() const { return levels_.empty() || levels_.front().empty(); }
  Band overall() const {
    Band band;
    if (!levels_.empty()) {
      for (const Band& part : levels_.back()) {
        band.add(part);
      }
    }
    return band;
  }
  /// Adds groups [first, end).
  void add(Band& band, std::size_t first, std::size_t end) const {
    for (std::size_t level = 0; first < end; ++level) {
      const std::vector<Band>& bands = levels_[level];
      const bool top = level + 1 == levels_.size();
      while (first < end && (top || first % fan_out != 0)) {
        band.add(bands[first++]);
      }
      while (first < end && end % fan_out != 0) {
        band.add(bands[--end]);
      }
      first /= fan_out;
      end /= fan_out;
    }
  }

 private:
  static constexpr std::size_t fan_out = 4;
  std::vector<std::vector<Band>> levels_;  ///< [0]: one band per group; each next level merges a few
};

}  // namespace feedscope
