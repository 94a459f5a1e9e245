#pragma once

#include "core/models/control_model.h"

namespace feedscope {

/// Connecting arcs, compaction, static and dynamic look-ahead (Sinumerik 840D, Heidenhain TNC 430).
///
/// E. B. Msaddek, Z. Bouaziz, M. Baili, G. Dessein, "Modeling and simulation of high-speed milling centers
/// dynamics", Int J Adv Manuf Technol 53 (2011) 877-888; equations in README.md in this folder.
/// Symbols: TIT interpolation tolerance of the trajectory (the contour tolerance), b direction change, R
/// radius, L block length, t_cy interpolation period, V_s static feed.
///
/// Static look-ahead, eq 4-18: every block and every connecting arc has one feed, the least of the programmed
/// one, L/t_cy (R b/t_cy on an arc), what axis velocities allow, sqrt(R A_n), (J_t R^2)^(1/3) and
/// (J_tcurv R^2)^(1/3). The feed jumps where they meet. Dynamic look-ahead: the same feeds as ceilings,
/// reached and left by jerk-limited ramps, crossings of line and arc or of two arcs by eq 3, and at every
/// junction a speed from which standstill is reached within N blocks.
///
/// Departures from print:
///  - Eq 6 takes one least limit over all axes of the arc; here each axis limits where it moves, as on the
///    arcs of Tapie 2007 (arc_limits()).
///  - Eq 20 and 21 change the feed within |V_i - V_(i-1)| t_cy, which no axis could follow (0 to 15 m/min in
///    0.5 mm): the shared ramps of core/feed/ramp.h are used.
///  - Eq 1 on blocks of a few TIT: see connecting_arc().
/// Beyond the paper: arcs of connection in any plane, helices, dwells and rapids; a corner that touches a
/// programmed arc, and a reversal, is an exact stop of the dynamic look-ahead.
class MsaddekModel : public ControlModel {
 public:
  const ModelInfo& info() const override;
  Guarantees guarantees(const Settings& settings) const override;

 private:
  Trajectory do_simulate(const std::shared_ptr<const Toolpath>& toolpath, const Machine& machine,
                         const Settings& settings, Progress* progress) const override;
  Explanation do_explain(const SimulatedMotion& motion, const State& state) const override;
};

}  // namespace feedscope
