#pragma once

// Room `toolpath`: the blocks of a ReadProgram as geometry, segments with length and curve. A MachinePath
// (machine_path.h) is such a path on a machine, with the turns of rotary axes, the limits that these set
// along the path (turn_limiter.h) and the moves to the positions of the machine.

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/base/geometry.h"
#include "core/program/program.h"
#include "core/toolpath/curve.h"

namespace feedscope {

class TurnCeiling;

enum class SegmentKind : std::uint8_t { line, arc, dwell };

/// Pause that a SegmentKind::dwell represents.
struct ToolpathPause {
  double time = 0;  ///< standstill of the axes [s]; 0 where it is not known
  Pause kind = Pause::dwell;
  bool timed = true;       ///< the time is known
  std::uint32_t move = 0;  ///< machine moves: index into Toolpath::machine_moves
  std::int8_t axis = -1;   ///< indexing, swing: the axis that takes the time, an index into cause_axes
};

/// A turn of rotary axes on a machine, from rest to rest.
struct RotaryTurn {
  /// Common law of all axes of a turn, by rest_to_rest_at() along the way; a way of 0: none.
  struct Law {
    double way = 0;       ///< root of the sum of squares of the angles; great circle: that of the tool [rad]
    double velocity = 0;  ///< [rad/s]
    double acceleration = 0;  ///< [rad/s2]
    double jerk = 0;          ///< [rad/s3]
  };

  std::size_t segment = 0;       ///< its pause
  std::array<double, 3> from{};  ///< angles of A, B and C [rad]
  std::array<double, 3> to{};
  double time = 0;            ///< [s]
  std::int8_t axis = -1;      ///< the axis that takes this time, an index into cause_axes
  double feed = 0;            ///< of all axes, which arrive together [rad/s]; 0: each as fast as it can
  bool at_tip = false;        ///< X, Y and Z keep the tip in place meanwhile
  bool great_circle = false;  ///< as SegmentTurn::great_circle
  Law law;                    ///< where the motion of X, Y and Z at the tip is known, instead of `feed`
};

/// One geometric element of the programmed path; it starts where the one before ends. A dwell ends where it
/// starts, except for a machine move: the path continues elsewhere, and the way of the tool there is not
/// known.
struct Segment {
  Vec3 end;                        ///< [mm]
  double length = 0;               ///< > 0; 0 for a dwell [mm]
  double feed = 0;                 ///< programmed [mm/s]; 0 for rapids and dwells
  std::uint32_t line = 0;          ///< 1-based line of the block
  std::int32_t index = -1;         ///< arcs: into Toolpath::arcs; dwells: into Toolpath::pauses
  std::uint16_t path_control = 0;  ///< index into Toolpath::path_controls
  std::uint16_t spindle = 0;       ///< index into Toolpath::spindles
  SegmentKind kind = SegmentKind::line;
  bool rapid = false;
  bool on_curve = false;  ///< part of a curve of the program, within curve_tolerance
  /// X, Y or Z (0 to 2) whose cutting feed on the machine makes `feed` less than the program's; -1: none.
  std::int8_t feed_axis = -1;
};
static_assert(sizeof(Segment) == 56);

/// Largest speed of the tip that the axes of a machine allow while rotary axes turn, and the limit that sets
/// it.
struct TurnLimit {
  /// `jump`: of the velocity, where the slopes of two segments meet; the axis makes up for it within a
  /// period.
  enum class By : std::uint8_t { velocity, acceleration, jerk, jump };

