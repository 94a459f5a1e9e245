#include "core/drives/drive_law.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"

namespace feedscope {
namespace {

constexpr std::array<double, SetCourse::order + 1> inverse_factorial{
    1, 1, 1.0 / 2, 1.0 / 6, 1.0 / 24, 1.0 / 120, 1.0 / 720, 1.0 / 5040};

/// Series are used up to this many time constants of the fastest pole; their 24 terms are exact there.
constexpr double series_up_to = 1;

/// Value and slope of a polynomial.
MotorMotion polynomial(const double* coefficients, std::size_t count, double x) {
  MotorMotion at;
  for (std::size_t k = count; k-- > 0;) {
    at.velocity = at.velocity * x + at.offset;
    at.offset = at.offset * x + coefficients[k];
  }
  return at;
}

}  // namespace

double SetCourse::travel(double h) const {
  double sum = 0;
  for (std::size_t k = order; k > 0; --k) {
    sum = (sum + derivative[k] * inverse_factorial[k]) * h;
  }
  return sum;
}

double SetCourse::velocity(double h) const {
  double sum = 0;
  for (std::size_t k = order; k > 0; --k) {
    sum = sum * h + derivative[k] * inverse_factorial[k - 1];
  }
  return sum;
}

DriveLaw::DriveLaw(const AxisDrive& drive, char axis)
    : gain_(drive.gain.value_or(0)),
      feedforward_(drive.feedforward.value_or(0)),
      lag_(drive.lag.value_or(0)) {
  if (const std::string problem = drive_problem(drive, axis); !problem.empty()) {
    throw InputError(problem);
  }
  if (gain_ == 0) {
    return;
  }
  if (lag_ == 0) {
    slow_ = fastest_ = gain_;
    settling_ = 1 / gain_;
    return;
  }
  half_ = 1 / (2 * lag_);
  const double discriminant = 1 - 4 * lag_ * gain_;
  square_ = half_ * half_ * discriminant;
  if (discriminant > 0) {
    const double root = std::sqrt(discriminant);
    slow_ = 2 * gain_ / (1 + root);
    fast_ = half_ * (1 + root);
    fastest_ = fast_;
    settling_ = 1 / slow_;
  } else {
    fastest_ = std::sqrt(gain_ / lag_);
    settling_ = 1 / half_;
  }
}

DriveCourse::DriveCourse(const DriveLaw& law, const SetCourse& set, const MotorMotion& start)
    : law_(&law), set_(set) {
  if (law.follows_exactly()) {
    kind_ = Kind::exact;
  } else if (set.duration * law.fastest_ <= series_up_to) {
    kind_ = Kind::series;
    expand(law, start);
  } else {
    kind_ = Kind::settled;
    settle(law, start);
  }
}

double DriveCourse::drive_input(const DriveLaw& law, std::size_t k) const {
  const double position = k > 0 && k <= SetCourse::order ? set_.derivative[k] : 0;
  const double velocity = k + 1 <= SetCourse::order ? set_.derivative[k + 1] : 0;
  return law.gain_ * position + law.feedforward_ * velocity;
}

/// The derivatives of the solution follow from each other: Tv w'' = r - w' - Kv w, once more for each order.
/// series_[k] is the k-th times duration^k/k!.
void DriveCourse::expand(const DriveLaw& law, const MotorMotion& start) {
  const double z = set_.duration * law.fastest_;
  const double duration = set_.duration;
  double size = 1;   // z^k/k!
  double scale = 1;  // duration^k/k!
  double here = start.offset;
  double next = law.lag_ > 0 ? start.velocity : drive_input(law, 0) - law.gain_ * start.offset;
  constexpr double negligible = 1e-18;
  for (count_ = 0; count_ < terms && (size > negligible || count_ <= SetCourse::order + 1); ++count_) {
    series_[count_] = here * scale;
    const double after = law.lag_ > 0 ? (drive_input(law, count_) - next - law.gain_ * here) / law.lag_
                                      : drive_input(law, count_ + 1) - law.gain_ * next;
    here = next;
    next = after;
    const auto k = static_cast<double>(count_ + 1);
    size *= z / k;
    scale *= duration / k;
  }
}

/// 1/(Tv s^2 + s + Kv) = sum g_k s^k gives the polynomial that solves the equation: its j-th derivative is
/// sum g_k r^(k+j).
void DriveCourse::settle(const DriveLaw& law, const MotorMotion& start) {
  std::array<double, SetCourse::order + 1> g{};
  std::array<double, SetCourse::order + 1> input{};
  for (std::size_t k = 0; k <= SetCourse::order; ++k) {
    const double before = k > 0 ? g[k - 1] : 0;
    const double before_that = k > 1 ? g[k - 2] : 0;
    g[k] = k == 0 ? 1 / law.gain_ : -(before + law.lag_ * before_that) / law.gain_;
    input[k] = drive_input(law, k);
  }
  count_ = SetCourse::order + 1;
  for (std::size_t j = 0; j < count_; ++j) {
    double derivative = 0;
    for (std::size_t k = count_ - j; k-- > 0;) {
      derivative += g[k] * input[k + j];
    }
    series_[j] = derivative * inverse_factorial[j];
  }
  left_ = {start.offset - series_[0], start.velocity - series_[1]};
}

MotorMotion DriveCourse::at(double h) const {
  switch (kind_) {
    case Kind::exact:
      return {set_.travel(h), set_.velocity(h)};
    case Kind::series: {
      if (!(set_.duration > 0)) {
        return {series_[0], 0};
      }
      const MotorMotion at = polynomial(series_.data(), count_, h / set_.duration);
      return {at.offset, at.velocity / set_.duration};
    }
    case Kind::settled:
      break;
  }
  const DriveLaw& law = *law_;
  const MotorMotion at = polynomial(series_.data(), count_, h);
  if (law.lag_ == 0) {
    const double decay = std::exp(-law.gain_ * h);
    return {at.offset + left_.offset * decay, at.velocity - law.gain_ * left_.offset * decay};
  }
  // exp(-half t) times cosh(b t) and sinh(b t)/b, or cos and sin; b = sqrt(|square|).
  const double b = std::sqrt(std::abs(law.square_));
  const double x = b * h;
  double even = 0;
  double odd = 0;
  constexpr double nearly_equal = 1e-4;
  if (x < nearly_equal) {
    const double decay = std::exp(-law.half_ * h);
    even = decay * (1 + law.square_ * h * h / 2);
    odd = decay * h * (1 + law.square_ * h * h / 6);
  } else if (law.square_ > 0) {
    const double slow = std::exp(-law.slow_ * h);
    const double fast = std::exp(-law.fast_ * h);
    even = (slow + fast) / 2;
    odd = (slow - fast) / (2 * b);
  } else {
    const double decay = std::exp(-law.half_ * h);
    even = decay * std::cos(x);
    odd = decay * std::sin(x) / b;
  }
  const double offset = left_.offset * even + (left_.velocity + law.half_ * left_.offset) * odd;
  const double velocity =
      left_.velocity * even - (law.half_ * left_.velocity + law.gain_ / law.lag_ * left_.offset) * odd;
  return {at.offset + offset, at.velocity + velocity};
}

MotorMotion DriveCourse::at_end() const {
  MotorMotion end = at(set_.duration);
  end.offset -= set_.travel(set_.duration);
  return end;
}

}  // namespace feedscope
