#pragma once

#include <array>
#include <optional>

#include "core/base/geometry.h"
#include "core/program/sinumerik/context.h"

namespace feedscope::sinumerik {

/// Places named by the words of the block: Cartesian, polar (AP, RP), by an angle (ANG), X as a diameter
/// (DIAMON). Programmed coordinates [mm].
class Targets : private Part {
 public:
  /// `context` outlives it.
  explicit Targets(Context& context) : Part(context) {}

  /// End of the block's motion that starts at `start`.
  Vec3 target(const Vec3& start) const;
  /// I J K, relative to the position or by AC(). Missing ones are those of the position.
  Vec3 center() const;
  const Vec3& pole() const { return modes_.pole; }

  /// Marks the axes of the block as programmed: AP and RP stay in force, the places of the axes are known.
  void program_axes();
  void program_axis(int axis);
  /// Call at a change of frame: an increment of an axis starts from its current place.
  void keep_coordinates();

  /// G110 to G112.
  void set_pole();
  /// Call at a change of plane.
  void end_polar_angle() { modes_.polar.angle.reset(); }
  /// Action::diameters, diameters_if_absolute or radii.
  void set_diameters(Action action) { modes_.diameters = action; }

  /// About the pole; none: not programmed yet.
  struct Polar {
    std::optional<double> angle;   ///< [rad]
    std::optional<double> radius;  ///< [mm]
  };
  /// Modal state.
  struct Modes {
    Vec3 pole = Vec3::Zero();
    Polar polar;
    Action diameters = Action::radii;  ///< of X
  };
  const Modes& modes() const { return modes_; }
  void restore(const Modes& modes) { modes_ = modes; }

 private:
  bool is_diameter(const BlockWords::Value& word) const;
  double increment_base(int axis, const Vec3& start) const;
  Polar polar_of_block() const;
  Vec3 polar_target(const Vec3& straight_target) const;
  void angle_target(Vec3& target) const;

  Modes modes_;
  /// Previous coordinates of axes that have not been programmed since a frame changed [mm].
  std::array<std::optional<double>, 3> kept_coordinates_;
};

}  // namespace feedscope::sinumerik
