#pragma once

#include <cstdint>
#include <vector>

#include "core/base/progress.h"
#include "core/trajectory/trajectory.h"

namespace feedscope::ui {

/// Motion from a node to the next.
enum class NodeKind : std::uint8_t {
  cut,
  rapid,
  pause,  ///< X, Y and Z at rest
  gap,    ///< unknown motion to the next position
  arc,    ///< of a programmed path: a cut to a point within an arc
};

/// An instant of a run, and the values from there to the next node.
struct RunNode {
  double time = 0;                ///< [s]
  double path_length = 0;         ///< executed [mm]
  double place = 0;               ///< of the nearest point of the program: its path length there [mm]
  Vec3 position = Vec3::Zero();   ///< [mm]
  double speed = 0;               ///< [mm/s]
  double error = 0;               ///< distance from the programmed path [mm]
  double acceleration = 0;        ///< length of the vector, right after the node [mm/s2]
  double middle_speed = 0;        ///< halfway to the next node in time [mm/s]
  double acceleration_after = 0;  ///< right before the next node [mm/s2]
  double jerk = 0;                ///< length of the vector, halfway [mm/s3]
  double feed = 0;                ///< programmed; of a rapid the axes' speed [mm/s]
  std::uint32_t line = 0;         ///< source line
  Cause cause;                    ///< limiting cause
  NodeKind kind = NodeKind::cut;
};

/// Permitted deviation between a run and its drawing from nodes. Between two nodes the position is linear in
/// path length, and the speed is a parabola in time.
struct NodePrecision {
  double position = 0;  ///< [mm]
  double speed = 0;     ///< [mm/s]
};

/// The precision of a page: below 1 um and 0.1 % of the largest feed, including the rounding of the columns.
NodePrecision fine_precision(double top_feed);

struct RunNodes {
  std::vector<RunNode> nodes;  ///< in order of time; empty for an empty trajectory
  NodePrecision precision;     ///< of the nodes outside of the close views
};

/// A part of the programmed path that is looked at from close by [mm].
struct CloseView {
  double from = 0;
  double to = 0;
};

/// `most`: beyond this number of nodes, those where path and speed are straightest are omitted: the
/// tolerances of speed and path are doubled in turn; within `views` (in order, apart) the fine precision
/// stays. `top_feed`: the largest of feed motions [mm/s]. Linear in the pieces. Throws Cancelled.
RunNodes run_nodes(const Trajectory& trajectory, double top_feed, std::size_t most,
                   const std::vector<CloseView>& views = {}, Progress* progress = nullptr);

/// Points of the programmed path close enough to draw it within `precision` [mm].
struct ProgrammedPoint {
  double place = 0;               ///< programmed path length [mm]
  Vec3 position = Vec3::Zero();   ///< [mm]
  std::uint32_t line = 0;         ///< of the block that ends here or is in progress
  NodeKind kind = NodeKind::cut;  ///< motion to this point
};
std::vector<ProgrammedPoint> programmed_points(const Toolpath& path, double precision);

}  // namespace feedscope::ui
