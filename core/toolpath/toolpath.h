#pragma once

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

/// What a SegmentKind::dwell stands for.
struct ToolpathPause {
  double time = 0;  ///< that the axes stand [s]; 0 where it is not known
  Pause kind = Pause::dwell;
  bool timed = true;       ///< the time is known
  std::uint32_t move = 0;  ///< machine moves: index into Toolpath::machine_moves
  std::int8_t axis = -1;   ///< indexing, swing: the axis that takes the time, a place in cause_axes
};

/// A turn of rotary axes on a machine, from rest to rest.
struct RotaryTurn {
  /// Of a turn whose axes all go by one law of rest_to_rest_at() along the way; a way of 0: there is none.
  struct Law {
    double way = 0;           ///< root of the squares of the angles, on a great circle that of the tool [rad]
    double velocity = 0;      ///< [rad/s]
    double acceleration = 0;  ///< [rad/s2]
    double jerk = 0;          ///< [rad/s3]
  };

  std::size_t segment = 0;       ///< its pause
  std::array<double, 3> from{};  ///< angles of A, B and C [rad]
  std::array<double, 3> to{};
  double time = 0;        ///< that it takes [s]
  std::int8_t axis = -1;  ///< that takes this time, a place in cause_axes
  double feed = 0;        ///< of all axes together, which arrive together [rad/s]; 0: each as fast as it can
  bool at_tip = false;    ///< X, Y and Z hold the tip where it is meanwhile
  bool great_circle = false;  ///< as SegmentTurn::great_circle
  Law law;                    ///< where it is known how X, Y and Z hold the tip, instead of `feed`
};

/// One geometric element of the programmed path; it starts where the one before ends. A dwell ends where it
/// starts, unless it is a machine move: the path goes on elsewhere, and how the tool gets there is not known.
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
  bool on_curve = false;  ///< stands for a part of a curve of the program, within curve_tolerance
  /// X, Y or Z (0 to 2) whose cutting feed on the machine makes `feed` less than the program's; -1: none.
  std::int8_t feed_axis = -1;
};
static_assert(sizeof(Segment) == 56);

/// How fast the axes of a machine let the tip go while rotary axes turn, and by which of their limits.
struct TurnLimit {
  /// `jump`: of the velocity, where slopes of two segments meet; it is taken up within a period.
  enum class By : std::uint8_t { velocity, acceleration, jerk, jump };

  double speed = std::numeric_limits<double>::infinity();  ///< along the path [mm/s]
  /// Derivative of its axis by the path, of the order of the limit, or the jump of the first [rad/mm^n] or
  /// [mm/mm^n].
  double slope = 0;
  By by = By::velocity;
  std::int8_t axis = -1;  ///< a place in cause_axes
};

/// How the axes of a machine let the speed of the tip change while rotary axes turn, and which axis says so,
/// a place in cause_axes; infinite where none does.
struct TurnRamp {
  double acceleration = std::numeric_limits<double>::infinity();  ///< along the path [mm/s2]
  double jerk = std::numeric_limits<double>::infinity();          ///< [mm/s3]
  std::int8_t acceleration_axis = -1;
  bool acceleration_by_jerk = false;  ///< its jerk says so: 3 q2 v v' of it
  std::int8_t jerk_axis = -1;
  /// First derivative by the path of the axis that says so; where its jerk does, the second one [rad/mm^n] or
  /// [mm/mm^n].
  double acceleration_slope = 0;
  double jerk_slope = 0;  ///< first derivative of the axis that says so
};

/// What the rotary axes of a machine, and its linear axes that make up for them, allow along a segment in
/// which they turn.
struct SegmentTurn {
  std::size_t segment = 0;
  std::array<double, 3> from{};  ///< angles of A, B and C [rad]
  std::array<double, 3> to{};
  TurnLimit limit;      ///< of its slowest place
  double tilt = -1;     ///< of the tool to the first of two rotary axes, in the middle [rad]; -1: only one
  TurnRamp ramp;        ///< along it, at the speed of `limit` or at its feed if that is less
  bool at_tip = false;  ///< tool centre point control is on
  /// The tool's direction goes along a great circle, else the axes go linearly.
  bool great_circle = false;
};

/// A part of a segment along which, or beside which, rotary axes turn: its ceiling and ramps are those of its
/// slowest place (TurnCeiling). It begins where the part before it in the segment ends.
struct TurnPart {
  std::size_t segment = 0;
  double end = 0;  ///< from the start of the segment [mm]
  TurnLimit limit;
  TurnRamp ramp;  ///< at the speed of `limit` or at its feed if that is less
};

/// Where the part is on a machine with rotary axes all at zero, and how long the tool is.
struct PartOnMachine {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();  ///< of the part's frame
  Vec3 zero = Vec3::Zero();                            ///< of the coordinates shown [mm]
  double tool_length = 0;                              ///< [mm]
  bool known = false;  ///< zero and length: so it is known how X, Y and Z follow rotary axes
};

