#include "core/drives/set_course.h"

namespace feedscope {
double SetCourse::travel(double h) const {
  double sum = 0;
  for (std::size_t k = degree; k > 0; --k) {
    sum = h * inverse[k] * (derivative[k] + sum);
  }
  return sum;
}

double SetCourse::velocity(double h) const {
  double sum = 0;
  for (std::size_t k = degree; k > 0; --k) {
    sum = derivative[k] + h * inverse[k] * sum;
  }
  return sum;
}

/// With u = t/h, c5 u^5 + ... + c9 u^9 must correct the error of the Taylor polynomial from the start.
void meet_end(SetCourse::Derivatives& derivative, const std::array<double, SetCourse::met + 1>& end,
              double h) {
  const double square = h * h;
  const double cube = square * h;
  const double fourth = square * square;
  const double a1 = derivative[1] * h;
  const double a2 = derivative[2] * square * (1.0 / 2);
  const double a3 = derivative[3] * cube * (1.0 / 6);
  const double a4 = derivative[4] * fourth * (1.0 / 24);
  const double m0 = end[0] - derivative[0] - a1 - a2 - a3 - a4;
  const double m1 = end[1] * h - a1 - 2 * a2 - 3 * a3 - 4 * a4;
  const double m2 = end[2] * square - 2 * a2 - 6 * a3 - 12 * a4;
  const double m3 = end[3] * cube - 6 * a3 - 24 * a4;
  const double m4 = end[4] * fourth - 24 * a4;
  const double by_time = 1 / h;
  const double fifth = by_time / fourth;
  derivative[5] = 120 * fifth * (126 * m0 - 56 * m1 + 10.5 * m2 - m3 + (1.0 / 24) * m4);
  derivative[6] =
      720 * fifth * by_time * (-420 * m0 + 196 * m1 - 38.5 * m2 + (23.0 / 6) * m3 - (1.0 / 6) * m4);
  const double seventh = fifth * by_time * by_time;
  derivative[7] = 5040 * seventh * (540 * m0 - 260 * m1 + 53 * m2 - 5.5 * m3 + 0.25 * m4);
  derivative[8] = 40320 * seventh * by_time * (-315 * m0 + 155 * m1 - 32.5 * m2 + 3.5 * m3 - (1.0 / 6) * m4);
  derivative[9] = 362880 * seventh * by_time * by_time *
                  (70 * m0 - 35 * m1 + 7.5 * m2 - (5.0 / 6) * m3 + (1.0 / 24) * m4);
}

}  // namespace feedscope
