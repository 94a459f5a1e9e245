#include "core/drives/set_span.h"

namespace feedscope {

Vec3 SetSpan::at(double h) const {
  return start + Vec3(axes[0].travel(h), axes[1].travel(h), axes[2].travel(h));
}

void SetSpan::begin(const Vec3& position, std::size_t degree, double lasting) {
  start = position;
  duration = lasting;
  for (SetCourse& course : axes) {
    course.derivative.fill(0);
    course.duration = lasting;
    course.degree = degree;
  }
  set_derivative(0, position);
}

}  // namespace feedscope
