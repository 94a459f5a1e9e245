#pragma once

#include "core/models/control_model.h"

namespace feedscope {

/// grbl 1.1 (README.md in this folder): junction deviation, 15 blocks ahead, segments of 10 ms.
class GrblModel : public ControlModel {
 public:
  const ModelInfo& info() const override;
  Guarantees guarantees(const Settings& settings) const override;

 private:
  ControlReading do_read(const std::shared_ptr<const Toolpath>& toolpath, const Settings& settings,
                         const Progress* progress) const override;
  Trajectory do_simulate(const std::shared_ptr<const Toolpath>& toolpath, const Machine& machine,
                         const Settings& settings, Progress* progress) const override;
  Explanation do_explain(const SimulatedMotion& motion, const State& state) const override;
};

}  // namespace feedscope
