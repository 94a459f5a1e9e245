#pragma once

#include "core/program/sinumerik/context.h"
#include "core/program/sinumerik/geometry/feeds.h"

namespace feedscope::sinumerik {

/// Cuts corners off: RND, CHF, CHR at the end of their block, RNDM at every corner; FRC and FRCM are their
/// feeds.
class Corners : private Part {
 public:
  /// Both outlive it.
  Corners(Context& context, const Feeds& feeds) : Part(context), feeds_(feeds) {}

  /// Applies RNDM and FRCM of the block.
  void run_modal();
  /// Cuts the end of the next motion, if it is a line or arc: by the corner of the block, else by RNDM.
  void cut(bool at_line_or_arc) const;

  /// Modal state.
  struct Modes {
    double rounding = 0;  ///< RNDM [mm]; 0: none
    double feed = 0;      ///< FRCM as written; 0: none
  };
  const Modes& modes() const { return modes_; }
  void restore(const Modes& modes) { modes_ = modes; }

 private:
  const Feeds& feeds_;
  Modes modes_;
};

}  // namespace feedscope::sinumerik
