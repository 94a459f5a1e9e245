#include "core/program/heidenhain/geometry/dwells.h"

namespace feedscope::heidenhain {

void Dwells::run(double seconds, std::uint32_t column) {
  constexpr double longest = 1e9;
  if (!(seconds >= 0 && seconds <= longest)) {
    report(Severity::error, "dwell-time", 0, column, [&] {
      return Text{seconds < 0 ? message(NC_("core", "dwell time {} is negative"), seconds)
                              : message(NC_("core", "dwell time {} is beyond 1000000000 s"), seconds),
                  NC_("core", "the dwell is skipped")};
    });
    return;
  }
  end_contour(column);
  if (seconds > 0) {
    path().dwell(seconds);
  }
}

}  // namespace feedscope::heidenhain
