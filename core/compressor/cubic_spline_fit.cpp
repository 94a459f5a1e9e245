#include "core/compressor/cubic_spline_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace feedscope {
namespace {

/// Nodes on [0, 1] and weights of the 3-point Gauss-Legendre rule, exact to degree five.
constexpr std::array<std::array<double, 2>, 3> gauss{
    {{0.1127016653792583, 5.0 / 18}, {0.5, 8.0 / 18}, {0.8872983346207417, 5.0 / 18}}};

/// Cholesky factorisation of a symmetric matrix of half band width 3, in place: band[i][d] is element (i, i -
/// d). Solves for `right`.
void solve_band(std::span<std::array<double, 4>> band, std::span<Vec3> right) {
  const std::size_t count = band.size();
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t d = std::min<std::size_t>(3, i); d > 0; --d) {
      const std::size_t j = i - d;
      double sum = band[i][d];
      for (std::size_t e = d + 1; e <= 3 && e <= i; ++e) {
        sum -= band[i][e] * band[j][e - d];
      }
      band[i][d] = sum * band[j][0];
    }
    double diagonal = band[i][0];
    for (std::size_t d = 1; d <= 3 && d <= i; ++d) {
      diagonal -= band[i][d] * band[i][d];
    }
    band[i][0] = 1 / std::sqrt(diagonal);
    Vec3& value = right[i];
    for (std::size_t d = 1; d <= 3 && d <= i; ++d) {
      value -= band[i][d] * right[i - d];
    }
    value *= band[i][0];
  }
  for (std::size_t i = count; i-- > 0;) {
    Vec3& value = right[i];
    for (std::size_t d = 1; d <= 3 && i + d < count; ++d) {
      value -= band[i + d][d] * right[i + d];
    }
    value *= band[i][0];
  }
}

}  // namespace

void Polyline::clear() {
  points.clear();
  places.clear();
}

void Polyline::add(const Vec3& point) {
  places.push_back(points.empty() ? 0 : places.back() + (point - points.back()).norm());
  points.push_back(point);
}

/// Calls visit(line, from, to) for the parts of the polyline's lines within the interval, by t.
template <typename Visit>
void CubicSplineFit::for_pieces(const Interval& interval, const Visit& visit) const {
  const std::vector<double>& places = polyline_.places;
  double from = interval.begin;
  for (std::size_t line = interval.line; line + 1 < places.size() && from < interval.end; ++line) {
    const double to = std::min(places[line + 1], interval.end);
    if (to > from) {
      visit(line, from, to);
      from = to;
    }
  }
}

void CubicSplineFit::fit(std::span<const double> borders) {
  set_intervals(borders);
  set_basis();
  solve();
}

void CubicSplineFit::set_intervals(std::span<const double> borders) {
  std::swap(before_, intervals_);
  intervals_.clear();
  std::size_t line = 0;
  std::size_t old = 0;
  for (std::size_t k = 0; k + 1 < borders.size(); ++k) {
    while (old < before_.size() && before_[old].begin < borders[k]) {
      ++old;
    }
    if (old < before_.size() && before_[old].begin == borders[k] && before_[old].end == borders[k + 1]) {
      intervals_.push_back(before_[old]);
      continue;
    }
    Interval& interval = intervals_.emplace_back();
    interval.begin = borders[k];
    interval.end = borders[k + 1];
    line = k > 0 ? std::max(line, intervals_[k - 1].line) : line;
    while (line + 2 < polyline_.places.size() && polyline_.places[line + 1] <= interval.begin) {
      ++line;
    }
    interval.line = line;
    interval.moments.fill(Vec3::Zero());
    const double scale = 1 / interval.length();
    for_pieces(interval, [&](std::size_t piece, double from, double to) {
      const Vec3& point = polyline_.points[piece];
      const Vec3 direction = polyline_.direction(piece);
      const double start = polyline_.places[piece];
      for (const auto& [node, weight] : gauss) {
        const double t = from + node * (to - from);
        const double x = (t - interval.begin) * scale;
        Vec3 value = (weight * (to - from) * scale) * (point + (t - start) * direction);
        for (Vec3& moment : interval.moments) {
          moment += value;
          value *= x;
        }
      }
    });
  }
}

