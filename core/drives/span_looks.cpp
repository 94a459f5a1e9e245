#include "core/drives/span_looks.h"

#include <algorithm>
#include <cmath>

namespace feedscope {
namespace {

constexpr double dense_step = 0.002;   // [s]
constexpr double sparse_step = 0.05;   // [s]
constexpr double settling_time = 0.1;  // [s]
constexpr double most_dense = 1e6;
constexpr double most_sparse = 1000;

bool is_steady(const SetSpan& span) {
  return std::ranges::all_of(span.axes, [](const SetCourse& course) {
    return std::all_of(course.derivative.begin() + 2, course.derivative.end(),
                       [](double d) { return d == 0; });
  });
}

}  // namespace

SpanLooks::SpanLooks(const SetSpan& span, bool rigid) : start_(span.time) {
  const bool sparse = span.duration > settling_time && (rigid || is_steady(span));
  dense_time_ = sparse ? settling_time : span.duration;
  sparse_time_ = span.duration - dense_time_;
  dense_ = static_cast<int>(std::clamp(std::ceil(dense_time_ / dense_step), 2.0, most_dense));
  sparse_ = sparse ? static_cast<int>(std::min(std::ceil(sparse_time_ / sparse_step), most_sparse)) : 0;
}

double SpanLooks::at(int i) const {
  return i <= dense_ ? start_ + dense_time_ * i / dense_
                     : start_ + dense_time_ + sparse_time_ * (i - dense_) / sparse_;
}

int SpanLooks::first_after(double time) const {
  const double into = time - start_;
  int first = 0;
  if (into >= dense_time_) {
    const double beyond = sparse_ > 0 ? (into - dense_time_) / sparse_time_ * sparse_ : 0;
    first = dense_ + static_cast<int>(std::min<double>(beyond, sparse_)) + 1;
  } else if (into >= 0) {
    first = static_cast<int>(into / dense_time_ * dense_) + 1;
  }
  while (first > 0 && at(first - 1) > time) {
    --first;  // rounding
  }
  while (first <= count() && at(first) <= time) {
    ++first;
  }
  return first;
}

}  // namespace feedscope
