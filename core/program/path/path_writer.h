#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "core/base/geometry.h"
#include "core/program/path/arc_solver.h"
#include "core/program/path/axis_places.h"
#include "core/program/path/contour_corners.h"
#include "core/program/path/coordinate_frame.h"
#include "core/program/path/cutter_compensation.h"
#include "core/program/path/parametric_curve.h"
#include "core/program/path/path_extents.h"
#include "core/program/path/plane.h"
#include "core/program/path/programmed_feed.h"
#include "core/program/path/spindle_tracker.h"
#include "core/program/path_control.h"
#include "core/program/program.h"
#include "core/program/text/diagnostic_log.h"

namespace feedscope {

/// Part of the messages about an impossible arc.
inline constexpr Translatable straight_instead = NC_("core", "a straight line to its end is used instead");

/// A requested arc, in programmed coordinates.
struct ArcRequest {
  Vec3 target = Vec3::Zero();
  Vec3 center = Vec3::Zero();   ///< used by arc_by_center()
  double radius = 0;            ///< used by arc_by_radius(); negative for the larger arc [mm]
  Vec3 axis = Vec3::UnitZ();    ///< unit; counter-clockwise seen against it
  double extra_turns = 0;       ///< additional whole turns
  std::uint32_t column = 0;     ///< of centre or radius, for messages
  ArcTolerance tolerance = {};  ///< used by arc_by_center()
  /// Centre by another reading of the words, and the name of that reading: a hint where the centre itself
  /// does not fit.
  Vec3 other_center = Vec3::Zero();
  Message other_reading;
};

/// Common target of the motion words of every dialect: takes motions in programmed coordinates, one after the
/// other, and appends them to the Program in shown coordinates, with feed, path control, line and bounds. The
/// tool starts at X0 Y0 Z0.
class PathWriter {
 public:
  /// Both outlive it.
  PathWriter(ReadProgram& program, DiagnosticLog& log);

  /// Assigns everything that follows to this line: `shown` of the program, `place` of the words.
  void begin_line(std::uint32_t shown, const DiagnosticLog::Place& place);
  /// Column of the motion's words, for messages.
  void set_column(std::uint32_t column) { place_.column = column; }
  /// Marks an axis, 0 to 2, as programmed by the line: the extent counts it from now on, and unless its
  /// coordinate is `incremental` the axis is known.
  void program_axis(int axis, bool incremental = false) {
    const auto i = static_cast<std::size_t>(axis);
    axes_.named[i] = true;
    axes_.absolute[i] = !incremental;
    axes_.incremental[i] = incremental;
  }
  /// Marks all three, for the extent.
  void program_axes() { axes_.named.fill(true); }
  /// Call after the last line.
  void finish();

  /// End of the programmed path so far [mm], in programmed and in shown coordinates.
  const Vec3& position() const { return programmed_; }
  const Vec3& shown_position() const { return shown_; }
  bool has_moved() const { return has_moved_; }
  /// False while the axis, 0 to 2, is at a place that only the machine knows: position() then returns its
  /// last one.
  bool knows(int axis) const { return places_.is_shown(axis); }

  /// Makes the following motions use this work offset with this zero point [mm], for Program::work_offsets;
  /// none: assumed as zero.
  void use_work_offset(std::string_view name, const std::optional<Vec3>& zero);
  /// Gives the work offset in use another zero point [mm]; does nothing while none is in use.
  void set_zero_in_use(const Vec3& zero);

  const CoordinateFrame& frame() const { return frame_; }
  /// Changes the programmed coordinates of the tool, which does not move.
  void set_frame(const CoordinateFrame& frame);

  void rapid(const Vec3& target);
  void line(const Vec3& target);
  /// An impossible arc is reported and becomes a line to its end, so that the position stays correct.
  void arc_by_center(const ArcRequest& arc);
  void arc_by_radius(const ArcRequest& arc);
  void dwell(double seconds);
  /// Pause of a tool change, a spindle start or a stop, at the end of the previous motion.
  void pause(Pause kind);
  /// Axes on which a shown coordinate is one of the machine, because the program itself gives the zero point.
  void set_machine_axes(const std::array<bool, 3>& axes) { machine_axes_ = axes; }
  /// Places of the axes, for a later go_to_machine_place().
  AxisPlaces places() const { return places_.places_at(shown_); }
  /// Sends the axes `moved` to places of the machine, at `feed` [mm/s] or as a rapid (0): a line where the
  /// path shows both ends. Otherwise the following motions are machine moves until the program gives every
  /// axis a coordinate; a feed motion before that starts at the end of the path so far, with a warning.
  /// Returns false if only the machine knows one of the places.
  bool go_to_machine_place(const std::array<bool, 3>& moved, const AxisPlaces& to, double feed = 0);
  /// Gives these axes coordinates at their current place, as G92 does. Unknown ones are assumed at their
  /// shown place; returns true if there are any.
  bool name_place(const std::array<bool, 3>& axes);
  /// Adds a curve in programmed coordinates that starts at the current position, from parameter `from` to
  /// `to`: as arcs (arcs_of_curve), or as lines (lines_of_curve) under cutter compensation or at a corner
  /// that is cut off. `column` for messages. Returns the unit direction at its end, zero for a length of
  /// zero.
  Vec3 curve(const ParametricCurve& curve, double from, double to, std::uint32_t column);

