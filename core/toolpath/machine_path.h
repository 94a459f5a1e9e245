#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/machine/machine.h"
#include "core/toolpath/toolpath.h"

namespace feedscope {

/// A path as a machine runs it, made once by on_machine().
struct MachinePath {
  /// With the machine's feeds, pauses, turns and moves; the path given to on_machine() where it changes none.
  std::shared_ptr<const Toolpath> toolpath;
  std::vector<Diagnostic> faults;  ///< moves that the machine cannot do, and notes on turns

  const Toolpath& operator*() const { return *toolpath; }
  const Toolpath* operator->() const { return toolpath.get(); }
};

/// `path` as a machine with these machine_settings() runs it. Feeds are times the feed override and
/// within the cutting feeds of X, Y and Z. Blocks take at least block_time_ms; tool changes and spindle
/// starts take the times given. Moves with two known ends become lines, rapids where the program gives no
/// feed. Everything else stays as it is. Segments keep their indices, except for pauses in which rotary axes
/// turn (with_rotary_moves()). `path`: as programmed or as the control reads it. Throws Cancelled when
/// stopped.
MachinePath on_machine(std::shared_ptr<const Toolpath> path, const Machine& machine, const Settings& settings,
                       const Progress* progress = nullptr);

/// Events of a path without a time, because neither program nor machine gives it.
struct NotCounted {
  std::size_t tool_changes = 0;
  std::size_t spindle_starts = 0;
  std::size_t stops = 0;          ///< M0, M1
  std::size_t machine_moves = 0;  ///< blocks to, at or from machine positions
  std::size_t plane_turns = 0;    ///< of rotary axes for tilted planes, on a machine without rotary axes
  /// Turns in which X, Y and Z keep the tip in place while tool length or part zero is unknown: their limits
  /// depend on them.
  std::size_t tip_followings = 0;
  std::vector<std::string> other_axes = {};  ///< names of moving rotary and secondary axes
  bool operator==(const NotCounted&) const = default;
};
NotCounted not_counted(const Toolpath& path);

}  // namespace feedscope
