#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/trajectory/part_walk.h"
#include "ui/charts/cause_times.h"

namespace feedscope::ui {

/// What a chart can show of a trajectory: feeds [mm/s], accelerations [mm/s2], jerks [mm/s3].
enum class Channel : std::uint8_t {
  programmed_feed,
  feed,
  velocity_x,
  velocity_y,
  velocity_z,
  tangential_acceleration,
  acceleration_x,
  acceleration_y,
  acceleration_z,
  tangential_jerk,
  jerk_x,
  jerk_y,
  jerk_z,
};
inline constexpr std::size_t channel_count = 13;

/// Value of a channel in a state, in the core's units.
double channel_value(const State& state, Channel channel);

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

/// Extents of all channels over one stretch of time.
struct Band {
  std::array<Extent, channel_count> channels;

  const Extent& operator[](Channel channel) const { return channels[static_cast<std::size_t>(channel)]; }
  void add(const Band& other);
  void add(const State& state);
};

/// Level of detail of a trajectory for charts: the least and the largest value in every pixel column.
///
/// A pyramid of extents over groups of motion pieces, about 35 bytes a piece, built once in linear time. A
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

}  // namespace feedscope::ui
