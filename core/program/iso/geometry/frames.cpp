#include "core/program/iso/geometry/frames.h"

#include <fmt/format.h>

#include "core/program/text/message.h"

namespace feedscope::iso {

std::string Frames::name_of(int key) {
  constexpr int further = further_work_offset(0);
  return key > further ? fmt::format("G54.1 P{}", key - further) : g_name(key);
}

CoordinateFrame Frames::inner() const {
  CoordinateFrame frame;
  for (int axis = 0; axis < 3; ++axis) {
    if (const std::optional<double>& at = mirror_[static_cast<std::size_t>(axis)]) {
      Vec3 factors = Vec3::Ones();
      factors[axis] = -1;
      frame = CoordinateFrame::scale(factors, *at * Vec3::Unit(axis)) * frame;
    }
  }
  if (scale_) {
    frame = CoordinateFrame::scale(scale_->factors, scale_->center) * frame;
  }
  return frame;
}

CoordinateFrame Frames::rotated() const {
  return rotation_ ? tilted() * CoordinateFrame::rotation(normal_of(rotation_->plane), rotation_->angle,
                                                          rotation_->center)
                   : tilted();
}

CoordinateFrame Frames::offsets() const {
  const Vec3 shift = local_ + (preset_on_ ? preset_ : Vec3(Vec3::Zero()));
  CoordinateFrame outer = CoordinateFrame::shift(shift);
  if (in_force_.angle != 0) {
    outer = CoordinateFrame::rotation(Vec3::UnitZ(), in_force_.angle) * outer;
  }
  return CoordinateFrame::shift(in_force_.shift) * outer;
}

const Frames::WorkOffset* Frames::work_offset(int key) const {
  const auto found = work_offsets_.find(key);
  return found == work_offsets_.end() ? nullptr : &found->second;
}

std::optional<Vec3> Frames::zero_of(int key) const {
  const WorkOffset* offset = work_offset(key);
  return offset == nullptr ? std::nullopt : std::optional(offset->shift);
}

void Frames::set_work_offset(int key, const WorkOffset& offset) {
  work_offsets_[key] = offset;
  if (key == key_) {
    in_force_ = offset;
  }
}

void Frames::select_work_offset(int key) {
  key_ = key;
  const WorkOffset* const known = work_offset(key);
  in_force_ = known == nullptr ? WorkOffset{} : *known;
}

void Frames::set_position(const Vec3& from, const Vec3& to) {
  const CoordinateFrame outside = offsets();
  const CoordinateFrame whole = frame();
  preset_ = (preset_on_ ? preset_ : Vec3(Vec3::Zero())) + outside.to_programmed(whole.to_shown(from)) -
            outside.to_programmed(whole.to_shown(to));
  preset_on_ = true;
}

void Frames::forget_position() {
  preset_ = Vec3::Zero();
  preset_on_ = true;
}

void Frames::rotate(Plane plane, const Vec3& center, double angle) {
  rotation_ = Rotation{plane, center, angle};
}

}  // namespace feedscope::iso
