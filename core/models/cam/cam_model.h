#pragma once

#include "core/models/control_model.h"

namespace feedscope {

/// Time that a CAM system shows: every block at its programmed feed from end to end, rapids at the axes'
/// speed, dwells; acceleration takes no time (README.md in this folder). The reference for every other model.
class CamModel : public ControlModel {
 public:
  const ModelInfo& info() const override;
  Guarantees guarantees(const Settings& settings) const override;

 private:
  Trajectory do_simulate(const std::shared_ptr<const Toolpath>& toolpath, const Machine& machine,
                         const Settings& settings, Progress* progress) const override;
  Explanation do_explain(const SimulatedMotion& motion, const State& state) const override;
};

}  // namespace feedscope
