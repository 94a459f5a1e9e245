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
  cycle,    ///< G73 to G89
  spline,   ///< G5, G5.1, G5.2
  unread,   ///< thread, Fanuc's spline: positions are left out
};

/// G15, G16: the words of the plane's axes are radius and angle.
struct PolarState {
  bool on = false;
  Vec3 center = Vec3::Zero();  ///< [mm]
  double radius = 0;           ///< [mm]
  double angle = 0;            ///< [rad]
};

/// What the blocks of a series of holes have in common; [mm] along the tool's axis.
struct CycleState {
  int code = 0;  ///< ten times the G number
  bool begun = false;
  double initial = 0;  ///< level before the series
  double retract = 0;
  double bottom = 0;
  bool bottom_from_retract = false;  ///< as programmed with G91
  bool has_retract = false;
  bool has_bottom = false;
  double peck = 0;            ///< Q, or the first one, I of Haas
  double peck_less = 0;       ///< J of Haas: by which each peck is smaller than the one before
  double peck_least = 0;      ///< K of Haas
  Vec3 aside = Vec3::Zero();  ///< I J K of G76 and G87, instead of Q
  double dwell = 0;           ///< [s]
};

struct SplineState {
  int code = 0;  ///< ten times the G number
  bool has_tangent = false;
  Vec3 tangent =
      Vec3::Zero();  ///< from the end of the last G5 to the control point that goes on straight [mm]
};

/// G40 to G42.1.
struct CompensationState {
  int code = 400;     ///< ten times the G number
  int offset = 0;     ///< D in force
  double radius = 0;  ///< [mm]
};

/// What stays in force from block to block.
struct ModalState {
  MotionMode motion = MotionMode::none;
  MotionMode before_cycle = MotionMode::none;  ///< G0 to G3, which Fanuc's G80 goes back to
  Plane plane = Plane::xy;
  bool inch = false;
  bool incremental = false;       ///< G91
  bool absolute_centers = false;  ///< G90.1
  double selected_tool = 0;       ///< T; 0: none yet
  double tool = 0;                ///< that M6 brought in; 0: none yet
  bool to_initial_level = true;   ///< G98, against G99
  int work_offset = 0;            ///< key of IsoCoordinates; 0: none yet
  PolarState polar;
  CycleState cycle;
  SplineState spline;
  CompensationState compensation;
  Vec3 intermediate_point = Vec3::Zero();  ///< of G28 and G30 [mm]
  std::array<double, 6> further_axes{};    ///< A B C U V W as written

  double to_mm(double value) const { return inch ? units::from_inch(value) : value; }
};

}  // namespace feedscope
