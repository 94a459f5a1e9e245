#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "core/program/heidenhain/geometry/motion.h"

namespace feedscope::heidenhain {

/// Calls of cycles that move first: CYCL CALL, CYCL CALL POS, CYCL CALL PAT, G79.
class CycleCalls : private Part {
 public:
  /// All outlive it.
  CycleCalls(Context& context, const CycleParameters& parameters, Cycles& cycles, const Targets& targets,
             Motions& motions)
      : Part(context), parameters_(parameters), cycles_(cycles), targets_(targets), motions_(motions) {}

  /// Runs after the functions of the block.
  void call(const MotionWords& words, std::uint32_t column);
  void call_at(const MotionWords& words, std::uint32_t column);
  void call_at_pattern(const MotionWords& words, std::uint32_t column);
  /// PATTERN DEF: places of CYCL CALL PAT, along the tool axis offsets of the surface [mm].
  void set_pattern(std::vector<Vec3> places) { pattern_ = std::move(places); }

 private:
  const CycleParameters& parameters_;
  Cycles& cycles_;
  const Targets& targets_;
  Motions& motions_;
  std::vector<Vec3> pattern_;
};

}  // namespace feedscope::heidenhain
