#include "core/models/optimal/acceleration_range.h"

#include <algorithm>
#include <cmath>

namespace feedscope {
namespace {

/// An axis whose share of the tangent is below this takes no part in the speed along the path.
constexpr double across = 1e-7;

constexpr double infinite = std::numeric_limits<double>::infinity();

}  // namespace

AccelerationRange::AccelerationRange(const PathPoint& at, const Vec3& acceleration) {
  for (int j = 0; j < 3; ++j) {
    const double tangent = std::abs(at.t[j]);
    if (tangent > across) {
      lines_[static_cast<std::size_t>(count_++)] = {acceleration[j] / tangent, -at.c[j] / at.t[j], j};
    } else if (at.c[j] != 0) {
      lower(acceleration[j] / std::abs(at.c[j]), j);
    }
  }
  lower_by_pairs();
}

void AccelerationRange::lower_by_pairs() {
  for (int j = 0; j < count_; ++j) {
    for (int k = 0; k < count_; ++k) {
      const Line& below = lines_[static_cast<std::size_t>(j)];
      const Line& above = lines_[static_cast<std::size_t>(k)];
      if (below.m > above.m) {
        lower((below.b + above.b) / (below.m - above.m),
              std::abs(below.m) > std::abs(above.m) ? below.axis : above.axis);
      }
    }
  }
}

void AccelerationRange::lower(double x, int axis) {
  if (x < largest_.value) {
    largest_ = {x, static_cast<std::int8_t>(axis)};
  }
}

double AccelerationRange::lowest(double x) const {
  double u = -infinite;
  for (int j = 0; j < count_; ++j) {
    const Line& line = lines_[static_cast<std::size_t>(j)];
    u = std::max(u, line.m * x - line.b);
  }
  return u;
}

double AccelerationRange::highest(double x) const {
  double u = infinite;
  for (int j = 0; j < count_; ++j) {
    const Line& line = lines_[static_cast<std::size_t>(j)];
    u = std::min(u, line.m * x + line.b);
  }
  return u;
}

int AccelerationRange::axis_of_lowest(double x) const {
  const auto end = lines_.begin() + count_;
  return std::max_element(lines_.begin(), end,
                          [&](const Line& a, const Line& b) { return a.m * x - a.b < b.m * x - b.b; })
      ->axis;
}

int AccelerationRange::axis_of_highest(double x) const {
  const auto end = lines_.begin() + count_;
  return std::min_element(lines_.begin(), end,
                          [&](const Line& a, const Line& b) { return a.m * x + a.b < b.m * x + b.b; })
      ->axis;
}

void AccelerationRange::intersect(const AccelerationRange& other) {
  std::copy_n(other.lines_.begin(), other.count_, lines_.begin() + count_);
  count_ += other.count_;
  lower(other.largest_.value, other.largest_.axis);
  lower_by_pairs();
}

void AccelerationRange::tighten(double factor) {
  for (Line& line : lines_) {
    line.b *= factor;
  }
  largest_.value *= factor;
}

double AccelerationRange::reach_back(double most, double length) const {
  // The least of the lines x (1 - length m) + length b: concave in x.
  const auto value = [&](double x) { return x - length * lowest(x); };
  const auto slope = [&](const Line& line) { return 1 - length * line.m; };
  double best = value(most);
  bool falling = false;
  for (int j = 0; j < count_; ++j) {
    falling = falling || slope(lines_[static_cast<std::size_t>(j)]) < 0;
  }
  for (int j = 0; falling && j < count_; ++j) {
    for (int k = 0; k < count_; ++k) {
      const Line& a = lines_[static_cast<std::size_t>(j)];
      const Line& b = lines_[static_cast<std::size_t>(k)];
      if (slope(a) < 0 && slope(b) >= 0) {
        const double x = (a.b - b.b) / (a.m - b.m);
        if (x > 0 && x < most) {
          best = std::max(best, value(x));
        }
      }
    }
  }
  return falling ? std::max(best, value(0)) : best;
}

double AccelerationRange::begin_back(double target, double length) const {
  double x = largest_.value;
  for (int j = 0; j < count_; ++j) {
    const Line& line = lines_[static_cast<std::size_t>(j)];
    const double slope = 1 + length * line.m;
    if (slope > 0) {
      x = std::min(x, (target + length * line.b) / slope);
    }
  }
  return x;
}

double AccelerationRange::reach_on(double target, double length) const {
  double x = largest_.value;
  for (int j = 0; j < count_; ++j) {
    const Line& line = lines_[static_cast<std::size_t>(j)];
    const double slope = 1 - length * line.m;
    if (slope > 0) {
      x = std::min(x, (target + length * line.b) / slope);
    }
  }
  return x;
}

}  // namespace feedscope
