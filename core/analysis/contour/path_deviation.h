#pragma once

#include <cstdint>
#include <memory>

#include "core/toolpath/toolpath.h"

namespace feedscope {

class SegmentTree;

/// Contour error of a place: its distance from the nearest point of the whole programmed path, including
/// rapids.
///
/// Where a path comes near itself, the nearest point may belong to another pass than the one under way: the
/// error is then the distance from that pass. It is the error measured on a part, not the distance of the
/// tool from its commanded position.
///
/// The nearest point is that of an exhaustive search over all segments, within `as_near`; a query costs
/// logarithmic time in the number of segments. Copyable and thread-safe.
class PathDeviation {
 public:
  /// Difference up to which two points are equally near, so that the one on the current segment counts [mm].
  static constexpr double as_near = 1e-9;

  /// `toolpath` must outlive this and its copies.
  explicit PathDeviation(const Toolpath& toolpath);

  /// The programmed point nearest to a place.
  struct Foot {
    std::size_t segment = 0;
    double s = 0;                ///< from the segment's start [mm]
    Vec3 offset = Vec3::Zero();  ///< from the foot to the place [mm]
    double squared = 0;          ///< squared length of the offset [mm2]
  };

  /// Nearest point of one segment.
  Foot foot_on(std::size_t segment, const Vec3& position) const;
  /// Nearest point in passing a place while `segment` is under way: on the path no farther from the nearest
  /// point of that segment than twice its distance, so that another pass does not count.
  Foot foot_near(std::size_t segment, const Vec3& position) const;
  /// Nearest point of the whole path. `segment`: the one under way; `also`: another one that may be near,
  /// such as the previous result. Both only speed up the search. The toolpath must have segments.
  Foot nearest(const Vec3& position, std::size_t segment, std::size_t also) const;

  /// Vectors from the programmed path to a place [mm].
  struct Result {
    Vec3 nearest = Vec3::Zero();  ///< from the nearest programmed point
    /// Offset to enlarge when a deviation is drawn: in a corner along its bisector, whose direction is
    /// constant through the corner.
    Vec3 along_bisector = Vec3::Zero();
  };

  /// Deviation of `position` from the programmed path while `segment` is under way. Fastest for places in
  /// order.
  Result operator()(const Vec3& position, std::uint32_t segment);
  /// Deviation for a foot found otherwise.
  Result from_foot(const Foot& foot) const { return {foot.offset, along_bisector(foot)}; }

 private:
  struct Index;

  void improve(Foot& best, std::size_t segment, const Vec3& position) const;
  Vec3 along_bisector(const Foot& foot) const;

  const Toolpath& toolpath_;
  std::shared_ptr<Index> index_;  ///< shared by all copies, built on first use
  std::size_t last_ = 0;          ///< segment of the previous foot
};

}  // namespace feedscope
