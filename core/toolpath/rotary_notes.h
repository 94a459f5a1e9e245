#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/kinematics/kinematic_chain.h"
#include "core/machine/rotary_axis.h"
#include "core/program/text/message_codes.h"
#include "core/toolpath/toolpath.h"

namespace feedscope {

/// Notes on the turns of a path on a machine, for MachinePath::faults.
class RotaryNotes {
 public:
  /// `faults` outlives it.
  explicit RotaryNotes(std::vector<Diagnostic>& faults) : faults_(faults) {}

  /// Adds notes on a tool vector: two positions may be equally near, and near the singular position a small
  /// turn of the tool is a large turn of the first axis. `found`: positions that give the vector, the nearest
  /// first; `from`: previous angles. Keeps the first ten of each kind.
  void add_unclear(std::uint32_t line, std::span<const RotaryPlaces> found, std::span<const double> from,
                   const RotaryAxis& first);
  /// Adds to the singular places a turn along `segment` of a machine with two rotary axes, where the
  /// first axis limits the feed while the tool lies near its direction: it turns by 1/sin of the angle
  /// between them.
  void add_singular(const SegmentTurn& turn, const Segment& segment, const RotaryAxis& first);
  /// Adds notes on the slowest singular places, ten at most, in the order of the path.
  void report_singular();

 private:
  /// Neighbouring segments along which the first of two rotary axes limits the feed while the tool lies near
  /// it.
  struct SingularPlace {
    std::uint32_t line = 0;        ///< of the slowest segment
    std::uint32_t first_line = 0;  ///< of all segments
    std::uint32_t last_line = 0;
    char axis = 'C';
    double tilt = 0;   ///< of the tool to the axis at the slowest one [rad]
    double speed = 0;  ///< largest possible there [mm/s]
    double feed = 0;   ///< programmed there [mm/s]
  };

  void add(std::uint32_t line, MessageCode code, Message what, Message hint);

  std::vector<Diagnostic>& faults_;
  std::vector<SingularPlace> singular_places_;  ///< in the order of the path
  std::size_t flips_ = 0;                       ///< tool vectors with a large turn of the first axis
  std::size_t equals_ = 0;                      ///< with two positions equally near
  std::size_t last_singular_ = 0;               ///< last segment of the last singular place
};

}  // namespace feedscope
