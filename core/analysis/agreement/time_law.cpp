#include "core/analysis/agreement/time_law.h"

#include <algorithm>
#include <cmath>

namespace feedscope {

TimeLaw::TimeLaw(const std::vector<double>& time, const MatchedRecord& matched) {
  std::size_t last = 0;
  for (std::size_t i = matched.first; i < matched.end; ++i) {
    const double s = matched.s[i];
    if (std::isnan(s)) {
      continue;
    }
    if (!s_.empty() && s <= s_.back()) {
      distance_.back() = std::max(distance_.back(), matched.distance[i]);
      last = i;
      continue;
    }
    // The motion stood still until the previous sample: it continues from then, not from its arrival.
    if (!s_.empty() && time[last] > t_.back()) {
      s_.push_back(s_.back());
      t_.push_back(time[last]);
      distance_.push_back(distance_.back());
    }
    s_.push_back(s);
    t_.push_back(time[i]);
    distance_.push_back(matched.distance[i]);
    last = i;
  }
}

double TimeLaw::at(double s) const {
  const auto found = std::lower_bound(s_.begin(), s_.end(), s);
  if (found == s_.end()) {
    return t_.back();
  }
  const auto i = static_cast<std::size_t>(found - s_.begin());
  if (i == 0 || *found == s) {
    return t_[i];
  }
  return t_[i - 1] + (t_[i] - t_[i - 1]) * (s - s_[i - 1]) / (s_[i] - s_[i - 1]);
}

double TimeLaw::at(double s, double share, double near) const {
  double from = at(s);
  double pause = 0;
  auto i = static_cast<std::size_t>(std::ranges::lower_bound(s_, s - near) - s_.begin());
  for (; i + 1 < s_.size() && s_[i] <= s + near; ++i) {
    if (s_[i + 1] == s_[i] && t_[i + 1] - t_[i] > pause) {
      from = t_[i];
      pause = t_[i + 1] - t_[i];
    }
  }
  return from + share * pause;
}

TimeLaw::Place TimeLaw::place_at(double time) const {
  const auto found = std::ranges::lower_bound(t_, time);
  if (found == t_.end()) {
    return {s_.back(), 0};
  }
  const auto i = static_cast<std::size_t>(found - t_.begin());
  if (i == 0) {
    return {s_.front(), 0};
  }
  const double share = (time - t_[i - 1]) / (t_[i] - t_[i - 1]);
  return s_[i] == s_[i - 1] ? Place{s_[i], share} : Place{s_[i - 1] + share * (s_[i] - s_[i - 1]), 0};
}

TimeLaw::Farthest TimeLaw::farthest(double from, double to) const {
  Farthest found{from, 0};
  auto i = static_cast<std::size_t>(std::ranges::lower_bound(s_, from) - s_.begin());
  for (; i < s_.size() && s_[i] <= to; ++i) {
    if (const auto distance = static_cast<double>(distance_[i]); distance > found.distance) {
      found = {s_[i], distance};
    }
  }
  return found;
}

double TimeLaw::distance(double from, double to) const {
  return farthest(from, to).distance;
}

double TimeLaw::distance_at(double s) const {
  const auto found = std::ranges::lower_bound(s_, s);
  if (found == s_.end()) {
    return static_cast<double>(distance_.back());
  }
  const auto i = static_cast<std::size_t>(found - s_.begin());
  const auto here = static_cast<double>(distance_[i]);
  if (i == 0 || s_[i] == s) {
    return here;
  }
  const auto before = static_cast<double>(distance_[i - 1]);
  return before + (here - before) * (s - s_[i - 1]) / (s_[i] - s_[i - 1]);
}

}  // namespace feedscope