  double speed = std::numeric_limits<double>::infinity();  ///< along the path [mm/s]
  /// Derivative of its axis by the path, of the order of the limit; for a jump, the jump of the first
  /// derivative [rad/mm^n] or [mm/mm^n].
  double slope = 0;
  By by = By::velocity;
  std::int8_t axis = -1;  ///< index into cause_axes
};

/// Largest changes of the tip's speed that the axes of a machine allow while rotary axes turn, and the axes
/// that set them (indices into cause_axes); infinite where none does.
struct TurnRamp {
  double acceleration = std::numeric_limits<double>::infinity();  ///< along the path [mm/s2]
  double jerk = std::numeric_limits<double>::infinity();          ///< [mm/s3]
  std::int8_t acceleration_axis = -1;
  bool acceleration_by_jerk = false;  ///< set by the axis' jerk: by its term 3 q2 v v'
  std::int8_t jerk_axis = -1;
  /// First derivative by the path of the limiting axis; where its jerk limits, the second one [rad/mm^n] or
  /// [mm/mm^n].
  double acceleration_slope = 0;
  double jerk_slope = 0;  ///< first derivative of the limiting axis
};

/// Limits along a segment in which rotary axes turn: of these and of the linear axes that compensate for
/// them.
struct SegmentTurn {
  std::size_t segment = 0;
  std::array<double, 3> from{};  ///< angles of A, B and C [rad]
  std::array<double, 3> to{};
  TurnLimit limit;   ///< of its slowest place
  double tilt = -1;  ///< of the tool to the first of two rotary axes, in the middle [rad]; -1: only one axis
  TurnRamp ramp;     ///< along it, at the speed of `limit` or at the feed if that is lower
  bool at_tip = false;  ///< tool centre point control is on
  /// The tool's direction follows a great circle; otherwise the axes go linearly.
  bool great_circle = false;
};

/// Part of a segment in or near which rotary axes turn; ceiling and ramps are those of its slowest place
/// (TurnCeiling). It begins where the previous part of the segment ends.
struct TurnPart {
  std::size_t segment = 0;
  double end = 0;  ///< from the start of the segment [mm]
  TurnLimit limit;
  TurnRamp ramp;  ///< at the speed of `limit` or at the feed if that is lower
};

/// Place of the part on a machine with all rotary axes at zero, and length of the tool.
struct PartOnMachine {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();  ///< of the part's frame
  Vec3 zero = Vec3::Zero();                            ///< of the coordinates shown [mm]
  double tool_length = 0;                              ///< [mm]
  bool known = false;  ///< zero and length, and so how X, Y and Z follow rotary axes
};

/// Joint of two segments along which rotary axes have different slopes: each slope changes over along the
/// path from `before` to `behind` the place (joint_turn()).
struct TurnJoint {
  std::size_t segment = 0;       ///< the segment that ends there
  std::array<double, 3> step{};  ///< change of the slopes of A, B and C [rad/mm]
  double before = 0;             ///< reach; 0: the slopes jump [mm]
  double behind = 0;             ///< [mm]
  TurnLimit limit;
  TurnRamp ramp;       ///< on the segments that it shapes (joint_shape.h)
  bool stops = false;  ///< the tip stops there, which is faster than passing within limit and ramp
  double tilt = -1;    ///< as SegmentTurn::tilt, at the place
};

/// The zero point of a work offset that the program uses.
struct ZeroPoint {
  std::string name;  ///< as OffsetUse::name
  Vec3 place;        ///< [mm]
  bool assumed = false;
};

/// The programmed path: contiguous, in programmed order.
struct Toolpath {
  Vec3 start = Vec3::Zero();  ///< [mm]
  std::vector<Segment> segments;
  std::vector<Arc> arcs;
  std::vector<Vec3> misfits;  ///< ArcWords::misfit by index of `arcs`; empty where all are zero [mm]
  std::vector<ToolpathPause> pauses;
  std::vector<MachineMove> machine_moves;
  std::vector<PathControl> path_controls{PathControl()};  ///< the first is that of the machine
  std::vector<SpindleState> spindles{SpindleState()};     ///< as Program::spindles
  Bounds bounds;                                          ///< as Program::bounds [mm]
  std::vector<std::string> other_axes;                    ///< as Program::other_axes
  std::vector<std::string> cutting_axes;                  ///< as Program::cutting_axes
  /// As ReadProgram::rotary_moves with segments for motions; empty once a machine has turned them into
  /// pauses.
  std::vector<RotaryMove> rotary_moves;
  std::vector<SegmentTurn> segment_turns;  ///< rotary axes turn in these; by segment
  std::vector<TurnJoint> turn_joints;      ///< by segment
  std::vector<TurnPart> turn_parts;        ///< of segments whose limits differ along them, sorted by place
  std::shared_ptr<const TurnCeiling> turn_ceiling;  ///< its source; null where no rotary axis turns
  PartOnMachine part;                               ///< basis of rotary_turns and segment_turns
  double block_time = 0;                            ///< least time of the control for a block [s]
  std::vector<RotaryTurn> rotary_turns;             ///< turns of rotary_moves on the machine
  std::vector<ZeroPoint> zero_points;               ///< of Program::work_offsets
  /// The text, where it consists of G code words, which some controls read in ways of their own; null: none.
  std::shared_ptr<const SourceText> source;

  const Vec3& start_of(std::size_t i) const { return i == 0 ? start : segments[i - 1].end; }
  const PathControl& path_control_of(std::size_t i) const { return path_controls[segments[i].path_control]; }
  const SpindleState& spindle_of(std::size_t i) const { return spindles[segments[i].spindle]; }
  /// Arc of an arc segment of this path.
  const Arc& arc_of(const Segment& segment) const { return arcs[static_cast<std::size_t>(segment.index)]; }
  /// Programmed centre of an arc segment of this path [mm].
  Vec3 programmed_center(const Segment& segment) const {
    return arc_of(segment).center +
           (misfits.empty() ? Vec3(Vec3::Zero()) : misfits[static_cast<std::size_t>(segment.index)]);
  }
  /// Pause of a dwell of this path.
  const ToolpathPause& pause_of(const Segment& segment) const {
    return pauses[static_cast<std::size_t>(segment.index)];
  }
  /// Time of a dwell of this path [s].
  double dwell_of(const Segment& segment) const { return pause_of(segment).time; }
  /// True if the path continues elsewhere after this segment: nothing is to be drawn.
  bool is_gap(const Segment& segment) const {
    return segment.kind == SegmentKind::dwell && pause_of(segment).kind == Pause::machine_move;
  }
  /// Turn of segment `i`; null where no rotary axis turns in it.
  const SegmentTurn* segment_turn(std::size_t i) const;
  /// Joint at the end of segment `i`; null where no rotary axis changes its slope.
  const TurnJoint* turn_joint(std::size_t i) const;
  /// Parts of segment `i`, in order; empty where the limits of SegmentTurn apply to all of it.
  std::span<const TurnPart> turn_parts_of(std::size_t i) const;
  /// Point of a line or an arc, with derivatives by path length; `s` from the start of segment `i` [mm].
  CurvePoint place_on(std::size_t i, double s) const;
  Vec3 tangent_at_start(std::size_t i) const;  ///< unit; zero for a dwell
  Vec3 tangent_at_end(std::size_t i) const;    ///< unit; zero for a dwell
  double length() const;                       ///< sum of the segments [mm]
};

/// Turns blocks into segments: arcs get frames, helices stay helices, blocks that do not move vanish. Ends
/// are exactly the programmed points; a line no longer than same_point vanishes too, unless an arc begins at
/// its end.
Toolpath build_toolpath(const ReadProgram& program);

}  // namespace feedscope
