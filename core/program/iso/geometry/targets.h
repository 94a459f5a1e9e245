#pragma once

#include <array>
#include <string_view>

#include "core/base/geometry.h"
#include "core/program/iso/context.h"

namespace feedscope::iso {

/// Letters of an arc's centre along X, Y and Z.
inline constexpr std::string_view center_letters = "IJK";

/// Places named by the words of the block: in Cartesian coordinates, or by radius and angle (G16, "@" and "^"
/// of LinuxCNC). Programmed coordinates, mm.
class Targets : private Part {
 public:
  /// `context` outlives it.
  explicit Targets(Context& context) : Part(context) {}

  /// End of the block's motion. The angle and radius of G16 are stored from block to block.
  Vec3 target();
  /// X Y Z of the block, absolute or relative to `place`.
  Vec3 target_from(const Vec3& place) const;
  /// X Y Z as written; `otherwise` for missing ones.
  Vec3 axes(const Vec3& otherwise) const;
  /// I J K, as a position or as an offset from the start.
  Vec3 center(bool absolute) const;
  /// Axes X, Y and Z named by the block; all of them if it names none.
  std::array<bool, 3> named_axes() const;
  /// Marks the axes of the block as programmed, for the path's extent and known places.
  void program_axes() const;
  static constexpr double implausible_length = 3000;  ///< beyond any machine's travel [mm]
  static constexpr double implausible_peck = 100;     ///< of a drill [mm]
  /// Reports a length of the block without a decimal point that is `implausible` or longer [mm], but
  /// plausible in the thousandths in which many controls read it. LinuxCNC and grbl do not read it so.
  void check_point(char letter, double implausible) const;

  /// G15, G16.
  void set_polar(bool on) { polar_ = {.on = on}; }

 private:
  /// G15, G16: the words of the plane's axes are radius and angle.
  struct Polar {
    bool on = false;
    Vec3 center = Vec3::Zero();  ///< [mm]
    double radius = 0;           ///< [mm]
    double angle = 0;            ///< [rad]
  };

  Vec3 polar_target(Vec3 target);
  Vec3 distance_and_angle_target(Vec3 target) const;

  Polar polar_;
};

}  // namespace feedscope::iso
