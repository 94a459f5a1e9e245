#include "core/program/path/coordinate_frame.h"

#include <Eigen/LU>
#include <cmath>

namespace feedscope {

CoordinateFrame::CoordinateFrame(const Eigen::Matrix3d& linear, const Vec3& origin)
    : linear_(linear),
      inverse_(linear.inverse()),
      origin_(origin),
      shift_only_(linear == Eigen::Matrix3d::Identity()),
      mirrors_(linear.determinant() < 0),
      identity_(shift_only_ && origin == Vec3::Zero()) {}

CoordinateFrame CoordinateFrame::shift(const Vec3& by) {
  return {Eigen::Matrix3d::Identity(), by};
}

CoordinateFrame CoordinateFrame::rotation(const Vec3& axis, double angle, const Vec3& center) {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(angle, axis).toRotationMatrix();
  return {turn, center - turn * center};
}

CoordinateFrame CoordinateFrame::scale(const Vec3& factors, const Vec3& center) {
  return {factors.asDiagonal(), center - factors.cwiseProduct(center)};
}

CoordinateFrame CoordinateFrame::operator*(const CoordinateFrame& inner) const {
  if (shift_only_ && inner.shift_only_) {
    return shift(origin_ + inner.origin_);
  }
  return {linear_ * inner.linear_, to_shown(inner.origin_)};
}

double CoordinateFrame::scale_across(const Vec3& normal) const {
  constexpr double same = 1e-9;
  const Vec3 first = linear_ * normal.unitOrthogonal();
  const Vec3 second = linear_ * normal.cross(normal.unitOrthogonal());
  const Vec3 along = linear_ * normal;
  const double size = first.norm();
  const bool even = std::abs(second.norm() - size) <= same * size &&
                    std::abs(first.dot(second)) <= same * size * size &&
                    std::abs(along.dot(first)) <= same * size * along.norm() &&
                    std::abs(along.dot(second)) <= same * size * along.norm();
  return even ? size : 0;
}

}  // namespace feedscope
