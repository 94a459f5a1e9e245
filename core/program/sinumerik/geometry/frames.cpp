#include "core/program/sinumerik/geometry/frames.h"

namespace feedscope::sinumerik {

CoordinateFrame Frames::frame() const {
  return settable_ * swivel_ * programmed();
}

void Frames::replace(const CoordinateFrame& by) {
  coarse_.setZero();
  fine_.setZero();
  chain_ = by;
  if (by.is_shift()) {
    coarse_ = by.to_shown(Vec3::Zero());
    chain_ = {};
  }
}

CoordinateFrame turned_about(const Vec3& angles) {
  return CoordinateFrame::rotation(Vec3::UnitZ(), angles.z()) *
         CoordinateFrame::rotation(Vec3::UnitY(), angles.y()) *
         CoordinateFrame::rotation(Vec3::UnitX(), angles.x());
}

}  // namespace feedscope::sinumerik
