#pragma once

#include <cstdint>
#include <vector>

#include "core/analysis/agreement/programmed_course.h"
#include "core/analysis/agreement/time_law.h"

namespace feedscope {

/// Feed through a corner of the program: mean from `reach` before it to `reach` after it, without the time of
/// standstills.
struct CornerAgreement {
  std::uint32_t line = 0;  ///< of the block that ends there
  double s = 0;            ///< programmed path length [mm]
  Vec3 place = Vec3::Zero();
  double turn = 0;           ///< change of direction [rad]
  double reach = 0;          ///< [mm]
  double measured_feed = 0;  ///< [mm/s]
  double simulated_feed = 0;

  double error() const { return measured_feed > 0 ? simulated_feed / measured_feed - 1 : 0; }
};

/// Corners of at least 5 degrees between `from` and `to` of the programmed path [mm], in its order. Reach:
/// 0.5 mm, or half of the shorter block; corners with less than `least_reach` are omitted [mm].
std::vector<CornerAgreement> corners_of(const Toolpath& toolpath, const ProgrammedCourse& course,
                                        const TimeLaw& measured, const TimeLaw& simulated, double from,
                                        double to, double least_reach);

}  // namespace feedscope
