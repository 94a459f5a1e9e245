#include "ui/charts/column_cache.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace feedscope::ui {

namespace {

constexpr double same_width = 1e-9;   // of a column
constexpr double same_border = 0.02;  // of a column; invisible

}  // namespace

void ColumnCache::clear() {
  times_.clear();
  bands_.clear();
}

/// Number of columns by which the range has moved; `count` or more if none can be kept.
int ColumnCache::shift_to(const Interval& range, int count) const {
  if (bands_.size() != static_cast<std::size_t>(count) ||
      std::abs(range.width() / count - width_) > same_width * width_) {
    return count;
  }
  const double shift = (range.lower - start_) / width_;
  const double whole = std::round(shift);
  return std::abs(shift - whole) <= same_border && std::abs(whole) < count ? static_cast<int>(whole) : count;
}

void ColumnCache::update(const Envelope& envelope, double end, const Interval& range, int count,
                         const TimeAt& time_at, bool rapids) {
  update(
      [&envelope, end, rapids](std::span<const double> times) {
        std::vector<Band> bands = rapids ? envelope.columns(times) : envelope.cutting_columns(times);
        for (std::size_t i = bands.size(); i > 0 && times[i - 1] >= end && times[i] > end; --i) {
          bands[i - 1] = Band();
        }
        return bands;
      },
      range, count, time_at);
}

void ColumnCache::update(const BandsOf& bands_of, const Interval& range, int count, const TimeAt& time_at) {
  const int shift = shift_to(range, count);
  if (shift == 0) {
    return;
  }
  const bool keep = std::abs(shift) < count;
  if (!keep) {
    width_ = range.width() / count;
    start_ = range.lower;
    times_.resize(static_cast<std::size_t>(count) + 1);
    bands_.resize(static_cast<std::size_t>(count));
  } else {
    start_ += shift * width_;
    if (shift > 0) {
      std::move(times_.begin() + shift, times_.end(), times_.begin());
      std::move(bands_.begin() + shift, bands_.end(), bands_.begin());
    } else {
      std::move_backward(times_.begin(), times_.end() + shift, times_.end());
      std::move_backward(bands_.begin(), bands_.end() + shift, bands_.end());
    }
  }
  const int first = keep && shift > 0 ? count - shift : 0;
  const int last = keep && shift < 0 ? -shift : count;
  for (int i = first; i <= last; ++i) {
    times_[static_cast<std::size_t>(i)] = time_at(start_ + i * width_);
  }
  const auto borders =
      std::span(times_).subspan(static_cast<std::size_t>(first), static_cast<std::size_t>(last - first) + 1);
  std::ranges::copy(bands_of(borders), bands_.begin() + first);
}

}  // namespace feedscope::ui
