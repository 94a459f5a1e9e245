#pragma once

#include <optional>

#include "core/program/iso/context.h"
#include "core/program/iso/cycles/cycles.h"
#include "core/program/iso/geometry/splines.h"
#include "core/program/iso/geometry/targets.h"

namespace feedscope::iso {

/// Runs the motion of a block whose words are gathered: lines, arcs, cycles, splines, dwells.
class Motions : private Part {
 public:
  /// All outlive it.
  Motions(Context& context, Targets& targets, Cycles& cycles, Splines& splines)
      : Part(context), targets_(targets), cycles_(cycles), splines_(splines) {}

  void run();

 private:
  void move();
  void move_to_exact_stop();
  bool has_motion_words() const;
  void arc();
  double extra_turns() const;
  void check_center_axis() const;
  void check_inverse_time() const;
  void report_no_motion_word() const;
  /// ",R" and ",C" at the end of the next motion.
  void cut_corner(bool at_line_or_arc) const;

  Targets& targets_;
  Cycles& cycles_;
  Splines& splines_;
};

}  // namespace feedscope::iso
