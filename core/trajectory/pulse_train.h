#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/toolpath/toolpath.h"

namespace feedscope {

/// A part of the command that follows one law: `velocity`, and where `rate` > 0 also a turn,
///   p(h) = position + h velocity + (cos(rate h) - 1) cosine + sin(rate h) sine,   h from the part's start.
struct CommandPart {
  double time = 0;  ///< start [s]
  double rate = 0;  ///< [rad/s]; 0: straight, `cosine` and `sine` unused
  Vec3 position;    ///< at the start [mm]
  Vec3 velocity;    ///< of an arc: along its axis [mm/s]
  Vec3 cosine;      ///< from the centre to the start [mm]
  Vec3 sine;        ///< same length, a quarter turn ahead [mm]

  Vec3 velocity_at_start() const { return rate > 0 ? Vec3(velocity + rate * sine) : velocity; }
  /// Makes the part begin `h` [s] later.
  void begin_later(double h);
};

/// Command on one block: a pulse of height `feed` between the blending pulses of its two corners.
struct BlockPulses {
  double start = 0;         ///< of the first pulse, from the start of the motion [s]
  double feed = 0;          ///< F, or f of the short-block rule [mm/s]
  double corner_speed = 0;  ///< V_c of the corner where the block starts; not used at a stop [mm/s]
};

/// Widths T_b, T_v, T_b of the pulses of one block [s].
struct PulseWidths {
  double left = 0;
  double middle = 0;
  double right = 0;
  double sum() const { return left + middle + right; }
};

/// Velocity pulses of a path from standstill to standstill, and the equal moving averages that smooth them
/// (Ward 2021; models/ward/README.md). Direction and place come from the lines and arcs of the programmed
/// path, so that a block takes only 24 bytes.
struct PulseTrain {
  std::shared_ptr<const Toolpath> path;
  std::size_t first = 0;            ///< segment of block 0; lines and arcs only from there on
  int filters = 3;                  ///< n, 2 or 3
  double filter_time = 0;           ///< T1 > 0 [s]
  double largest_feed = 0;          ///< of the pulses [mm/s]
  std::vector<BlockPulses> blocks;  ///< and one more for the end: standstill from its `start`
  /// The programmed path where `path`, which corresponds to it segment by segment, is a different one; else
  /// null.
  std::shared_ptr<const Toolpath> programmed = nullptr;

  std::size_t size() const { return blocks.size() - 1; }
  double delay() const { return filters * filter_time; }           ///< n T1 [s]
  double half_delay() const { return filters * filter_time / 2; }  ///< c [s]
  double end() const { return blocks.back().start; }               ///< of the pulses [s]
  double duration() const { return end() + delay(); }              ///< of the smoothed motion [s]
  const Segment& segment(std::size_t block) const { return path->segments[first + block]; }
  /// Arc of a block that is one.
  const Arc& arc(std::size_t block) const { return path->arc_of(segment(block)); }
  const Vec3& point(std::size_t block) const { return path->start_of(first + block); }  ///< its start [mm]
  /// Programmed start of a block [mm].
  const Vec3& programmed_point(std::size_t block) const {
    return (programmed != nullptr ? programmed : path)->start_of(first + block);
  }

  /// Widths by the heights of the pulses and the start of the next block.
  PulseWidths widths(std::size_t block) const;
  /// Block whose pulses are active at `t`; size() from the end on, 0 before the start.
  std::size_t block_at(double t) const;
  /// Pulses of `block` with a width above 0, in order; `block` = size(): the standstill at the end. Returns
  /// their number.
  std::size_t parts(std::size_t block, std::array<CommandPart, 3>& out) const;
  /// Commanded place on `block` at `t`, a time within its pulses [s], [mm].
  Vec3 commanded(std::size_t block, double t) const;
  /// Standstill before the start, from `time` < 0.
  CommandPart rest_before(double time) const;
};

}  // namespace feedscope
