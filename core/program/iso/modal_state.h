#pragma once

#include <array>
#include <cstdint>

#include "core/base/units.h"
#include "core/program/path/plane.h"

namespace feedscope {

/// What the motion words of a block without a motion G word mean.
enum class MotionMode : std::uint8_t {
  none,     ///< no motion G word yet, or a cycle cancelled
  rapid,    ///< G0
  line,     ///< G1
  arc_cw,   ///< G2
  arc_ccw,  ///< G3
  unread,   ///< cycle, spline, thread: positions are left out
};

/// What stays in force from block to block.
struct ModalState {
  MotionMode motion = MotionMode::none;
  Plane plane = Plane::xy;
  bool inch = false;
  bool incremental = false;              ///< G91
  bool absolute_centers = false;         ///< G90.1
  double selected_tool = 0;              ///< T; 0: none yet
  double tool = 0;                       ///< that M6 brought in; 0: none yet
  int work_offset = 0;                   ///< ten times the G number; 0: none yet
  std::array<double, 6> further_axes{};  ///< A B C U V W as written

  double to_mm(double value) const { return inch ? units::from_inch(value) : value; }
};

}  // namespace feedscope
