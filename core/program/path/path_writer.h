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

/// What the messages say of an arc that cannot be.
inline constexpr Translatable straight_instead = NC_("core", "a straight line to its end is used instead");

/// An arc to be, in programmed coordinates.
struct ArcRequest {
  Vec3 target = Vec3::Zero();
  Vec3 center = Vec3::Zero();   ///< used by arc_by_center()
  double radius = 0;            ///< used by arc_by_radius(); negative for the larger arc [mm]
  Vec3 axis = Vec3::UnitZ();    ///< unit; counter-clockwise seen against it
  double extra_turns = 0;       ///< whole turns more
  std::uint32_t column = 0;     ///< of centre or radius, for messages
  ArcTolerance tolerance = {};  ///< used by arc_by_center()
  /// A centre that the words would give if they were read another way, and that way's name: a hint where
  /// the centre itself does not fit.
  Vec3 other_center = Vec3::Zero();
  Message other_reading;
};

/// What the motion words of every dialect come to: takes motions in programmed coordinates, one after the
/// other, and appends them to the Program in the coordinates that are shown, with feed, path control, line
/// and bounds. The tool starts at X0 Y0 Z0.
class PathWriter {
 public:
  /// Both outlive it.
  PathWriter(Program& program, DiagnosticLog& log);

  /// What follows is of this line: `shown` of the program, `place` where the words stand.
  void begin_line(std::uint32_t shown, const DiagnosticLog::Place& place);
  /// Column of the motion's words, for messages.
  void set_column(std::uint32_t column) { place_.column = column; }
  /// The line programs this axis, 0 to 2: the extent counts it from now on, and unless it is an `incremental`
  /// coordinate the axis is where the line says.
  void program_axis(int axis, bool incremental = false) {
    const auto i = static_cast<std::size_t>(axis);
    axes_.named[i] = true;
    axes_.absolute[i] = !incremental;
    axes_.incremental[i] = incremental;
  }
  /// All three for the extent.
  void program_axes() { axes_.named.fill(true); }
  /// After the last line.
  void finish();

  /// Where the programmed path has come to [mm], in programmed and in shown coordinates.
  const Vec3& position() const { return programmed_; }
  const Vec3& shown_position() const { return shown_; }
  bool has_moved() const { return has_moved_; }
  /// False while the axis, 0 to 2, is at a place that only the machine knows: position() has its last one.
  bool knows(int axis) const { return places_.is_shown(axis); }

  /// What follows is programmed in this work offset with this zero point [mm], for Program::work_offsets;
  /// none: it is assumed as zero.
  void use_work_offset(std::string_view name, const std::optional<Vec3>& zero);
  /// The program gives the work offset in use another zero point [mm]; nothing while none is in use.
  void set_zero_in_use(const Vec3& zero);

  const CoordinateFrame& frame() const { return frame_; }
  /// The tool stays where it is; its programmed coordinates change.
  void set_frame(const CoordinateFrame& frame);

  void rapid(const Vec3& target);
  void line(const Vec3& target);
  /// An arc that cannot be one is reported and becomes a line to its end, so that the position goes on.
  void arc_by_center(const ArcRequest& arc);
  void arc_by_radius(const ArcRequest& arc);
  void dwell(double seconds);
  /// Of a tool change, a spindle start or a stop, at the end of what came before.
  void pause(Pause kind);
  /// On these axes a shown coordinate is one of the machine: the program itself gives the zero point.
  void set_machine_axes(const std::array<bool, 3>& axes) { machine_axes_ = axes; }
  /// Where the axes are, for go_to_machine_place() later on.
  AxisPlaces places() const { return places_.places_at(shown_); }
  /// The axes `moved` go to places of the machine, at `feed` [mm/s] or as a rapid (0): a line where the path
  /// shows both ends. Else what follows is a machine move until the program says where every axis is; a feed
  /// motion before that is taken as starting where the path has come to, with a warning. False where only the
  /// machine knows one of the places.
  bool go_to_machine_place(const std::array<bool, 3>& moved, const AxisPlaces& to, double feed = 0);
  /// The program gives these axes coordinates where they are, as G92 does. Those that are not known are taken
  /// to be where the path shows them; true if there are any.
  bool name_place(const std::array<bool, 3>& axes);
  /// Along a curve in programmed coordinates that starts where the path has come to, from parameter `from` to
  /// `to`: as arcs (arcs_of_curve), under cutter compensation or at a corner that is cut off as lines
  /// (lines_of_curve). `column` for messages. Returns the unit direction at its end, zero if it has no
  /// length.
  Vec3 curve(const ParametricCurve& curve, double from, double to, std::uint32_t column);

  /// The arcs by a centre so far, and those of them that the centre does not fit.
  struct CenterCount {
    std::uint64_t arcs = 0;
    std::uint64_t misfits = 0;
  };
  const CenterCount& centers() const { return centers_; }

  /// What ProgrammedFeed says of it.
  void set_feed_mode(FeedMode mode) { feed_.set_mode(mode); }
  FeedMode feed_mode() const { return feed_.mode(); }
  void set_feed(double feed) { feed_.set_value(feed); }
  double feed() const { return feed_.value(); }
  double feed_rate() const { return feed_.rate(); }
  void set_spindle_speed(double revolutions_per_second) { feed_.set_spindle_speed(revolutions_per_second); }
  double spindle_speed() const { return feed_.spindle_speed(); }
  /// What else is said of the spindle.
  SpindleTracker& spindle() { return spindle_; }
  void set_tooth_count(double teeth) { feed_.set_tooth_count(teeth); }

  /// What follows is a contour of which the tool's centre is written, see CutterCompensation; `column` for
  /// messages. Positions stay those of the contour.
  void set_compensation(ToolSide side, double radius, const CompensationRule& rule, Plane plane,
                        std::uint32_t column);
  void end_compensation();
  bool is_compensated() const { return compensation_.is_on() || compensation_waits_; }

  /// The motion that follows, a line or an arc, ends in a corner that is cut off, see ContourCorners;
  /// `cut.size` in programmed coordinates. Positions stay those of the contour.
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

  Program& program_;
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
