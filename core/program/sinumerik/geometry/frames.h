#pragma once

#include "core/base/geometry.h"
#include "core/program/path/coordinate_frame.h"

namespace feedscope::sinumerik {

/// Frames of a program: the settable ones with values from the program itself, inside them the swivelled
/// plane of CYCLE800, and inside this the frame of TRANS, ROT, SCALE, MIRROR and their additive forms. Other
/// work offsets are zero.
class Frames {
 public:
  /// All of them, one after the other.
  CoordinateFrame frame() const;
  /// Frame of TRANS, ROT, SCALE, MIRROR and their additive forms alone.
  CoordinateFrame programmed() const { return CoordinateFrame::shift(coarse_ + fine_) * chain_; }

  /// TRANS, ROT, SCALE, MIRROR: replaces the previous programmable frame.
  void replace(const CoordinateFrame& by);
  /// ATRANS, AROT, ASCALE, AMIRROR: adds inside the previous programmable frame.
  void add(const CoordinateFrame& more) { chain_ = chain_ * more; }
  /// G58, G59: coordinate of the coarse or the `fine` shift.
  void set_shift(int axis, double value, bool fine) { (fine ? fine_ : coarse_)[axis] = value; }
  /// G54 to G599.
  void set_settable(const CoordinateFrame& by) { settable_ = by; }
  /// CYCLE800.
  void set_swivel(const CoordinateFrame& by) { swivel_ = by; }
  const CoordinateFrame& swivel() const { return swivel_; }

 private:
  CoordinateFrame settable_;
  CoordinateFrame swivel_;
  Vec3 coarse_ = Vec3::Zero();
  Vec3 fine_ = Vec3::Zero();
  CoordinateFrame chain_;
};

/// Rotation about Z, then the turned Y, then the turned X, angles in rad: order of several angles in ROT.
CoordinateFrame turned_about(const Vec3& angles);

}  // namespace feedscope::sinumerik
