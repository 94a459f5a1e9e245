#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/program/path/coordinate_frame.h"
#include "core/program/path/plane.h"

namespace feedscope::heidenhain {

/// Cycles 7, 8, 10, 11, 19, 26 and PLANE in force. A transformation that is programmed again keeps its place,
/// one that is reset loses it; each acts in the coordinates made by the earlier ones.
class Transformations {
 public:
  enum class Kind : std::uint8_t { shift, mirror, rotation, scale, tilt };

  /// Coordinate of the datum on one axis, absolute or added to the one in force [mm].
  void shift(int axis, double value, bool incremental);
  void mirror(const std::array<bool, 3>& axes);
  /// About the plane's normal [rad].
  void rotate(Plane plane, double angle, bool incremental);
  /// Factors about a centre [mm].
  void scale(const Vec3& factors, const Vec3& center = Vec3::Zero());
  /// Tilts the working plane; a tilt in force is replaced in its place.
  void tilt(const CoordinateFrame& tilt) { step(Kind::tilt).tilt = tilt; }
  void reset(Kind kind);

  Vec3 shift() const;
  /// The identity for none.
  CoordinateFrame tilt() const;
  /// True if the plane is tilted about a datum that was shifted before.
  bool has_shift_under_tilt() const;

  CoordinateFrame frame() const;

 private:
  struct Step {
    Kind kind = Kind::shift;
    Vec3 values = Vec3::Zero();  ///< shift, factors
    Vec3 center = Vec3::Zero();
    Plane plane = Plane::xy;
    double angle = 0;
    CoordinateFrame tilt;
  };

  Step& step(Kind kind);
  const Step* find(Kind kind) const;

  std::vector<Step> steps_;
};

}  // namespace feedscope::heidenhain
