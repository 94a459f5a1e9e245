#include "core/program/sinumerik/frames.h"

namespace feedscope::sinumerik {

CoordinateFrame Frames::frame() const {
  return swivel_ * CoordinateFrame::shift(coarse_ + fine_) * chain_;
}

void Frames::replace(const CoordinateFrame& by) {
  coarse_.setZero();
  fine_.setZero();
  chain_ = by;
}

void Frames::replace_shift(const Vec3& by) {
  replace({});
  coarse_ = by;
}

CoordinateFrame turned_about(const Vec3& angles) {
  return CoordinateFrame::rotation(Vec3::UnitZ(), angles.z()) *
         CoordinateFrame::rotation(Vec3::UnitY(), angles.y()) *
         CoordinateFrame::rotation(Vec3::UnitX(), angles.x());
}

}  // namespace feedscope::sinumerik
