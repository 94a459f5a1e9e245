#pragma once

#include "core/program/sinumerik/context.h"

namespace feedscope::sinumerik {

/// Feed and spindle speed: F, S, and the G words that define their meaning (G93 to G97, G961 to G973).
class Feeds : private Part {
 public:
  explicit Feeds(Context& context) : Part(context) {}

  /// `function` has an action of Group::feed_mode.
  void set_mode(const Function& function);
  /// F and S of the block.
  void run();
  /// Feed of a number in the sense of F, in the unit of PathWriter::set_feed().
  double feed_of(double value) const;

  /// True under G96, G961: S is not a spindle speed.
  bool has_surface_speed() const { return surface_speed_; }
  void restore_surface_speed(bool on) {
    surface_speed_ = on;
    path().spindle().set_surface_speed(on);
  }

 private:
  bool surface_speed_ = false;
};

}  // namespace feedscope::sinumerik
