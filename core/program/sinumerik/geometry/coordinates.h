#pragma once

#include <cstdint>
#include <map>

#include "core/program/sinumerik/context.h"
#include "core/program/sinumerik/geometry/frame_value.h"
#include "core/program/sinumerik/geometry/frames.h"
#include "core/program/sinumerik/geometry/splines.h"
#include "core/program/sinumerik/geometry/targets.h"

namespace feedscope::sinumerik {

/// Frames and work offsets: TRANS, ROT, SCALE, MIRROR and their additive forms, G58, G59, G54 to G599, the
/// plane of CYCLE800, and frame variables. Changes the path's frame at once.
class Coordinates : private Part {
 public:
  /// All outlive it. Work offsets of ReadOptions are settable frames from the start.
  Coordinates(Context& context, Targets& targets, Splines& splines);

  /// Runs the frame function of the block (BlockFunctions::own_block), if it has one.
  void run();
  /// G54 to G599: selects the frame of this number from the program or ReadOptions, else none.
  void select_work_offset(int g, std::uint32_t column);
  /// Sets the swivelled plane or, if `additive`, one more inside it.
  void swivel(const CoordinateFrame& plane, bool additive);

  /// $P_PFRAME.
  CoordinateFrame programmed() const { return modes_.frames.programmed(); }
  void set_programmed(const CoordinateFrame& frame);
  /// Coordinate of the coarse or `fine` shift of the programmable frame [mm].
  void set_programmed_shift(int axis, double value, bool fine);
  /// $P_UIFR by number, G54 is 1; takes effect with its G word.
  FrameValue settable(int number) const;
  void set_settable(int number, const FrameValue& value) { settable_[number] = value; }
  /// $P_IFRAME, the settable frame in force.
  const FrameValue& settable_in_force() const { return in_force_; }
  void set_settable_in_force(const FrameValue& value);

  /// Modal state.
  struct Modes {
    int work_offset = 0;  ///< G number; 0: none yet
    Frames frames;
  };
  const Modes& modes() const { return modes_; }
  void restore(const Modes& modes);

 private:
  void use_given_offsets();
  void set_frame();
  Vec3 values(double missing) const;
  Vec3 shift() const { return values(0) * to_mm(1); }
  Vec3 angles() const;
  CoordinateFrame scale() const;
  CoordinateFrame mirror() const;

  Targets& targets_;
  Splines& splines_;
  Modes modes_;
  std::map<int, FrameValue> settable_;  ///< given, by number
  FrameValue in_force_;
};

}  // namespace feedscope::sinumerik
