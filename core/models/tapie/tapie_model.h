#pragma once

#include "core/models/control_model.h"

namespace feedscope {

/// Circular interpolation on a Sinumerik 840D.
///
/// L. P. Tapie, K. Mawussi, B. Anselmetti, "Circular tests for HSM machine tools: Bore machining
/// application", Int J Mach Tools Manuf 47 (2007) 805-819; equations in README.md in this folder.
/// Symbols: V_st feed set point, V_fr speed at a change of curvature, J_curv curvilinear jerk, r_jct its
/// tangential share, t_cy interpolation period, a_c angle at which the steady feed is reached.
///
/// Stage 1: set point of every arc (set_point.h). Stage 2: speeds at changes of curvature (crossing_speed in
/// segment_limits.h). Stage 3: jerk-limited ramps between them, with the least jerk J_t of the arc (eq 16 if
/// there is no steady phase).
///
/// Departures from print: eq 11 is a cube root; the least V_An of R 2.5 mm is 4.74 m/min, not 2.55; angles of
/// eq 7 to 9 are directions of the tangent, by their values; at a change of curvature the jerk is that
/// of the axes that make the step of the normal acceleration, in eq 15 the tangential one: the same where the
/// axes of the plane have one jerk, as everywhere in the paper's measurements. Beyond the paper:
///  - Any plane, helices, signed curvatures: from a line into an arc, and between arcs that turn opposite
///    ways.
///  - Lines: axis limits, V_tcy, the same ramps. Ramps keep the axis acceleration too, and run over several
///    blocks where nothing makes them end earlier.
///  - Corners are exact stops: the paper says that the control inserts a curve there (section 3.3.1), but not
///    which.
class TapieModel : public ControlModel {
 public:
  const ModelInfo& info() const override;
  Guarantees guarantees(const Settings& settings) const override;

 private:
  Trajectory do_simulate(const std::shared_ptr<const Toolpath>& toolpath, const Machine& machine,
                         const Settings& settings, Progress* progress) const override;
  Explanation do_explain(const SimulatedMotion& motion, const State& state) const override;
};

}  // namespace feedscope
