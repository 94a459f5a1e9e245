#pragma once

#include <optional>

#include "core/analysis/run.h"
#include "core/limits/formula.h"
#include "core/models/essid/blend_law.h"
#include "core/models/klipper/klipper_limits.h"

namespace feedscope {

/// Limits of single elements of a run as formulas, with the functions that its model took them from.
class ElementLimits {
 public:
  /// `run` outlives this.
  explicit ElementLimits(const Run& run);

  /// Largest acceleration and jerk of a ramp over `element`: of lines and arcs all of it, on corner blends
  /// what the radial shares leave.
  Formula path_acceleration(std::uint32_t element) const;
  Formula path_jerk(std::uint32_t element) const;

  /// The ceiling [mm/s] that `cause` sets for a line, an arc or a connecting arc; none if it cannot.
  Formula speed(Cause cause, std::uint32_t element) const;
  /// The same of a cubic blend at its parameter `u`, without acceleration along the path: at constant speed,
  /// or, where `steady`, at constant du/dt.
  Formula blend_speed(Cause cause, const BlendShape& shape, double u, bool steady) const;
  BlendShape blend_shape(std::uint32_t element) const;
  /// At the junction before `element`; none where the curvature does not jump.
  Formula crossing(std::uint32_t element) const;
  /// From the junction before `element` standstill must be reached within the look-ahead.
  Formula horizon(std::uint32_t element) const;

  /// Speed limit of grbl and of Klipper in the corner before `element`; none where there is no corner.
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
  /// Of those that an element is on, where their time limits the feed [mm].
  double shortest_block(std::uint32_t element) const;
  Formula stop_within(std::uint32_t element) const;
  Formula acceleration_along(std::uint32_t element) const;
  Formula velocity_along(std::uint32_t element) const;
  std::optional<Formula> cutting_feed(Cause cause, std::uint32_t element) const;
  /// Klipper's limits in force at an element.
  const KlipperSettings& limits_along(std::uint32_t element) const;
  /// The arc of an element that runs on one; null for a line.
  const Arc* programmed_arc(std::uint32_t element) const;
  bool accelerates_by_jumps(std::uint32_t element) const;

  const Run& run_;
  const BlendedPath& path_;
  const LimitTraits& traits_;
  AxisVectors axes_;
  std::optional<KlipperLimits> along_;  ///< of models that limit along the path
};

}  // namespace feedscope