/// Where two segments meet along which rotary axes have different slopes: each goes over from one to the
/// other along the path from `before` to `behind` the place (joint_turn()).
struct TurnJoint {
  std::size_t segment = 0;       ///< that ends there
  std::array<double, 3> step{};  ///< change of the slopes of A, B and C [rad/mm]
  double before = 0;             ///< how far it reaches; 0: the slopes jump [mm]
  double behind = 0;             ///< [mm]
  TurnLimit limit;
  TurnRamp ramp;       ///< on the segments that it shapes (joint_shape.h)
  bool stops = false;  ///< the tip stops there, which is faster than passing within limit and ramp
  double tilt = -1;    ///< as SegmentTurn::tilt, at the place
};

/// Neighbouring segments along which the first of two rotary axes holds the feed while the tool lies near it.
struct SingularPlace {
  std::uint32_t line = 0;        ///< of the slowest segment
  std::uint32_t first_line = 0;  ///< of them all
  std::uint32_t last_line = 0;
  char axis = 'C';
  double tilt = 0;   ///< of the tool to the axis at the slowest one [rad]
  double speed = 0;  ///< that is possible there [mm/s]
  double feed = 0;   ///< programmed there [mm/s]
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
  std::vector<PathControl> path_controls{PathControl()};  ///< the first is the machine's
  std::vector<SpindleState> spindles{SpindleState()};     ///< as Program::spindles
  Bounds bounds;                                          ///< as Program::bounds [mm]
  std::vector<std::string> other_axes;                    ///< as Program::other_axes
  std::vector<std::string> cutting_axes;                  ///< as Program::cutting_axes
  /// As Program::rotary_moves with segments for motions; none once a machine has made pauses of them.
  std::vector<RotaryMove> rotary_moves;
  std::vector<SegmentTurn> segment_turns;           ///< in which rotary axes turn, by segment
  std::vector<TurnJoint> turn_joints;               ///< by segment
  std::vector<TurnPart> turn_parts;                 ///< of segments whose limits differ along them, by place
  std::shared_ptr<const TurnCeiling> turn_ceiling;  ///< that made them; null where no rotary axis turns
  PartOnMachine part;                               ///< rotary_turns and segment_turns are worked out with it
  double block_time = 0;                            ///< least time that the control takes for a block [s]
  /// The path of the program that on_machine() made this one of; null: this is it.
  std::shared_ptr<const Toolpath> programmed;
  std::vector<RotaryTurn> rotary_turns;        ///< what they came to on the machine
  std::vector<SingularPlace> singular_places;  ///< in the order of the path
  std::vector<Diagnostic> machine_faults;      ///< what the machine cannot do
  std::vector<ZeroPoint> zero_points;          ///< of Program::work_offsets
  /// The text, where it is words of G code, which some controls read in ways of their own; null: none.
  std::shared_ptr<const SourceText> source;
  bool read_by_control = false;  ///< `source` has been read in a control's own way

  /// A control may read the text in its own way.
  bool may_be_read() const { return source && !read_by_control; }
  const Vec3& start_of(std::size_t i) const { return i == 0 ? start : segments[i - 1].end; }
  const PathControl& path_control_of(std::size_t i) const { return path_controls[segments[i].path_control]; }
  const SpindleState& spindle_of(std::size_t i) const { return spindles[segments[i].spindle]; }
  /// Of an arc segment of this path.
  const Arc& arc_of(const Segment& segment) const { return arcs[static_cast<std::size_t>(segment.index)]; }
  /// Centre of an arc segment of this path as it is programmed [mm].
  Vec3 programmed_center(const Segment& segment) const {
    return arc_of(segment).center +
           (misfits.empty() ? Vec3(Vec3::Zero()) : misfits[static_cast<std::size_t>(segment.index)]);
  }
  /// Of a dwell of this path.
  const ToolpathPause& pause_of(const Segment& segment) const {
    return pauses[static_cast<std::size_t>(segment.index)];
  }
  /// Time of a dwell of this path [s].
  double dwell_of(const Segment& segment) const { return pause_of(segment).time; }
  /// The path goes on elsewhere behind this segment's start: nothing is to be drawn.
  bool is_gap(const Segment& segment) const {
    return segment.kind == SegmentKind::dwell && pause_of(segment).kind == Pause::machine_move;
  }
  /// Of segment `i`; null where no rotary axis turns in it.
  const SegmentTurn* segment_turn(std::size_t i) const;
  /// At the end of segment `i`; null where no rotary axis changes its slope.
  const TurnJoint* turn_joint(std::size_t i) const;
  /// Of segment `i`, in order; none where the limits of SegmentTurn are those of all of it.
  std::span<const TurnPart> turn_parts_of(std::size_t i) const;
  /// On a line or an arc, with derivatives by path length; `s` from the start of segment `i` [mm].
  CurvePoint place_on(std::size_t i, double s) const;
  Vec3 tangent_at_start(std::size_t i) const;  ///< unit; zero for a dwell
  Vec3 tangent_at_end(std::size_t i) const;    ///< unit; zero for a dwell
  double length() const;                       ///< sum of the segments [mm]
};

/// Blocks to segments: arcs get frames, helices stay helices, blocks that do not move vanish.
/// Ends are the programmed points exactly; a line no longer than same_point vanishes too, unless an arc
/// begins at its end.
Toolpath build_toolpath(const Program& program);
/// The same; the motions and arcs of `program`, which the toolpath replaces, are given up.
Toolpath take_toolpath(Program& program);

}  // namespace feedscope
