#pragma once

#include <vector>

#include "core/base/geometry.h"
#include "core/load/angle_integrals.h"
#include "core/load/engagement.h"
#include "core/load/material.h"

namespace feedscope {

/// Forces of an operation on its tool over a revolution, by the feed per tooth f_z; equations in README.md
/// next to this file, after Altintas, Manufacturing Automation, section 2.8. Circular tooth path: the chip
/// thickness is h = f_z sin(phi). Components: along the feed, along the normal on its left, along the tool's
/// axis; means do not depend on the helix.
///
/// Everything is prepared once; evaluating a feed costs some dozens of products and no allocation.
class CuttingForce {
 public:
  CuttingForce(const Engagement& operation, const Material& material);

  /// Figures over a revolution at one feed per tooth.
  struct Figures {
    Vec3 mean = Vec3::Zero();  ///< force on the tool [N]
    double peak = 0;           ///< largest hypot(feed, normal) over the rotation [N]
    double torque = 0;         ///< mean [N mm]
  };
  /// `feed_per_tooth` >= 0 [mm]. At 0 the edge forces of the linear law remain.
  Figures at(double feed_per_tooth) const;

  double largest_chip(double feed_per_tooth) const { return largest_sine_ * feed_per_tooth; }  ///< [mm]
  /// Mean over the immersion [mm].
  double mean_chip(double feed_per_tooth) const { return mean_sine_ * feed_per_tooth; }
  /// Force on the tool with one of its teeth at angle `rotation` at the tip, summed over all teeth, including
  /// the lag of the helix over the axial depth [N].
  Vec3 force_at(double feed_per_tooth, double rotation) const;

 private:
  /// Part proportional to f_z^q, and part independent of it.
  struct Parts {
    Vec3 chip = Vec3::Zero();
    Vec3 edge = Vec3::Zero();
  };
  /// chip g + edge|^2 in the plane as a polynomial in g = f_z^q.
  struct Square {
    double quadratic = 0;
    double linear = 0;
    double constant = 0;
    double at(double g) const { return (quadratic * g + linear) * g + constant; }
  };

  Parts density(double angle) const;
  Parts integral(double from, double to) const;
  Parts parts_at(double rotation) const;
  double power_of(double feed_per_tooth) const;
  void find_peaks();

  ForceLaw law_;
  AngleIntegrals integrals_;
  Immersion immersion_;
  double pitch_ = 0;  ///< angle between teeth [rad]
  double depth_ = 0;  ///< a_p [mm]
  double lag_ = 0;    ///< of the helix over the depth [rad]
  Parts mean_;
  double chip_torque_ = 0;  ///< proportional to f_z^q [N mm]
  double edge_torque_ = 0;  ///< [N mm]
  double largest_sine_ = 0;
  double mean_sine_ = 0;
  std::vector<Square> peaks_;  ///< of the rotations that may have the largest force at some feed
};

}  // namespace feedscope
