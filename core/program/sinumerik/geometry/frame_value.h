#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "core/base/geometry.h"
#include "core/program/path/coordinate_frame.h"

namespace feedscope::sinumerik {

/// Value of a frame variable: shift, rotation, scale and mirror image, in this order from outside
/// (Programming Manual NC, 3.8.2). A chain of several frames no longer has these parts.
class FrameValue {
 public:
  enum class Part { shift, fine_shift, angle, scale, mirror };

  FrameValue() = default;
  explicit FrameValue(const CoordinateFrame& chain) : chain_(chain) {}

  /// TR, FI, RT, SC, MI.
  static std::optional<Part> part(std::string_view name);
  /// Sets a part of an axis, 0 to 2: lengths [mm], angles [rad], a factor other than zero, other than zero
  /// for a mirror image. False, with nothing set, for a chain.
  bool set(Part part, int axis, double value);

  CoordinateFrame frame() const;

  std::array<bool, 3> set_by_program{};  ///< axes with a zero point in machine coordinates

 private:
  Vec3 shift_ = Vec3::Zero();
  Vec3 fine_shift_ = Vec3::Zero();
  Vec3 angles_ = Vec3::Zero();
  Vec3 factors_ = Vec3::Ones();
  Vec3 mirror_ = Vec3::Ones();  ///< 1 or -1
  std::optional<CoordinateFrame> chain_;
};

}  // namespace feedscope::sinumerik
