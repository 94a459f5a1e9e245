#pragma once

#include "core/models/control_model.h"

namespace feedscope {

/// LinuxCNC with its trapezoidal planner (README.md in this folder): G64 P Q, blend arcs, exact stops.
class LinuxCncModel : public ControlModel {
 public:
  const ModelInfo& info() const override;
  Guarantees guarantees(const Settings& settings) const override;
  std::vector<const char*> left_out(const Toolpath& path, const Settings& settings) const override;

 private:
  Trajectory do_simulate(const std::shared_ptr<const Toolpath>& toolpath, const Machine& machine,
                         const Settings& settings, Progress* progress) const override;
  Explanation do_explain(const SimulatedMotion& motion, const State& state) const override;
};

}  // namespace feedscope
