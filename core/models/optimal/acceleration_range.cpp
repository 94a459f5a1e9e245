#include "core/models/optimal/acceleration_range.h"

namespace feedscope {

AccelerationRange::AccelerationRange(const Vec3& tangent, const Vec3& t, const Vec3& c) {
  constexpr double across = 1e-7;  // an axis with less of the tangent does not limit the speed along it
  b_.fill(infinite);
  for (int j = 0; j < 3; ++j) {
    if (std::abs(tangent[j]) > across) {
      const double inverse = 1 / t[j];
      b_[static_cast<std::size_t>(j)] = std::abs(inverse);
      m_[static_cast<std::size_t>(j)] = -c[j] * inverse;
    } else if (c[j] != 0) {
      lower(1 / std::abs(c[j]), static_cast<std::size_t>(j));
    }
  }
  lower_by_pairs();
}

CommonRange::CommonRange(const AccelerationRange& first, const AccelerationRange& second,
                         const AccelerationRange& third) {
  std::size_t line = 0;
  for (const AccelerationRange* range : {&first, &second, &third}) {
    for (std::size_t j = 0; j < 3; ++j, ++line) {
      b_[line] = range->b(j);
      m_[line] = range->m(j);
    }
    lower(range->largest_x().value, static_cast<std::size_t>(range->largest_x().axis));
  }
  lower_by_pairs();
}

void CommonRange::tighten(double factor) {
  for (double& b : b_) {
    b *= factor;
  }
  largest_.value *= factor;
}

}  // namespace feedscope
