#include "ui/charts/run_overlay.h"

#include <algorithm>

namespace feedscope::ui {

namespace {

struct Stretch {
  double begin = 0;
  double end = 0;
};

/// Number of the first element that belongs to `segment` or a later one.
std::size_t first_element(const BlendedPath& path, std::uint64_t segment) {
  std::size_t low = 0;
  std::size_t high = path.size();
  while (low < high) {
    const std::size_t middle = low + (high - low) / 2;
    if (path.segment(middle) < segment) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low;
}

Stretch stretch_of(const BlendedPath& path, std::uint32_t segment) {
  return {path.s(first_element(path, segment)), path.s(first_element(path, std::uint64_t{segment} + 1))};
}

}  // namespace

double same_place(const BlendedPath& from, double s, const BlendedPath& to) {
  if (from.empty() || to.empty()) {
    return 0;
  }
  const std::uint32_t segment = from.segment(from.element_at(std::clamp(s, 0.0, from.length())));
  const Stretch here = stretch_of(from, segment);
  const Stretch there = stretch_of(to, segment);
  const double share =
      here.end > here.begin ? std::clamp((s - here.begin) / (here.end - here.begin), 0.0, 1.0) : 0.0;
  return there.begin + share * (there.end - there.begin);
}

}  // namespace feedscope::ui
