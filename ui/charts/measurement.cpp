#include "ui/charts/measurement.h"

namespace feedscope::ui {

Measurement measure(const State& first, const State& second) {
  const double time = second.time - first.time;
  const double length = second.path_length - first.path_length;
  return {time, length, time != 0 ? length / time : 0, second.speed - first.speed};
}

}  // namespace feedscope::ui
