#include "core/drives/blend_course.h"

#include <gtest/gtest.h>

namespace feedscope {
namespace {

constexpr double blend_tolerance = 3e-9;

/// On the whole blend: from speed 40 mm/s, with an acceleration and a jerk.
Part part_over(double length, double acceleration, double jerk) {
  Part part;
  part.v = 40;
  part.a = acceleration;
  part.j = jerk;
  part.duration = time_to_reach({0, part.v, part.a, part.j}, length, 3 * length / part.v);
  return part;
}

/// Largest distance of the spans from where the blend is by its path length; and that they fill the part.
double largest_error(const CubicBlend& blend, const Part& part) {
  BlendCourse course(blend_tolerance);
  course.enter(blend, blend.length(), part);
  double from = 0;
  double largest = 0;
  SetSpan span;
  while (from < part.duration * (1 - 1e-12)) {
    if (!course.fill(span, from)) {
      ADD_FAILURE() << "no span at " << from << " of " << part.duration;
      break;
    }
    for (int i = 0; i <= 20; ++i) {
      const double h = span.duration * i / 20;
      const double s = advance({part.q, part.v, part.a, part.j}, from + h).q;
      largest = std::max(largest, (blend.at(blend.parameter_at(s)).position - span.at(h)).norm());
    }
    from += span.duration;
  }
  EXPECT_NEAR(from, part.duration, 1e-12 * (1 + part.duration));
  return largest;
}

// A part may begin where none of this blend came before: within it.
TEST(BlendCourse, BeginsAnywhereOnTheBlend) {
  const CubicBlend blend{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, 2.5};
  Part part = part_over(blend.length(), 0, 0);
  part.q = 0.4 * blend.length();
  part.duration *= 0.6;
  EXPECT_LT(largest_error(blend, part), 3 * blend_tolerance);
}

}  // namespace
}  // namespace feedscope
