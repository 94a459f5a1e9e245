#include "core/program/path/b_spline.h"

#include <algorithm>
#include <array>

namespace feedscope {

std::vector<double> clamped_knots(std::size_t count, std::size_t degree) {
  std::vector<double> knots(count + degree + 1);
  for (std::size_t i = 0; i < knots.size(); ++i) {
    knots[i] = static_cast<double>(std::clamp(i, degree, count) - degree);
  }
  return knots;
}

CurvePlace b_spline_place(std::span<const Eigen::Vector4d> points, std::span<const double> knots,
                          std::size_t degree, std::size_t interval, double parameter) {
  std::array<Eigen::Vector4d, max_spline_degree + 1> d;
  std::copy_n(points.begin() + static_cast<std::ptrdiff_t>(interval - degree), degree + 1, d.begin());
  Eigen::Vector4d slope = Eigen::Vector4d::Zero();
  for (std::size_t level = 1; level <= degree; ++level) {
    if (level == degree) {
      const double width = knots[interval + 1] - knots[interval];
      slope = static_cast<double>(degree) / width * (d[degree] - d[degree - 1]);
    }
    for (std::size_t j = degree; j >= level; --j) {
      const std::size_t i = interval - degree + j;
      const double width = knots[i + degree - level + 1] - knots[i];
      const double share = width > 0 ? (parameter - knots[i]) / width : 0;
      d[j] = (1 - share) * d[j - 1] + share * d[j];
    }
  }
  const double weight = d[degree][3];
  const Vec3 point = d[degree].head<3>() / weight;
  return {point, (slope.head<3>() - slope[3] * point) / weight};
}

}  // namespace feedscope
