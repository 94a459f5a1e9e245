#pragma once

#include <array>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "core/analysis/cause_times.h"
#include "core/base/progress.h"
#include "core/trajectory/part_walk.h"
#include "core/trajectory/quantity.h"

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

/// Extents of all charted quantities over one stretch of time, in inside units.
struct Band {
  std::array<Extent, charted_count> extents;  ///< from first_charted on

  const Extent& operator[](QuantityId id) const { return extents[index(id)]; }
  Extent& operator[](QuantityId id) { return extents[index(id)]; }
  static constexpr std::size_t index(QuantityId id) {
    return static_cast<std::size_t>(id) - static_cast<std::size_t>(first_charted);
  }
  void add(const Band& other);
  void add(const State& state);
};

/// Level of detail of a trajectory for charts: the least and the largest value in every pixel column.
///
/// A pyramid of extents over groups of motion pieces, about 37 bytes a piece, built once in linear time. A
/// column then costs a logarithmic walk of the pyramid plus the pieces of the two groups that its borders
/// cut, whatever the length of the program. A cut group that lasts less than 1/8 of the column counts as a
/// whole, so a column may show what happens that much beyond its borders, never less than what is in it.
/// Extremes on straight elements are exact; arcs are sampled every 5 degrees, blends the closer the sharper
/// they turn: within 2 % of the largest value for turns up to 150 degrees.
class Envelope {
 public:
  Envelope() = default;
  /// Throws Cancelled if `progress` is cancelled.
  explicit Envelope(std::shared_ptr<const Trajectory> trajectory, Progress* progress = nullptr);

  /// One band for each pair of neighbours in `times` [s], ascending. Columns outside the trajectory are
  /// empty.
  std::vector<Band> columns(std::span<const double> times) const;
  /// The band of the whole trajectory; empty for an empty trajectory.
  Band overall() const;
  /// The band of everything except rapids.
  const Band& cutting() const { return cutting_; }
  const CauseTimes& causes() const { return causes_; }

 private:
  Band column(double from, double to) const;
  double group_duration(std::size_t group) const;
  void add_piece(Band& band, std::size_t piece, double from, double to) const;
  void add_pieces(Band& band, std::size_t first, std::size_t last, double from, double to) const;
  void add_groups(Band& band, std::size_t first, std::size_t last) const;
  void add_part(Band& band, const Part& part, const PartMotion& motion, double duration) const;
  int inner_samples(const Part& part, const ElementCurve& curve, double duration) const;

  std::shared_ptr<const Trajectory> trajectory_;
  CauseTimes causes_;
  Band cutting_;
  std::vector<std::vector<Band>> levels_;  ///< [0]: one band a group of pieces; each next level merges a few
};

}  // namespace feedscope
