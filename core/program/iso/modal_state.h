#pragma once

#include <cstdint>

#include "core/base/units.h"
#include "core/program/path/plane.h"

namespace feedscope::iso {

/// Meaning of motion words in a block without a motion G word.
enum class MotionMode : std::uint8_t {
  none,     ///< no motion G word yet, or a cycle cancelled
  rapid,    ///< G0
  line,     ///< G1
  arc_cw,   ///< G2
  arc_ccw,  ///< G3
  cycle,    ///< G73 to G89
  spline,   ///< G5, G5.1, G5.2, G6.2
  unread,   ///< not supported, such as threads: positions are skipped
};

/// Modal state shared by several parts of the reader.
struct ModalState {
  MotionMode motion = MotionMode::none;
  bool after_g80 = false;  ///< of MotionMode::none: G80 has ended another mode
  int cycle_code = 0;      ///< of MotionMode::cycle, ten times the G number
  int spline_code = 0;     ///< of MotionMode::spline
  Plane plane = Plane::xy;
  bool inch = false;
  bool tool_centre_point = false;  ///< G43.4, G43.5: X, Y and Z are those of the tip
  bool tip_kinematics = false;     ///< the same by LinuxCNC's M428
  bool tool_vectors = false;       ///< G43.5: I, J and K of lines are the tool's direction
  bool incremental = false;        ///< G91
  bool absolute_centers = false;   ///< G90.1
  double selected_tool = 0;        ///< T; 0: none yet
  double tool = 0;                 ///< brought in by M6; 0: none yet
  bool to_initial_level = true;    ///< G98; false: G99
  int work_offset = 0;             ///< key of Frames; 0: none yet

  double to_mm(double value) const { return inch ? units::from_inch(value) : value; }
  bool is_arc() const { return motion == MotionMode::arc_cw || motion == MotionMode::arc_ccw; }
};

}  // namespace feedscope::iso
