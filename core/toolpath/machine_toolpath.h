#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/machine/machine.h"
#include "core/toolpath/toolpath.h"

namespace feedscope {

/// The same path as a machine runs it, with these machine_settings(): feeds are times the feed override and
/// within the cutting feeds of X, Y and Z, blocks take block_time_ms at least, tool changes and spindle
/// starts take the times that are given, and moves whose two ends are known become lines, rapids where the
/// program gives no feed. What the settings do not say stays as it is. Every segment keeps its index but for
/// pauses in which the machine's rotary axes turn, see with_rotary_moves(). A path that was made for a
/// machine is worked out anew from that of the program (Toolpath::programmed). Returns `path` itself where
/// nothing changes. Throws Cancelled when stopped.
std::shared_ptr<const Toolpath> on_machine(std::shared_ptr<const Toolpath> path, const Machine& machine,
                                           const Settings& settings, const Progress* progress = nullptr);

/// What of a path has no time, since neither program nor machine say it.
struct NotCounted {
  std::size_t tool_changes = 0;
  std::size_t spindle_starts = 0;
  std::size_t stops = 0;          ///< M0, M1
  std::size_t machine_moves = 0;  ///< blocks to, at or from machine positions
  std::size_t plane_turns = 0;    ///< of rotary axes for tilted planes, on a machine without rotary axes
  /// Turns at which X, Y and Z hold the tip, tool length or part zero unknown: what their limits ask for.
  std::size_t tip_followings = 0;
  std::vector<std::string> other_axes = {};  ///< rotary and secondary ones that move
  bool operator==(const NotCounted&) const = default;
};
NotCounted not_counted(const Toolpath& path);

}  // namespace feedscope
