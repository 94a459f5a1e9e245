#pragma once

#include <cstdint>

#include "core/base/units.h"
#include "core/program/path/plane.h"

namespace feedscope::iso {

/// What the motion words of a block without a motion G word mean.
enum class MotionMode : std::uint8_t {
  none,     ///< no motion G word yet, or a cycle cancelled
  rapid,    ///< G0
  line,     ///< G1
  arc_cw,   ///< G2
  arc_ccw,  ///< G3
  cycle,    ///< G73 to G89
  spline,   ///< G5, G5.1, G5.2, G6.2
  unread,   ///< not supported, as threads: positions are skipped
};

/// What stays in force from block to block and more than one part of the reader uses.
struct ModalState {
  MotionMode motion = MotionMode::none;
  bool after_g80 = false;  ///< of MotionMode::none: G80 has ended another one
  int cycle_code = 0;      ///< of MotionMode::cycle, ten times the G number
  int spline_code = 0;     ///< of MotionMode::spline
  Plane plane = Plane::xy;
  bool inch = false;
  bool tool_centre_point = false;  ///< G43.4, G43.5: X, Y and Z are those of the tip
  bool tip_kinematics = false;     ///< the same by M428 of LinuxCNC
  bool tool_vectors = false;       ///< G43.5: I, J and K of lines are the tool's direction
  bool incremental = false;        ///< G91
  bool absolute_centers = false;   ///< G90.1
  double selected_tool = 0;        ///< T; 0: none yet
  double tool = 0;                 ///< that M6 brought in; 0: none yet
  bool to_initial_level = true;    ///< G98, against G99
  int work_offset = 0;             ///< key of Frames; 0: none yet

  double to_mm(double value) const { return inch ? units::from_inch(value) : value; }
  bool is_arc() const { return motion == MotionMode::arc_cw || motion == MotionMode::arc_ccw; }
};

}  // namespace feedscope::iso
