#include "core/program/cycles/tapping.h"

#include <cmath>

namespace feedscope {

void tap(const Tapping& tapping, DrillPlan& plan) {
  const double total = std::abs(tapping.surface - tapping.bottom);
  const double into = tapping.bottom < tapping.surface ? -1 : 1;
  const double strokes = tapping.stroke > 0 ? std::ceil(total / tapping.stroke - 1e-9) : 1;
  for (double stroke = 1; stroke < strokes && strokes <= max_tapping_strokes; ++stroke) {
    const double depth = stroke * tapping.stroke;
    plan.feed(tapping.surface + into * depth, tapping.down);
    plan.feed(tapping.lift > 0 ? tapping.surface + into * (depth - tapping.lift) : tapping.safe,
              tapping.back);
  }
  plan.feed(tapping.bottom, tapping.down);
  plan.dwell(tapping.dwell);
  plan.feed(tapping.safe, tapping.back);
}

}  // namespace feedscope