  /// Number of arcs by a centre so far, and of those that the centre does not fit.
  struct CenterCount {
    std::uint64_t arcs = 0;
    std::uint64_t misfits = 0;
  };
  const CenterCount& centers() const { return centers_; }

  /// See ProgrammedFeed.
  void set_feed_mode(FeedMode mode) { feed_.set_mode(mode); }
  FeedMode feed_mode() const { return feed_.mode(); }
  void set_feed(double feed) { feed_.set_value(feed); }
  double feed() const { return feed_.value(); }
  double feed_rate() const { return feed_.rate(); }
  void set_spindle_speed(double revolutions_per_second) { feed_.set_spindle_speed(revolutions_per_second); }
  double spindle_speed() const { return feed_.spindle_speed(); }
  /// All other spindle state.
  SpindleTracker& spindle() { return spindle_; }
  void set_tooth_count(double teeth) { feed_.set_tooth_count(teeth); }

  /// Starts a contour for which the tool's centre is written, see CutterCompensation; `column` for messages.
  /// Positions stay those of the contour.
  void set_compensation(ToolSide side, double radius, const CompensationRule& rule, Plane plane,
                        std::uint32_t column);
  void end_compensation();
  bool is_compensated() const { return compensation_.is_on() || compensation_waits_; }

  /// Cuts off the corner at the end of the next motion, a line or an arc, see ContourCorners; `cut.size` in
  /// programmed coordinates. Positions stay those of the contour.
  void cut_next_corner(CornerCut cut, Plane plane);

  const PathControl& path_control() const { return path_control_; }
  void set_path_control(const PathControl& control) { path_control_ = control; }

 private:
  void arc(const ArcRequest& request, const ArcSolution& solution);
  void report_arc_fault(const ArcRequest& request, const ArcSolution& solution);
  void straight_arc(const ArcRequest& request, const ArcSolution::Piece& piece);
  void chord(const Vec3& target);
  Vec3 curve_as_arcs(const ParametricCurve& curve, double from, double to);
  Vec3 curve_as_lines(const ParametricCurve& curve, double from, double to);
  void append(Motion motion, const Vec3& target, double feed, const ArcWords& arc = {},
              bool on_curve = false);
  void wait(Pause kind, double seconds);
  bool starts_at_known_place(Motion motion, double feed, const Vec3& programmed, const Vec3& shown);
  void write_machine_move(const Vec3& target, double feed);
  void suspend_compensation();
  void resume_compensation();
  MotionBlock block_to(const Vec3& target, Motion motion);
  void pass_on(const PathMotion& motion, const Vec3& from);
  void compensate(const PathMotion& motion);
  void end_motion();
  void end_corners();
  void pass_corners_on();
  void write(MotionBlock block, const ArcWords& arc, const std::array<bool, 3>& axes);
  void write_ready();
  Compensation compensation_in_frame() const;
  ContourPlane plane_in_frame(const ContourPlane& plane) const;
  std::uint16_t path_control_index();

  ReadProgram& program_;
  DiagnosticLog& log_;
  DiagnosticLog::Place place_;
  std::uint32_t line_ = 0;
  CoordinateFrame frame_;
  Vec3 programmed_ = Vec3::Zero();
  Vec3 shown_ = Vec3::Zero();
  PathExtents extents_;
  CenterCount centers_;
  bool has_moved_ = false;
  std::optional<std::size_t> offset_;  ///< in force, of Program::work_offsets
  ProgrammedAxes axes_;                ///< of the line
  PlaceTracker places_;
  std::array<bool, 3> machine_axes_{};
  bool compensation_waits_ = false;  ///< until every axis is known again
  ProgrammedFeed feed_;
  SpindleTracker spindle_{program_.spindles, log_};
  PathControl path_control_;
  std::uint16_t control_index_ = 0;  ///< of the last motion
  ContourCorners corners_;
  CutterCompensation compensation_;
  Compensation compensation_words_;  ///< its axes in programmed coordinates
};

}  // namespace feedscope