void CubicSplineFit::set_basis() {
  const std::size_t count = intervals_.size();
  const double whole = polyline_.length();
  // Border i of the intervals, mirrored beyond both ends.
  const auto border = [&](std::ptrdiff_t i) {
    const auto n = static_cast<std::ptrdiff_t>(count);
    if (i < 0) {
      return -intervals_[static_cast<std::size_t>(-i - 1)].end;
    }
    return i < n    ? intervals_[static_cast<std::size_t>(i)].begin
           : i == n ? whole
                    : 2 * whole - intervals_[static_cast<std::size_t>(2 * n - i)].begin;
  };
  for (std::size_t k = 0; k < count; ++k) {
    const auto i = static_cast<std::ptrdiff_t>(k);
    const std::array<double, 6> t{border(i - 2), border(i - 1), border(i),
                                  border(i + 1), border(i + 2), border(i + 3)};
    const double h = t[3] - t[2];
    const double m00 = h * h / ((t[3] - t[1]) * (t[3] - t[0]));
    const double m02 = (t[2] - t[1]) * (t[2] - t[1]) / ((t[4] - t[1]) * (t[3] - t[1]));
    const double m12 = 3 * h * (t[2] - t[1]) / ((t[4] - t[1]) * (t[3] - t[1]));
    const double m22 = 3 * h * h / ((t[4] - t[1]) * (t[3] - t[1]));
    const double m33 = h * h / ((t[5] - t[2]) * (t[4] - t[2]));
    const double m32 = -m22 / 3 - m33 - h * h / ((t[4] - t[2]) * (t[4] - t[1]));
    intervals_[k].rows = {{{m00, 1 - m00 - m02, m02, 0},
                           {-3 * m00, 3 * m00 - m12, m12, 0},
                           {3 * m00, -3 * m00 - m22, m22, 0},
                           {-m00, m00 - m32 - m33, m32, m33}}};
  }
}

/// Normal equations for the control points, four per interval.
void CubicSplineFit::set_equations() {
  const std::size_t count = intervals_.size() + 3;
  band_.assign(count, {});
  right_.assign(count, Vec3::Zero());
  const double penalty = 36 * std::pow(smoothing_, 6);
  for (std::size_t k = 0; k < intervals_.size(); ++k) {
    const Interval& interval = intervals_[k];
    const double h = interval.length();
    for (std::size_t i = 0; i < 4; ++i) {
      std::array<double, 4> weighted{};  // Gram matrix of powers times basis function i
      for (std::size_t a = 0; a < 4; ++a) {
        for (std::size_t b = 0; b < 4; ++b) {
          weighted[a] += interval.rows[b][i] / static_cast<double>(a + b + 1);
        }
        right_[k + i] += (h * interval.rows[a][i]) * interval.moments[a];
      }
      for (std::size_t j = 0; j <= i; ++j) {
        double sum = penalty * interval.rows[3][i] * interval.rows[3][j];
        for (std::size_t a = 0; a < 4; ++a) {
          sum += weighted[a] * interval.rows[a][j];
        }
        band_[k + i][i - j] += h * sum;
      }
    }
  }
}

/// Fixes the position of a free end by a large weight.
void CubicSplineFit::hold(const Interval& interval, bool at_end, const Vec3& point) {
  constexpr double met = 1e5;  // in intervals
  const std::size_t row = at_end ? right_.size() - 4 : 0;
  std::array<double, 4> basis{};
  for (std::size_t i = 0; i < 4; ++i) {
    const auto& rows = interval.rows;
    basis[i] = at_end ? rows[0][i] + rows[1][i] + rows[2][i] + rows[3][i] : rows[0][i];
  }
  const double weight = met * interval.length();
  for (std::size_t i = 0; i < 4; ++i) {
    right_[row + i] += weight * basis[i] * point;
    for (std::size_t j = 0; j <= i; ++j) {
      band_[row + i][i - j] += weight * basis[i] * basis[j];
    }
  }
}

/// Three control points at an end for its position, its direction and zero curvature.
std::array<Vec3, 3> CubicSplineFit::control_points(const Interval& interval, bool at_end, const Vec3& point,
                                                   const Vec3& direction) {
  Eigen::Matrix3d basis;
  for (int column = 0; column < 3; ++column) {
    const std::size_t i = static_cast<std::size_t>(column) + (at_end ? 1 : 0);
    const auto row = [&](std::size_t a) { return interval.rows[a][i]; };
    basis(0, column) = at_end ? row(0) + row(1) + row(2) + row(3) : row(0);
    basis(1, column) = at_end ? row(1) + 2 * row(2) + 3 * row(3) : row(1);
    basis(2, column) = at_end ? row(2) + 3 * row(3) : row(2);
  }
  Eigen::Matrix3d wanted;
  wanted << point.transpose(), interval.length() * direction.transpose(), Eigen::RowVector3d::Zero();
  const Eigen::Matrix3d control = basis.inverse() * wanted;
  return {control.row(0).transpose(), control.row(1).transpose(), control.row(2).transpose()};
}

