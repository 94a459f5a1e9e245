#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "core/kinematics/kinematic_chain.h"
#include "core/machine/rotary_axis.h"
#include "core/program/text/message_codes.h"
#include "core/toolpath/toolpath.h"

namespace feedscope {

/// Notes on the turns of a path on a machine, for Toolpath::machine_faults, and its singular places.
class RotaryNotes {
 public:
  /// `path` outlives it.
  explicit RotaryNotes(Toolpath& path) : path_(path) {}

  /// Adds notes on a tool vector: two positions may be equally near, and near the singular position a small
  /// turn of the tool is a large turn of the first axis. `found`: positions that give the vector, the nearest
  /// first; `from`: previous angles. Keeps the first ten of each kind.
  void add_unclear(std::uint32_t line, std::span<const RotaryPlaces> found, std::span<const double> from,
                   const RotaryAxis& first);
  /// Adds to Toolpath::singular_places a turn along `segment` of a machine with two rotary axes, where the
  /// first axis limits the feed while the tool lies near its direction: it turns by 1/sin of the angle
  /// between them.
  void add_singular(const SegmentTurn& turn, const Segment& segment, const RotaryAxis& first);
  /// Adds notes on the slowest singular places, ten at most, in the order of the path.
  void report_singular();

 private:
  void add(std::uint32_t line, MessageCode code, Message what, Message hint);

  Toolpath& path_;
  std::size_t flips_ = 0;          ///< tool vectors with a large turn of the first axis
  std::size_t equals_ = 0;         ///< with two positions equally near
  std::size_t last_singular_ = 0;  ///< last segment of the last singular place
};

}  // namespace feedscope
