#pragma once

#include <memory>
#include <utility>

#include "core/load/load_model.h"
#include "core/trajectory/trajectory.h"

namespace feedscope {

/// Engagement of the tools of a program, along the motion of one of its runs.
class RunLoad {
 public:
  RunLoad(std::shared_ptr<const Trajectory> trajectory, LoadModel model)
      : trajectory_(std::move(trajectory)), model_(std::move(model)) {}

  const Trajectory& trajectory() const { return *trajectory_; }
  const LoadModel& model() const { return model_; }

 private:
  std::shared_ptr<const Trajectory> trajectory_;
  LoadModel model_;
};

}  // namespace feedscope
