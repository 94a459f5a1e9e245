#pragma once

#include <optional>
#include <string_view>

#include "core/limits/segment_limits.h"
#include "core/models/essid/blend_law.h"
#include "core/models/explanation/reason.h"

namespace feedscope {

/// Half the angle between the blocks that meet in a corner.
struct HalfTurn {
  double sine = 1;  ///< 1: straight on
  double cosine = 0;
};

/// Limits of single elements of a motion as formulas, by the same functions that models use. A model whose
/// limits are others overrides them.
class ElementLimits {
 public:
  /// What `motion` refers to outlives this.
  explicit ElementLimits(const SimulatedMotion& motion);
  virtual ~ElementLimits() = default;
  ElementLimits(const ElementLimits&) = delete;
  ElementLimits& operator=(const ElementLimits&) = delete;

  /// Largest acceleration and jerk of a ramp over `element`: the whole limit on lines and arcs, on corner
  /// blends what the radial shares leave.
  virtual Formula path_acceleration(std::uint32_t element) const;
  Formula path_jerk(std::uint32_t element) const;

  /// Speed ceiling [mm/s] that `cause` sets for a line, an arc or a connecting arc; none if it cannot.
  Formula speed(Cause cause, std::uint32_t element) const;
  /// Speed ceiling of a cubic blend at its parameter `u`, without acceleration along the path: at constant
  /// speed, or if `steady` at constant du/dt.
  Formula blend_speed(Cause cause, const BlendShape& shape, double u, bool steady) const;
  BlendShape blend_shape(std::uint32_t element) const;
  /// Limit at the junction before `element`; none if `kind` sets none there. Of the curvature that jumps
  /// there, and of the look-ahead, within which standstill must be possible.
  virtual Formula junction(CauseKind kind, std::uint32_t element) const;

  /// Paper and equation of a formula as the model uses it.
  virtual std::string_view source_of(FormulaId id) const;
  /// Reason at an element, with its source.
  Reason made(Cause cause, Formula formula, double reached, std::uint32_t element) const;

 protected:
  /// Components of the directions along and across an arc that its limits are taken for.
  struct ArcParts {
    Vec3 velocity;  ///< along, for velocities
    Vec3 tangent;   ///< along, for the jerk of turning
    Vec3 normal;
  };
  /// The largest all along the arc.
  virtual ArcParts parts_of(const Arc& arc) const;
  /// Whether ramps over a corner blend take only what the radial shares leave.
  virtual bool shares_corners() const { return true; }
  /// Ceiling that the control itself sets in place of the axes; none if it sets none.
  virtual std::optional<Formula> velocity_of_control(std::uint32_t /*element*/) const { return std::nullopt; }

  const BlendedPath& path() const { return path_; }
  const Trajectory& trajectory() const { return motion_.trajectory; }
  const SimulatedMotion& motion() const { return motion_; }
  const AxisVectors& axes() const { return axes_; }
  double setting(std::string_view key) const { return motion_.settings.number(key); }
  /// In the corner before `element`; none at a dwell or where the path reverses.
  std::optional<HalfTurn> half_turn(std::uint32_t element) const;

 private:
  Formula min_share(FormulaId id, Symbol limit, const Vec3& limits, const Vec3& parts) const;
  Formula blend_rest(FormulaId id, Symbol share, Symbol limit, std::uint32_t element) const;
  Formula arc_speed(Cause cause, const Arc& arc) const;
  Formula connecting_arc_speed(Cause cause, double radius) const;
  Formula curve_speed(Cause cause, std::uint32_t element) const;
  Formula curve_ramp(bool by_jerk, std::uint32_t element) const;
  Formula crossing(std::uint32_t element) const;
  Formula horizon(std::uint32_t element) const;
  std::size_t block(std::uint32_t element) const { return path_.base_segment_of(element); }
  /// Length of the shortest block of an element, if its time limits the feed [mm].
  double shortest_block(std::uint32_t element) const;
  std::optional<Formula> cutting_feed(Cause cause, std::uint32_t element) const;
  /// Arc of an element that runs on one; null for a line.
  const Arc* programmed_arc(std::uint32_t element) const;
  bool accelerates_by_jumps(std::uint32_t element) const;

  SimulatedMotion motion_;
  const BlendedPath& path_;
  AxisVectors axes_;
};

}  // namespace feedscope
