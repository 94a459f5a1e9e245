#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/diagnostic.h"
#include "core/base/geometry.h"
#include "core/trace/trace_clock.h"

namespace feedscope {

/// Faster than any machine tool goes [mm/s]: between two samples farther apart others are missing.
inline constexpr double fastest_possible = 5000;

/// What a control, or something beside it, recorded while a program ran: 64 bytes a sample at most.
/// All lists are empty or have one value a sample.
struct Trace {
  std::string name;                          ///< of the file
  std::string format;                        ///< "LinuxCNC halsampler"
  std::vector<double> time;                  ///< rising, from 0 on [s]
  std::array<std::vector<double>, 3> place;  ///< of X, Y, Z [mm]; empty: the axis is not recorded
  /// What encoders measured of X, Y, Z where `place` is what the control set [mm]; empty: not recorded.
  std::array<std::vector<double>, 3> actual;
  std::vector<float> feed;               ///< along the path, as the control says it [mm/s]
  std::vector<std::uint32_t> line;       ///< of the program, as the control says it
  double period = 0;                     ///< between two samples: the median [s]
  TraceClock clock = TraceClock::times;  ///< where `time` comes from
  double jitter = 0;                 ///< root mean square of what steps differ from `period`, gaps apart [s]
  std::size_t gaps = 0;              ///< stretches without samples
  double lost = 0;                   ///< time of those together [s]
  std::vector<std::string> columns;  ///< what was taken from where: "x: column 2 [mm]"
  std::vector<Diagnostic> notes;     ///< what is wrong or was assumed, with its line in the file

  std::size_t size() const { return time.size(); }
  SamplingRate rate() const { return {period, clock}; }
  double duration() const { return time.empty() ? 0 : time.back() - time.front(); }  ///< [s]
  bool has(std::size_t axis) const { return !place[axis].empty(); }
  /// Whether both set and actual position of the axis are recorded.
  bool has_drive(std::size_t axis) const { return has(axis) && !actual[axis].empty(); }
  /// Of sample `i`; 0 for axes that are not recorded [mm].
  Vec3 place_at(std::size_t i) const {
    Vec3 at = Vec3::Zero();
    for (std::size_t axis = 0; axis < place.size(); ++axis) {
      at[static_cast<int>(axis)] = has(axis) ? place[axis][i] : 0;
    }
    return at;
  }
};

}  // namespace feedscope
