#pragma once

#include "core/models/control_model.h"

namespace feedscope {

/// The bound that no control can beat: on the path that another model runs, its blends included, the least
/// time that any law s(t) could take under the limits of the axes (README.md in this folder).
///
/// With T the tangent, c and d the second and third derivative of the path by path length:
///
///   velocity      v |T_j| <= V_j, programmed feed and rapids as ceilings
///   acceleration  |T_j v' + c_j v^2| <= A_j
///   jerk          |T_j v'' + 3 c_j v v' + d_j v^3| <= J_j, Jtb_j in corners; only with jerk=on
///
/// Primes of v by time. Without jerk limits the bound is exact but for its grid (AccelerationLaw); with them
/// it is the time of a law that keeps them and is close to the fastest (JerkLaw).
class OptimalModel : public ControlModel {
 public:
  const ModelInfo& info() const override;
  Guarantees guarantees(const Settings& settings) const override;

 private:
  bool takes_path_of_another() const override { return true; }
  Trajectory do_simulate(const std::shared_ptr<const Toolpath>& shared, const Machine& machine,
                         const Settings& settings, Progress* progress) const override;
  Explanation do_explain(const SimulatedMotion& motion, const State& state) const override;
};

}  // namespace feedscope
