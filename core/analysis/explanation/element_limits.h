#pragma once

#include <optional>

#include "core/analysis/run/run.h"
#include "core/limits/formula.h"
#include "core/models/essid/blend_law.h"
#include "core/models/klipper/klipper_limits.h"

namespace feedscope {

/// Limits of single elements of a run as formulas, by the same functions that its model uses.
class ElementLimits {
 public:
  /// `run` outlives this.
  explicit ElementLimits(const Run& run);

  /// Largest acceleration and jerk of a ramp over `element`: the whole limit on lines and arcs, on corner
  /// blends what the radial shares leave.
  Formula path_acceleration(std::uint32_t element) const;
  Formula path_jerk(std::uint32_t element) const;

  /// Speed ceiling [mm/s] that `cause` sets for a line, an arc or a connecting arc; none if it cannot.
  Formula speed(Cause cause, std::uint32_t element) const;
  /// Speed ceiling of a cubic blend at its parameter `u`, without acceleration along the path: at constant
  /// speed, or if `steady` at constant du/dt.
  Formula blend_speed(Cause cause, const BlendShape& shape, double u, bool steady) const;
  BlendShape blend_shape(std::uint32_t element) const;
  /// Limit at the junction before `element`; none unless the curvature jumps there.
  Formula crossing(std::uint32_t element) const;
  /// Limit from the junction before `element`: standstill must be possible within the look-ahead.
  Formula horizon(std::uint32_t element) const;

  /// Speed limits of grbl and of Klipper in the corner before `element`; none without a corner.
  Formula junction_deviation(std::uint32_t element) const;
  Formula square_corner(std::uint32_t element) const;

  const LimitTraits& traits() const { return traits_; }
  const AxisVectors& axes() const { return axes_; }
  double setting(std::string_view key) const;

 private:
  Formula min_share(FormulaId id, Symbol limit, const Vec3& limits, const Vec3& parts) const;
  Formula blend_rest(FormulaId id, Symbol share, Symbol limit, std::uint32_t element) const;
  Formula arc_speed(Cause cause, const Arc& arc) const;
  Formula arc_velocity(Cause cause, const Arc& arc) const;
  Formula connecting_arc_speed(Cause cause, double radius) const;
  Formula curve_speed(Cause cause, std::uint32_t element) const;
  Formula curve_ramp(bool by_jerk, std::uint32_t element) const;
  std::size_t block(std::uint32_t element) const;
  /// Length of the shortest block of an element, if its time limits the feed [mm].
  double shortest_block(std::uint32_t element) const;
  Formula stop_within(std::uint32_t element) const;
  Formula acceleration_along(std::uint32_t element) const;
  Formula velocity_along(std::uint32_t element) const;
  std::optional<Formula> cutting_feed(Cause cause, std::uint32_t element) const;
  /// Limits of Klipper in force at an element.
  const KlipperSettings& limits_along(std::uint32_t element) const;
  /// Arc of an element that runs on one; null for a line.
  const Arc* programmed_arc(std::uint32_t element) const;
  bool accelerates_by_jumps(std::uint32_t element) const;

  const Run& run_;
  const BlendedPath& path_;
  const LimitTraits& traits_;
  AxisVectors axes_;
  std::optional<KlipperLimits> along_;  ///< of models with limits along the path
};

}  // namespace feedscope
