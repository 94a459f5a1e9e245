#pragma once

#include <array>
#include <cstdint>
#include <numbers>
#include <optional>
#include <vector>

#include "core/base/geometry.h"
#include "core/program/path/contour_plane.h"
#include "core/program/path/contour_watch.h"
#include "core/program/path/path_motion.h"
#include "core/program/path/plane_element.h"
#include "core/program/program.h"
#include "core/program/text/diagnostic_log.h"

namespace feedscope {

/// Side of the contour on which the tool runs, seen in its direction of motion.
enum class ToolSide : std::uint8_t { left, right };

/// Way of the tool around an outside corner of the contour.
enum class OutsideCorner : std::uint8_t {
  arc,    ///< on an arc about the corner
  lines,  ///< straight on to the meeting point of both offset paths; above a quarter turn the tip is cut off
  meeting,      ///< on along both paths to their meeting point; on an arc if there is none, or above
                ///< largest_meeting_turn
  arc_at_feed,  ///< on an arc about the corner; before a rapid straight across to its path
};

/// Largest turn of a corner at which OutsideCorner::meeting continues along the paths [rad]: the preset of
/// machine data 20210 ($MC_CUTCOM_CORNER_LIMIT) of a Sinumerik 840D, 100 degrees.
inline constexpr double largest_meeting_turn = 100 * std::numbers::pi / 180;

/// Rules of a control for the offset path.
struct CompensationRule {
  OutsideCorner corner = OutsideCorner::arc;
  /// The entry ends at right angles to the end of its own line, and meets the next element in a corner like
  /// any other; else at right angles to the start of that element.
  bool enters_beside_itself = false;
  /// Corners with a smaller turn do not count as corners: the path of the earlier element runs to its end,
  /// and that of the later one begins there [rad].
  double smallest_corner = 0;
  /// Cuts into later parts of the contour are errors. If false, the control runs them, and they are warnings;
  /// it also does not check whether a block before an outside corner that leads to an arc has room. The path
  /// of such a block keeps its end; if it starts after that end, a line runs backwards and an arc nearly a
  /// whole turn.
  bool looks_ahead = true;

  bool operator==(const CompensationRule&) const = default;
};

/// Rule of LinuxCNC, from its interpreter's paths for random contours (tests/oracle).
inline constexpr CompensationRule linuxcnc_compensation{OutsideCorner::arc_at_feed, true, 0.05, false};

struct Compensation {
  ToolSide side = ToolSide::left;
  double radius = 0;  ///< of the tool [mm]; negative: the opposite side
  CompensationRule rule;
  ContourPlane plane;  ///< left means left seen against its normal
};

/// Turns a contour into the offset path of the tool's centre.
///
/// Entry: the first motion in the plane is a straight line from the tool's position to the place at right
/// angles to the start of the next one, or by the rule of the control. Exit: the contour ends at right angles
/// to its last point; the next motion in the plane is a straight line to its programmed end. Inside corners:
/// both paths end where they meet. Outside corners: by the rule; inserted elements belong to the later block.
/// Motions across the plane and dwells take place where the previous block ends. A motion is ready when
/// the next one in the plane is known.
///
/// Reports: "compensation-gouge" where the tool is too large for the contour, for two consecutive blocks and,
/// by ContourWatch, farther along; "compensation-entry" and "compensation-exit" for arcs that should be
/// lines; "compensation-plane" where it is switched to another plane on the way.
class CutterCompensation {
 public:
  explicit CutterCompensation(DiagnosticLog& log) : log_(log) {}

  /// True if neither on nor on the way out: motions need not pass through it.
  bool is_off() const { return stage_ == Stage::off; }
  bool is_on() const { return stage_ == Stage::entry || stage_ == Stage::contour; }
  /// Switches on from the next motion. `tool`: place of the tool if the compensation is off. Another side or
  /// radius makes the next motion an entry.
  void switch_on(const Compensation& compensation, const Vec3& tool, const DiagnosticLog::Place& place);
  void switch_off();
  /// Switches off at once: the way out is not part of the path.
  void break_off();

  void take(const PathMotion& motion);
  /// Call when no motion follows.
  void finish();
  /// Motions of the tool's centre in order; the caller removes them.
  std::vector<PathMotion>& ready() { return ready_; }

 private:
  enum class Stage : std::uint8_t { off, entry, contour, exit };

  struct Held {
    PathMotion motion;
    PlaneElement contour;
    bool is_entry = false;
    bool runs_unchecked = false;  ///< by CompensationRule::looks_ahead, even without room
  };

  Vec2 in_plane(const Vec3& point) const { return compensation_.plane.in_plane(point); }
  bool names_plane(const PathMotion& motion) const;
  Vec3 in_space(const Vec2& point, const Vec3& height_of) const {
    return compensation_.plane.in_space(point, height_of);
  }
  PlaneElement element_of(const PathMotion& motion, const Vec2& start);
  PlaneElement path_beside(const PlaneElement& contour) const;

  void take_in_plane(const PathMotion& motion);
  void take_across(const PathMotion& motion);
  void enter(const PathMotion& motion, const PlaneElement& contour);
  void leave(const PathMotion& motion);
  void hold(const PathMotion& motion, const PlaneElement& contour, bool is_entry);
  void join(const PathMotion& motion, const PlaneElement& next);
  void go_around(const PlaneElement& next, const PathMotion& motion);
  bool is_no_corner(const PlaneElement& next) const;
  std::optional<Vec2> outside_meeting(const PlaneElement& next) const;
  void go_around_on_lines(const PlaneElement& next, const PathMotion& linking);
  Vec2 inside_corner(const PlaneElement& last, const PlaneElement& next);
  /// Writes the pending motion with this end, and the motions that wait after it.
  void release(const Vec2& end);
  void release_square();
  void write_arc(const PlaneElement& path, const Vec2& end);
  void write(const PathMotion& motion, const Vec3& to);
  void write_beside(const PathMotion& motion);
  void report_plane(const DiagnosticLog::Place& place);
  void report_radius(const PathMotion& motion, double radius);
  void report_swallowed();
  void watch_path(const PathMotion& motion, const Vec3& to);
  void watch_contour(const PathMotion& motion, const PlaneElement& contour);

  DiagnosticLog& log_;
  Stage stage_ = Stage::off;
  Compensation compensation_;
  double left_ = 0;              ///< of the contour [mm]
  Vec3 tool_ = Vec3::Zero();     ///< place of the centre after the ready motions [mm]
  Vec3 contour_ = Vec3::Zero();  ///< end of the last motion taken [mm]
  std::optional<Held> held_;
  ContourWatch watch_;
  bool watches_ = false;             ///< the path along the contour, without entry and exit
  bool gouges_ = false;              ///< reported where the pending motion meets its neighbours
  std::vector<PathMotion> waiting_;  ///< after the pending one: no motion in the plane
  std::vector<PathMotion> ready_;
};

}  // namespace feedscope
