#pragma once

#include <cstdint>

#include "core/toolpath/toolpath.h"

namespace feedscope {

/// Contour error of places that follow a programmed path one after the other, as an executed path does.
///
/// The nearest programmed point is looked for around the one found before, no farther along the path than
/// the executed path can have gone meanwhile: a pass beside it does not count, however near. All places
/// together cost time in the order of places and segments.
class PathDeviation {
 public:
  /// `toolpath` must outlive this.
  explicit PathDeviation(const Toolpath& toolpath) : toolpath_(toolpath) {}

  /// Of the programmed points the one that is nearest to a place.
  struct Foot {
    std::size_t segment = 0;
    double s = 0;                ///< from the segment's start [mm]
    Vec3 offset = Vec3::Zero();  ///< from the foot to the place [mm]
    double squared = 0;          ///< length of the offset squared [mm2]
  };

  /// The nearest point of one segment.
  Foot foot_on(std::size_t segment, const Vec3& position) const;
  /// The foot of `position`, which lies `advance` of executed path away from the place of foot `from` [mm];
  /// `segment`: as below. The toolpath has segments.
  Foot follow(const Foot& from, const Vec3& position, double advance, std::uint32_t segment) const;

  /// Vectors to a place from the programmed path [mm].
  struct Result {
    Vec3 nearest = Vec3::Zero();  ///< from the nearest programmed point
    /// As far from the path, but in a corner along its bisector, which does not turn on the way through it:
    /// what is to be enlarged when the deviation is drawn larger than it is.
    Vec3 along_bisector = Vec3::Zero();
  };

  /// How far `position` is from the programmed path. `advance`: executed path length since the
  /// call before [mm]; `segment`: the segment of the toolpath that the position belongs to, or one near it.
  Result operator()(const Vec3& position, double advance, std::uint32_t segment);

  /// The next call follows on `position`, which belongs to `segment`.
  void begin(const Vec3& position, std::uint32_t segment) { last_ = foot_on(segment, position); }

 private:
  void improve(Foot& best, std::size_t segment, const Vec3& position) const;
  void search(Foot& best, const Foot& from, double reach, const Vec3& position) const;

  Vec3 along_bisector(const Foot& foot) const;

  const Toolpath& toolpath_;
  Foot last_;
};

}  // namespace feedscope
