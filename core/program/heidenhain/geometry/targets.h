#pragma once

#include <cstdint>

#include "core/program/heidenhain/geometry/feeds.h"

namespace feedscope::heidenhain {

/// Both axes of the plane, one bit each.
std::uint8_t bits_of(Plane plane);

/// Targets of the words of a block, in Cartesian coordinates or from the pole, and the elements of the
/// contour that end there.
class Targets : private Part {
 public:
  /// All outlive it.
  Targets(Context& context, const Feeds& feeds) : Part(context), feeds_(feeds) {}

  Vec3 of(const MotionWords& words) const;
  /// Target from the pole, which is known.
  Vec3 polar(const MotionWords& words);
  /// Returns false, with a report, if no pole is known.
  bool has_pole(std::uint32_t column) const;
  /// CC, I J K.
  void set_pole(const MotionWords& words);

  /// A line to `target` with the feed, side and tool in force.
  ContourElement element(const MotionWords& words, const Vec3& target) const;

  /// Notes the axes with which the block has moved.
  void note_programmed_axes(const MotionWords& words);
  /// True if the program has given an absolute coordinate of `axis` (0 to 2) before.
  bool was_programmed(int axis) const { return (programmed_axes_ >> axis & 1) != 0; }

 private:
  const Feeds& feeds_;
  double last_polar_angle_ = 0;
  std::uint8_t programmed_axes_ = 0;  ///< one bit each
};

}  // namespace feedscope::heidenhain
