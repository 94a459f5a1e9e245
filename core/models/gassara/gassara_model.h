#pragma once

#include "core/models/control_model.h"

namespace feedscope {

/// Corners blended by circular arcs that are passed at constant speed.
///
/// B. Gassara et al., "Analytical and experimental study of feed rate in high-speed milling", Mach Sci
/// Technol 17 (2013) 181-208, as compared in Essid 2019, section 4.3; README.md in this
/// folder. Corners are laid out as by the essid model (same eps, same shares); the blend is a circular
/// arc of that eps, and its limits are those of tangent and normal, not of the axes: at constant speed the
/// acceleration v^2/R lies across the path, the jerk v^3/R^2 along it. Symbols: eps distance of the corner
/// from the arc, R its radius, R_A and R_J radial shares.
///
/// Departure: blends with hardly any line between them are passed
/// within ramps (blend_chains.h), else a whole chain would run at what its first half block reached; the same
/// shares apply, v' <= (1 - R_A) A, v'' + v^3/R^2 <= (1 - R_J) Jtb, 3 v v'/R <= R_J Jtb.
///
/// Beyond the source: limits of tangent and normal are the least of the axes that the arc moves; arcs of the
/// program, tangent junctions and stops are those of the essid model.
class GassaraModel : public ControlModel {
 public:
  const ModelInfo& info() const override;
  Guarantees guarantees(const Settings& settings) const override;

 private:
  Trajectory do_simulate(const std::shared_ptr<const Toolpath>& toolpath, const Machine& machine,
                         const Settings& settings, Progress* progress) const override;
  Trajectory do_lay_path(const std::shared_ptr<const Toolpath>& toolpath, const Machine& machine,
                         const Settings& settings, Progress* progress) const override;
  Explanation do_explain(const SimulatedMotion& motion, const State& state) const override;
};

}  // namespace feedscope
