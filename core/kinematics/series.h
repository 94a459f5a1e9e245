#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>

namespace feedscope {

/// A quantity with its first three derivatives by one parameter, as Taylor coefficients f, f', f''/2, f'''/6;
/// computations propagate the derivatives.
class Series {
 public:
  static constexpr int order = 3;

  Series() = default;
  Series(double value) : c_{value, 0, 0, 0} {}  // NOLINT(google-explicit-constructor): a constant
  /// From a value and its derivatives.
  Series(double value, double d1, double d2, double d3) : c_{value, d1, d2 / 2, d3 / 6} {}

  double value() const { return c_[0]; }
  double d1() const { return c_[1]; }
  double d2() const { return 2 * c_[2]; }
  double d3() const { return 6 * c_[3]; }

  Series operator-() const {
    Series r;
    for (int i = 0; i <= order; ++i) {
      r.at(i) = -at(i);
    }
    return r;
  }
  Series& operator+=(const Series& b) {
    for (int i = 0; i <= order; ++i) {
      at(i) += b.at(i);
    }
    return *this;
  }
  Series& operator-=(const Series& b) { return *this += -b; }
  Series& operator*=(const Series& b) { return *this = *this * b; }
  Series& operator/=(const Series& b) { return *this = *this / b; }

  friend Series operator+(Series a, const Series& b) { return a += b; }
  friend Series operator-(Series a, const Series& b) { return a -= b; }
  friend Series operator*(const Series& a, const Series& b) {
    Series r;
    for (int i = 0; i <= order; ++i) {
      for (int k = 0; k <= i; ++k) {
        r.at(i) += a.at(k) * b.at(i - k);
      }
    }
    return r;
  }
  friend Series operator*(double a, Series b) {
    for (int i = 0; i <= order; ++i) {
      b.at(i) *= a;
    }
    return b;
  }
  friend Series operator/(const Series& a, const Series& b) {
    Series r;
    for (int i = 0; i <= order; ++i) {
      double sum = a.at(i);
      for (int k = 0; k < i; ++k) {
        sum -= r.at(k) * b.at(i - k);
      }
      r.at(i) = sum / b.at(0);
    }
    return r;
  }
  friend Series sqrt(const Series& a) {
    Series r;
    r.at(0) = std::sqrt(a.at(0));
    for (int i = 1; i <= order; ++i) {
      double sum = a.at(i);
      for (int k = 1; k < i; ++k) {
        sum -= r.at(k) * r.at(i - k);
      }
      r.at(i) = sum / (2 * r.at(0));
    }
    return r;
  }
  /// f(x), from the derivatives of `f` by x and those of x by the parameter of the result.
  friend Series chained(const Series& f, const Series& x) {
    return Series(f.value(), f.d1() * x.d1(), f.d2() * x.d1() * x.d1() + f.d1() * x.d2(),
                  f.d3() * x.d1() * x.d1() * x.d1() + 3 * f.d2() * x.d1() * x.d2() + f.d1() * x.d3());
  }
  friend Series sin(const Series& a) { return of_angle(a, std::sin(a.value()), std::cos(a.value())); }
  friend Series cos(const Series& a) { return of_angle(a, std::cos(a.value()), -std::sin(a.value())); }
  /// Undefined at y = x = 0.
  friend Series atan2(const Series& y, const Series& x) {
    // d atan2 = (x dy - y dx)/(x^2 + y^2)
    const Series slope = (x * y.derivative() - y * x.derivative()) / (x * x + y * y);
    Series r(std::atan2(y.value(), x.value()));
    for (int i = 1; i <= order; ++i) {
      r.at(i) = slope.at(i - 1) / i;
    }
    return r;
  }

 private:
  double& at(int i) { return c_[static_cast<std::size_t>(i)]; }
  double at(int i) const { return c_[static_cast<std::size_t>(i)]; }
  /// Derivative without its third one, which is unknown.
  Series derivative() const {
    Series r;
    for (int i = 0; i < order; ++i) {
      r.at(i) = (i + 1) * at(i + 1);
    }
    return r;
  }
  /// f(a) with f'' = -f, from f and f' at its value.
  static Series of_angle(const Series& a, double f, double slope) {
    const double x = a.at(1);
    const double y = a.at(2);
    const double z = a.at(3);
    Series r(f);
    r.at(1) = slope * x;
    r.at(2) = slope * y - f * x * x / 2;
    r.at(3) = slope * z - f * x * y - slope * x * x * x / 6;
    return r;
  }

  std::array<double, order + 1> c_{};
};

}  // namespace feedscope

template <>
struct Eigen::NumTraits<feedscope::Series> : Eigen::GenericNumTraits<double> {
  using Real = feedscope::Series;
  using NonInteger = feedscope::Series;
  using Nested = feedscope::Series;
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 1,
    ReadCost = 4,
    AddCost = 4,
    MulCost = 10
  };
};
