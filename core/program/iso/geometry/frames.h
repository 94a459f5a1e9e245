#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>

#include "core/base/geometry.h"
#include "core/program/path/coordinate_frame.h"
#include "core/program/path/plane.h"

namespace feedscope::iso {

/// Shifts, rotation, scales and mirror images of an ISO program, and their combined frame. They apply to a
/// point in the controls' order: mirror image, scale, rotation, G52 and G92, rotation of the work offset,
/// work offset. Everything that the program does not set is zero.
class Frames {
 public:
  static constexpr int first_work_offset = 540;  ///< key of G54
  /// Keys of G54 to G59 and G59.1 to G59.3.
  static constexpr std::array work_offset_keys{540, 550, 560, 570, 580, 590, 591, 592, 593};
  /// Key of G54.1 Pn.
  static constexpr int further_work_offset(int n) { return 10000 + n; }
  /// "G55", "G54.1 P3".
  static std::string name_of(int key);

  struct WorkOffset {
    Vec3 shift = Vec3::Zero();  ///< [mm]
    double angle = 0;           ///< about Z [rad]
    std::array<bool, 3> set{};  ///< by the program, as coordinates of the machine
    bool operator==(const WorkOffset&) const = default;
  };

  CoordinateFrame frame() const { return rotated() * inner(); }
  /// Frame of the offsets and shifts alone.
  CoordinateFrame offsets() const;
  /// The same with the turns in space.
  CoordinateFrame tilted() const { return offsets() * tilt_; }
  /// The same with the rotations of G68 and G68.2.
  CoordinateFrame rotated() const;

  /// Work offset in all coordinates [mm]; nullptr if the program has not set it.
  const WorkOffset* work_offset(int key) const;
  /// Zero point of a work offset [mm]; none if the program has not set it.
  std::optional<Vec3> zero_of(int key) const;
  const WorkOffset& work_offset_in_force() const { return in_force_; }
  int key_in_force() const { return key_; }
  void set_work_offset(int key, const WorkOffset& offset);
  void select_work_offset(int key);

  /// G52 [mm].
  const Vec3& local_shift() const { return local_; }
  void set_local_shift(const Vec3& shift) { local_ = shift; }
  /// G92, and G52 of LinuxCNC, which share one value [mm].
  const Vec3& preset() const { return preset_; }
  void set_preset(const Vec3& shift) {
    preset_ = shift;
    preset_on_ = true;
  }
  /// G92: the programmed `from` gets the coordinates `to` [mm].
  void set_position(const Vec3& from, const Vec3& to);
  /// G92.1 deletes it; G92.2 omits it; G92.3 brings it into force again.
  void forget_position();
  void hold_position() { preset_on_ = false; }
  void restore_position() { preset_on_ = true; }

  /// G68 [rad]; about `center` in the coordinates of the work offset [mm].
  void rotate(Plane plane, const Vec3& center, double angle);
  /// Angle in force; 0: none.
  double angle() const { return rotation_ ? rotation_->angle : 0; }
  void end_rotation() {
    rotation_.reset();
    tilt_ = {};
  }
  /// Turns in space, after those in force.
  void tilt(const CoordinateFrame& frame) { tilt_ = tilt_ * frame; }
  /// G51: no factor may be zero.
  void scale(const Vec3& center, const Vec3& factors) { scale_ = Scale{center, factors}; }
  void end_scale() { scale_.reset(); }
  /// G51.1, G50.1.
  void mirror(int axis, double at) { mirror_[static_cast<std::size_t>(axis)] = at; }
  void end_mirror(int axis) { mirror_[static_cast<std::size_t>(axis)].reset(); }

 private:
  struct Rotation {
    Plane plane = Plane::xy;
    Vec3 center;
    double angle = 0;
  };
  struct Scale {
    Vec3 center;
    Vec3 factors;
  };

  /// Mirror image and scale.
  CoordinateFrame inner() const;

  std::map<int, WorkOffset> work_offsets_;
  int key_ = first_work_offset;
  WorkOffset in_force_;
  Vec3 local_ = Vec3::Zero();
  Vec3 preset_ = Vec3::Zero();
  bool preset_on_ = true;
  CoordinateFrame tilt_;
  std::optional<Rotation> rotation_;
  std::optional<Scale> scale_;
  std::array<std::optional<double>, 3> mirror_;
};

}  // namespace feedscope::iso
