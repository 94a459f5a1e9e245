#pragma once

#include <cmath>

namespace feedscope {

/// Sum with a running correction, so that a million small times add up as exactly as ten (Neumaier).
class ExactSum {
 public:
  void add(double x) {
    const double sum = sum_ + x;
    correction_ += std::abs(sum_) >= std::abs(x) ? (sum_ - sum) + x : (x - sum) + sum_;
    sum_ = sum;
  }
  void add(const ExactSum& other) {
    add(other.sum_);
    correction_ += other.correction_;
  }
  double value() const { return sum_ + correction_; }

 private:
  double sum_ = 0;
  double correction_ = 0;
};

}  // namespace feedscope
