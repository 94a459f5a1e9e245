#include "ui/shared/next_place.h"

#include <limits>

namespace feedscope::ui {

int next_place(int rows, const std::function<double(int)>& time_of, double time, bool forward) {
  constexpr double same_time = 1e-9;  // [s]
  const double infinity = std::numeric_limits<double>::infinity();
  const double sign = forward ? 1 : -1;
  int next = -1;
  int first = -1;
  double next_ahead = infinity;
  double first_ahead = infinity;
  for (int row = 0; row < rows; ++row) {
    const double ahead = sign * (time_of(row) - time);
    if (ahead > same_time && ahead < next_ahead) {
      next = row;
      next_ahead = ahead;
    }
    if (ahead < first_ahead) {
      first = row;
      first_ahead = ahead;
    }
  }
  return next >= 0 ? next : first;
}

}  // namespace feedscope::ui
