#pragma once

#include "core/models/control_model.h"

namespace feedscope {

/// Local smoothing by cubic Hermite blends on a Sinumerik 840D.
///
/// M. Essid et al., "Analytical modeling of the CNC machine axis motion in high-speed milling with local
/// smoothing", Int J Adv Manuf Technol 105 (2019) 457-470; equations in README.md in this folder.
/// Symbols: U, V unit directions in and out, phi their angle, rho contour tolerance, eps = beta rho, T
/// transition length, u parameter of a blend, R_A and R_J radial shares, Jtb jerk on blends, t_s sampling
/// time.
///
/// Departures from print are named where they are made: corner.h (eq 13), blend_law.h (eq 23, 24, 26, 29,
/// 30). Beyond the paper:
///  - A blend at a planned node (see node_plan.h) runs the law of the paper; one that is passed within a
///  longer
///    ramp, as in dense short blocks, runs that ramp by path length.
///  - A corner that turns by more than 2 rad is passed at constant du/dt: eq 26 looks at u = 0 only, and
///  there the
///    curvature peaks in the middle (see blend_law.h).
///  - Arcs and tangent junctions keep the static limits of Tapie 2007 (segment_limits.h); corners that touch
///    an arc and corners with a rapid are exact stops.
/// Readings: `corrected` carries the acceleration at a blend's end on; `published` drops it to 0, as the
/// figures of the paper compare; `strict` passes a blend at constant du/dt with every row of eq 24 kept, and
/// blends that follow each other without a line between them, or nearly so, by a du/dt that ramps over many
/// of them, with every row kept too (parameter_ramps() in blend_law.h).
class EssidModel : public ControlModel {
 public:
  const ModelInfo& info() const override;
  Guarantees guarantees(const Settings& settings) const override;

 private:
  Trajectory do_simulate(const std::shared_ptr<const Toolpath>& toolpath, const Machine& machine,
                         const Settings& settings, Progress* progress) const override;
  Trajectory do_lay_path(const std::shared_ptr<const Toolpath>& toolpath, const Machine& machine,
                         const Settings& settings, Progress* progress) const override;
};

}  // namespace feedscope
