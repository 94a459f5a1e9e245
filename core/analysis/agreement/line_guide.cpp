#include "core/analysis/agreement/line_guide.h"

#include <algorithm>
#include <tuple>
#include <vector>

namespace feedscope {

LineGuide::LineGuide(const ProgrammedCourse& course, const std::vector<std::uint32_t>& lines,
                     const std::vector<double>& time)
    : lines_(lines), time_(time) {
  if (lines.empty() || !(course.length() > 0)) {
    return;
  }
  constexpr double most = 0.8;
  std::vector<std::uint32_t> run;  // lines, in order
  for (std::uint32_t segment = 0; segment < course.segments(); ++segment) {
    const double from = course.start_of(segment);
    const double to = course.start_of(segment + 1);
    const std::uint32_t line = course.line_of(segment);
    run.push_back(line);
    if (!(to > from)) {
      continue;
    }
    if (!stretches_.empty() && stretches_.back().line == line && stretches_.back().to == from) {
      stretches_.back().to = to;
    } else {
      stretches_.push_back({line, from, to});
    }
  }
  std::ranges::stable_sort(stretches_, {}, &Stretch::line);
  std::ranges::sort(run);
  std::size_t given = 0;
  std::size_t known = 0;
  std::uint32_t before = 0;
  bool is_known = false;
  for (const std::uint32_t line : lines) {
    if (line != before) {
      is_known = std::ranges::binary_search(run, line);
      before = line;
    }
    given += line > 0 ? 1 : 0;
    known += line > 0 && is_known ? 1 : 0;
  }
  usable_ = known > 0 && static_cast<double>(known) >= most * static_cast<double>(given);
}

const LineGuide::Stretch* LineGuide::first_of(std::uint32_t line, double s) const {
  const auto key = [](const Stretch& stretch) { return std::tuple(stretch.line, stretch.to); };
  const auto found = std::ranges::lower_bound(stretches_, std::tuple(line, s), {}, key);
  return found != stretches_.end() && found->line == line ? &*found : nullptr;
}

LineGuide::Range LineGuide::range(std::size_t i, double s) const {
  constexpr double around = 0.1;  // [s]
  const auto here = time_.begin() + static_cast<std::ptrdiff_t>(i);
  const auto before = std::lower_bound(time_.begin(), here, *here - around) - time_.begin();
  const auto behind = std::upper_bound(here, time_.end(), *here + around) - time_.begin() - 1;
  Range range;
  const Stretch* first = first_of(lines_[static_cast<std::size_t>(before)], s);
  if (first != nullptr) {
    range.from = first->from;
  }
  const Stretch* last =
      first_of(lines_[static_cast<std::size_t>(behind)], first != nullptr ? first->from : s);
  if (last != nullptr) {
    range.to = last->to;
  }
  return range;
}

}  // namespace feedscope
