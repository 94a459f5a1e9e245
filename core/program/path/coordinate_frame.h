#pragma once

#include "core/base/geometry.h"

namespace feedscope {

/// Map from programmed to shown coordinates: shown = linear * programmed + origin. Shifts, rotations, mirror
/// images and scales of all dialects combine into one.
class CoordinateFrame {
 public:
  CoordinateFrame() = default;

  static CoordinateFrame shift(const Vec3& by);
  /// Turns by `angle` [rad] about `axis` (unit) through `center`.
  static CoordinateFrame rotation(const Vec3& axis, double angle, const Vec3& center = Vec3::Zero());
  /// Factors per axis about `center`; -1 mirrors. A factor must not be zero.
  static CoordinateFrame scale(const Vec3& factors, const Vec3& center = Vec3::Zero());

  /// Applies `inner` first, then this one.
  CoordinateFrame operator*(const CoordinateFrame& inner) const;

  Vec3 to_shown(const Vec3& programmed) const { return linear_ * programmed + origin_; }
  Vec3 to_programmed(const Vec3& shown) const { return inverse_ * (shown - origin_); }
  /// Transforms a direction or distance.
  Vec3 turned(const Vec3& v) const { return linear_ * v; }

  /// True if the shown coordinate depends on the programmed one, axes 0 to 2, and the other way round.
  bool is_shown_by(int shown, int programmed) const { return linear_(shown, programmed) != 0; }
  bool is_programmed_by(int programmed, int shown) const { return inverse_(programmed, shown) != 0; }

  bool is_identity() const { return identity_; }
  bool is_shift() const { return shift_only_; }
  bool mirrors() const { return mirrors_; }
  /// Factor by which all lengths in the plane across `normal` grow, so that arcs stay arcs and helices
  /// helices; 0 if there is none.
  double scale_across(const Vec3& normal) const;

 private:
  CoordinateFrame(const Eigen::Matrix3d& linear, const Vec3& origin);

  Eigen::Matrix3d linear_ = Eigen::Matrix3d::Identity();
  Eigen::Matrix3d inverse_ = Eigen::Matrix3d::Identity();
  Vec3 origin_ = Vec3::Zero();
  bool shift_only_ = true;
  bool mirrors_ = false;
  bool identity_ = true;
};

}  // namespace feedscope
