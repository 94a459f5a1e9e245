#pragma once

#include <cstdint>
#include <optional>

#include "core/program/iso/context.h"
#include "core/program/iso/cycles/drilling_cycle.h"
#include "core/program/iso/geometry/targets.h"

namespace feedscope::iso {

/// Runs the drilling cycles G73 to G89, at each block with a place until G80, and Haas's patterns of holes
/// (G70 to G72).
class Cycles : private Part {
 public:
  /// Both outlive it.
  Cycles(Context& context, Targets& targets) : Part(context), targets_(targets) {}

  /// G73 to G89.
  void begin(const GCode& code, const Word& word);
  /// G80.
  void cancel();
  /// Runs a block while a cycle is in force.
  void run();
  /// G70 to G72, around the tool's position.
  void run_pattern(int code, std::uint32_t column);

 private:
  /// Values shared by the blocks of a series of holes, along the tool's axis.
  struct Series {
    bool begun = false;
    double initial = 0;                ///< level before the series [mm]
    double retract = 0;                ///< [mm]
    double bottom = 0;                 ///< [mm]
    bool bottom_from_retract = false;  ///< as programmed with G91
    bool has_retract = false;
    bool has_bottom = false;
    double peck = 0;            ///< Q, or the first one, I of Haas [mm]
    double peck_less = 0;       ///< J of Haas: decrease of each peck [mm]
    double peck_least = 0;      ///< K of Haas [mm]
    Vec3 aside = Vec3::Zero();  ///< I J K of G76 and G87, instead of Q [mm]
    double dwell = 0;           ///< [s]
  };

  void gather();
  void gather_pecks();
  void return_to_retract_plane();
  bool check(std::uint32_t column) const;
  double bottom() const { return series_.bottom + (series_.bottom_from_retract ? series_.retract : 0); }
  /// None, with a report, without a bottom or with levels that do not fit.
  std::optional<DrillingCycle> drilling_cycle(std::uint32_t column, double repeats) const;
  double repeats() const;

  Targets& targets_;
  Series series_;
  MotionMode before_ = MotionMode::none;  ///< G0 to G3, to which Fanuc's G80 returns
};

}  // namespace feedscope::iso
