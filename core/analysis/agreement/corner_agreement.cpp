#include "core/analysis/agreement/corner_agreement.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/blend/junction.h"

namespace feedscope {
namespace {

constexpr double least_turn = 5 * std::numbers::pi / 180;  // [rad]
constexpr double usual_reach = 0.5;                        // [mm]

double mean_feed(const TimeLaw& law, double s, double reach) {
  const double standing = law.at(s, 1) - law.at(s, 0);
  const double time = law.at(s + reach) - law.at(s - reach) - standing;
  return time > 0 ? 2 * reach / time : 0;
}

}  // namespace

std::vector<CornerAgreement> corners_of(const Toolpath& toolpath, const ProgrammedCourse& course,
                                        const TimeLaw& measured, const TimeLaw& simulated, double from,
                                        double to, double least_reach) {
  std::vector<CornerAgreement> corners;
  for (std::size_t i = 1; i < toolpath.segments.size(); ++i) {
    const Segment& before = toolpath.segments[i - 1];
    const Segment& behind = toolpath.segments[i];
    const double reach = std::min({usual_reach, before.length / 2, behind.length / 2});
    const double s = course.start_of(static_cast<std::uint32_t>(i));
    if (reach < least_reach || s - reach < from || s + reach > to) {
      continue;
    }
    const Vec3 in = toolpath.tangent_at_end(i - 1);
    const Vec3 out = toolpath.tangent_at_start(i);
    const Vec3 seen_in = course.visible(in);
    const Vec3 seen_out = course.visible(out);
    const double turn = turn_angle(in, out);
    constexpr double seen_well = 0.5;
    if (turn < least_turn || std::atan2(seen_in.cross(seen_out).norm(), seen_in.dot(seen_out)) < least_turn ||
        seen_in.norm() < seen_well || seen_out.norm() < seen_well) {
      continue;
    }
    const CornerAgreement corner{before.line,
                                 s,
                                 before.end,
                                 turn,
                                 reach,
                                 mean_feed(measured, s, reach),
                                 mean_feed(simulated, s, reach)};
    if (corner.measured_feed > 0 && corner.simulated_feed > 0) {
      corners.push_back(corner);
    }
  }
  return corners;
}

}  // namespace feedscope
