#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "core/limits/axis_share.h"

namespace feedscope {

/// Range left by acceleration limits at one place of the path: with x = v^2 and u = s'' every line requires
///
///   -b + m x  <=  u  <=  b + m x
///
/// and x <= largest_x(). Lines j, j + 3, ... are those of axis j; b is infinite where an axis does not limit.
template <std::size_t Lines>
class LineRange {
 public:
  double lowest(double x) const {  ///< u [mm/s2]
    double u = -infinite;
    each_line([&](std::size_t j) { u = std::max(u, m_[j] * x - b_[j]); });
    return u;
  }
  double highest(double x) const {  ///< u [mm/s2]
    double u = infinite;
    each_line([&](std::size_t j) { u = std::min(u, m_[j] * x + b_[j]); });
    return u;
  }
  int axis_of_highest(double x) const {
    std::size_t lowest = 0;
    for (std::size_t j = 1; j < Lines; ++j) {
      lowest = m_[j] * x + b_[j] < m_[lowest] * x + b_[lowest] ? j : lowest;
    }
    return static_cast<int>(lowest % 3);
  }
  double b(std::size_t line) const { return b_[line]; }  ///< [mm/s2]
  double m(std::size_t line) const { return m_[line]; }  ///< [1/mm]
  /// Largest x for which some u is allowed, and its axis [mm2/s2].
  const AxisBound& largest_x() const { return largest_; }

  /// Largest of x - length lowest(x) for x in [0, most]: backwards through a cell that ends here.
  double reach_back(double most, double length) const {
    double steepest = 0;
    each_line([&](std::size_t j) { steepest = std::max(steepest, m_[j]); });
    return length * steepest > 1 ? reach_back_falling(most, length) : most - length * lowest(most);
  }
  /// Largest x with x + length lowest(x) <= `target`: backwards through a cell that begins here.
  double begin_back(double target, double length) const { return reach(target, length); }
  /// Largest x with x - length highest(x) <= `target`: forwards through a cell that ends here.
  double reach_on(double target, double length) const { return reach(target, -length); }

 protected:
  static constexpr double infinite = std::numeric_limits<double>::infinity();

  void lower(double x, std::size_t axis) {
    if (x < largest_.value) {
      largest_ = {x, static_cast<std::int8_t>(axis)};
    }
  }
  /// Lowers largest_ to the point where two lines leave no range between them.
  void lower_by_pairs() {
    for (std::size_t j = 0; j < Lines; ++j) {
      for (std::size_t k = j + 1; k < Lines; ++k) {
        const double apart = std::abs(m_[j] - m_[k]);
        if (b_[j] + b_[k] < largest_.value * apart) {
          lower((b_[j] + b_[k]) / apart, (std::abs(m_[j]) > std::abs(m_[k]) ? j : k) % 3);
        }
      }
    }
  }

  std::array<double, Lines> b_{};  ///< [mm/s2]
  std::array<double, Lines> m_{};  ///< [1/mm]
  AxisBound largest_{infinite, -1};

 private:
  template <typename Use>
  static void each_line(const Use& use) {
    [&]<std::size_t... Line>(std::index_sequence<Line...>) {
      (use(Line), ...);
    }
    (std::make_index_sequence<Lines>{});
  }

  double reach(double target, double signed_length) const {
    double x = largest_.value;
    each_line([&](std::size_t j) {
      const double slope = 1 + signed_length * m_[j];
      const double bound = (target + std::abs(signed_length) * b_[j]) / slope;
      x = slope > 0 && bound < x ? bound : x;
    });
    return x;
  }

  /// reach_back() where x - length lowest(x), the least of lines x (1 - length m) + length b, falls
  /// somewhere: it is largest at an end or where a rising line meets a falling one.
  double reach_back_falling(double most, double length) const {
    const auto value = [&](double x) { return x - length * lowest(x); };
    double best = std::max(value(most), value(0));
    for (std::size_t j = 0; j < Lines; ++j) {
      for (std::size_t k = 0; length * m_[j] > 1 && k < Lines; ++k) {
        if (length * m_[k] <= 1) {
          const double x = (b_[j] - b_[k]) / (m_[j] - m_[k]);
          best = x > 0 && x < most ? std::max(best, value(x)) : best;
        }
      }
    }
    return best;
  }
};

/// Limits of the axes at one place: with T the tangent and c the curvature vector every axis requires |T_j u
/// + c_j x| <= A_j, so that b_j = A_j / |T_j|, m_j = -c_j / T_j, and x <= A_j / |c_j| where T_j vanishes.
class AccelerationRange : public LineRange<3> {
 public:
  /// `t`, `c`: T_j / A_j and c_j / A_j; `tangent`: T.
  AccelerationRange(const Vec3& tangent, const Vec3& t, const Vec3& c);
};

/// Range allowed at all of three places.
class CommonRange : public LineRange<9> {
 public:
  CommonRange(const AccelerationRange& first, const AccelerationRange& second,
              const AccelerationRange& third);
  /// Multiplies every limit by `factor`.
  void tighten(double factor);
};

}  // namespace feedscope
