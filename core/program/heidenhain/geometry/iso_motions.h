#pragma once

#include <optional>

#include "core/program/heidenhain/geometry/approaches.h"
#include "core/program/heidenhain/language/iso_block.h"

namespace feedscope::heidenhain {

/// Runs the motions of DIN/ISO blocks by the G codes in force.
class IsoMotions : private Part {
 public:
  /// All outlive it.
  IsoMotions(Context& context, Targets& targets, Motions& motions, Approaches& approaches)
      : Part(context), targets_(targets), motions_(motions), approaches_(approaches) {}

  /// False if the code is not a motion.
  bool set_motion(int code);
  void set_incremental(bool incremental) { incremental_ = incremental; }
  bool is_incremental() const { return incremental_; }
  /// G27: the next motion leaves the contour by an arc of this radius [mm].
  void leave_by(double radius, const std::optional<ContourFeed>& feed);

  void run(IsoBlock& block);
  /// Adds the rapid of G0 or G10 in force.
  MotionWords with_modal_rapid(MotionWords words) const;

 private:
  void set_pole(const IsoBlock& block);
  void set_radius(IsoBlock& block) const;
  void run_path(bool has_radius, const MotionWords& words);

  Targets& targets_;
  Motions& motions_;
  Approaches& approaches_;
  bool incremental_ = false;
  int motion_ = -1;                          ///< G in force; -1: none yet
  std::optional<double> leaving_radius_;     ///< G27, until the next motion [mm]
  std::optional<ContourFeed> leaving_feed_;  ///< of its arc
};

}  // namespace feedscope::heidenhain