/// Eliminates known control points from the equations of the others.
void CubicSplineFit::take_out_first(const std::array<Vec3, 3>& known) {
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t d = 3 - i; d <= 3 && i + d < right_.size(); ++d) {
      right_[i + d] -= band_[i + d][d] * known[i];
      band_[i + d][d] = 0;
    }
  }
}
void CubicSplineFit::take_out_last(const std::array<Vec3, 3>& known) {
  const std::size_t end = right_.size() - 3;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t d = i + 1; d <= 3; ++d) {
      right_[end + i - d] -= band_[end + i][d] * known[i];
    }
  }
}

void CubicSplineFit::solve() {
  set_equations();
  std::span<std::array<double, 4>> band(band_);
  std::span<Vec3> unknown(right_);
  const Interval& front = intervals_.front();
  const Interval& back = intervals_.back();
  std::array<Vec3, 3> first;
  std::array<Vec3, 3> last;
  if (polyline_.free_start) {
    hold(front, false, polyline_.points.front());
  } else {
    first = control_points(front, false, polyline_.points.front(), polyline_.start_direction);
    take_out_first(first);
    band = band.subspan(3);
    unknown = unknown.subspan(3);
  }
  if (polyline_.free_end) {
    hold(back, true, polyline_.points.back());
  } else {
    last = control_points(back, true, polyline_.points.back(), polyline_.end_direction);
    take_out_last(last);
    band = band.first(band.size() - 3);
    unknown = unknown.first(unknown.size() - 3);
  }
  solve_band(band, unknown);
  if (!polyline_.free_start) {
    std::ranges::copy(first, right_.begin());
  }
  if (!polyline_.free_end) {
    std::ranges::copy(last, right_.end() - 3);
  }
  set_coefficients();
}

void CubicSplineFit::set_coefficients() {
  for (std::size_t k = 0; k < intervals_.size(); ++k) {
    Interval& interval = intervals_[k];
    for (std::size_t a = 0; a < 4; ++a) {
      interval.coefficients[a] = interval.rows[a][0] * right_[k] + interval.rows[a][1] * right_[k + 1] +
                                 interval.rows[a][2] * right_[k + 2] + interval.rows[a][3] * right_[k + 3];
    }
  }
}

CurvePoint CubicSplineFit::at(std::size_t k, double x) const {
  const auto& c = intervals_[k].coefficients;
  const double scale = 1 / intervals_[k].length();
  return {c[0] + x * (c[1] + x * (c[2] + x * c[3])), scale * (c[1] + x * (2 * c[2] + 3 * x * c[3])),
          scale * scale * (2 * c[2] + 6 * x * c[3]), scale * scale * scale * 6 * c[3]};
}

double CubicSplineFit::deviation(std::size_t k) const {
  const Interval& interval = intervals_[k];
  const auto& c = interval.coefficients;
  const double scale = 1 / interval.length();
  double largest = 0;
  for_pieces(interval, [&](std::size_t line, double from, double to) {
    const Vec3 direction = polyline_.direction(line);
    const int looks = 2 + static_cast<int>(8 * (to - from) * scale);
    for (int i = 1; i <= looks; ++i) {
      const double t = from + (to - from) * i / looks;
      const double x = (t - interval.begin) * scale;
      const Vec3 there = c[0] + x * (c[1] + x * (c[2] + x * c[3]));
      const Vec3 way = polyline_.points[line] + (t - polyline_.places[line]) * direction - there;
      const double whole = way.squaredNorm();
      if (whole > largest) {  // its component across is less
        const Vec3 slope = c[1] + x * (2 * c[2] + 3 * x * c[3]);
        const double along = way.dot(slope);
        largest = std::max(largest, whole - along * along / slope.squaredNorm());
      }
    }
  });
  return std::sqrt(std::max(largest, 0.0));
}

}  // namespace feedscope
