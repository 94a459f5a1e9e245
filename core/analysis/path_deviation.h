#pragma once

#include <cstdint>
#include <memory>

#include "core/toolpath/toolpath.h"

namespace feedscope {

class SegmentTree;

/// Contour error of a place: its distance from the nearest point of the whole programmed path, rapids
/// included.
///
/// Where a path comes near itself the nearest point may belong to another pass than the one under way: a
/// place that strays towards a neighbouring pass is no farther from the contour than from that pass. So the
/// error is what is measured on a part, not how far the tool is from where it was sent.
///
/// The nearest point is the same as a look at every segment would give, to `as_near`; a query costs time in
/// the order of the logarithm of the segments. May be copied, and asked by several threads.
class PathDeviation {
 public:
  /// Where two points are that equally near the one of the segment under way counts [mm].
  static constexpr double as_near = 1e-9;

  /// `toolpath` must outlive this and its copies.
  explicit PathDeviation(const Toolpath& toolpath);

  /// Of the programmed points the one that is nearest to a place.
  struct Foot {
    std::size_t segment = 0;
    double s = 0;                ///< from the segment's start [mm]
    Vec3 offset = Vec3::Zero();  ///< from the foot to the place [mm]
    double squared = 0;          ///< length of the offset squared [mm2]
  };

  /// The nearest point of one segment.
  Foot foot_on(std::size_t segment, const Vec3& position) const;
  /// The nearest point on the way past a place while `segment` is under way: of the path no farther from the
  /// nearest point of that segment than twice its distance, so that another pass does not count.
  Foot foot_near(std::size_t segment, const Vec3& position) const;
  /// The nearest point of the whole path. `segment`: the one under way; `also`: another one that may be near,
  /// as that of the place before: both only make it quicker. The toolpath has segments.
  Foot nearest(const Vec3& position, std::size_t segment, std::size_t also) const;

  /// Vectors to a place from the programmed path [mm].
  struct Result {
    Vec3 nearest = Vec3::Zero();  ///< from the nearest programmed point
    /// As far from the path, but in a corner along its bisector, which does not turn on the way through it:
    /// what is to be enlarged when the deviation is drawn larger than it is.
    Vec3 along_bisector = Vec3::Zero();
  };

  /// How far `position` is from the programmed path, while `segment` is under way. Quickest for places in
  /// order.
  Result operator()(const Vec3& position, std::uint32_t segment);
  /// Of a foot that was found otherwise.
  Result from_foot(const Foot& foot) const { return {foot.offset, along_bisector(foot)}; }

 private:
  struct Index;

  void improve(Foot& best, std::size_t segment, const Vec3& position) const;
  Vec3 along_bisector(const Foot& foot) const;

  const Toolpath& toolpath_;
  std::shared_ptr<Index> index_;  ///< of all copies, made when first asked for
  std::size_t last_ = 0;          ///< segment of the foot of the place before
};

}  // namespace feedscope
