#pragma once

#include <array>
#include <limits>

#include "core/analysis/run/quantity.h"

namespace feedscope {

/// Smallest and largest value seen; empty until one is added.
struct Extent {
  float min = std::numeric_limits<float>::infinity();
  float max = -std::numeric_limits<float>::infinity();

  bool empty() const { return !(min <= max); }
  void add(float value) {
    min = value < min ? value : min;
    max = value > max ? value : max;
  }
  void add(const Extent& other) {
    min = other.min < min ? other.min : min;
    max = other.max > max ? other.max : max;
  }
};

/// Extents of several values over one stretch of time.
template <std::size_t count>
struct Extents {
  std::array<Extent, count> extents;

  void add(const Extents& other) {
    for (std::size_t i = 0; i < count; ++i) {
      extents[i].add(other.extents[i]);
    }
  }
};

/// Extents of one source's charted quantities, in their order and in internal units.
template <const ChartedRange& range>
struct SourceBand : Extents<range.count> {
  /// Extent of a quantity in the range.
  const Extent& operator[](QuantityId id) const { return this->extents[charted_index(id) - range.index]; }
  using Extents<range.count>::add;
  void add(const Instant& instant) {
    for (std::size_t i = 0; i < range.count; ++i) {
      const auto id = static_cast<QuantityId>(static_cast<std::size_t>(range.first) + i);
      this->extents[i].add(static_cast<float>(info_of(id).of(instant)));
    }
  }
};
using MotionBand = SourceBand<charted_of_motion>;
using DriveBand = SourceBand<charted_of_drives>;
using LoadBand = SourceBand<charted_of_load>;
using RotaryBand = SourceBand<charted_of_rotary>;

/// Extents of all charted quantities, in internal units; empty for quantities that a run does not have.
struct Band : Extents<charted_count> {
  const Extent& operator[](QuantityId id) const { return extents[charted_index(id)]; }
  Extent& operator[](QuantityId id) { return extents[charted_index(id)]; }

  using Extents::add;
  template <const ChartedRange& range>
  void add(const SourceBand<range>& band) {
    for (std::size_t i = 0; i < range.count; ++i) {
      extents[range.index + i].add(band.extents[i]);
    }
  }
};

}  // namespace feedscope
