#pragma once

// Room `trace`: recordings of controls. Files of LinuxCNC, SINUMERIK, TwinCAT and tables become a Trace, with
// gaps, jitter, clock and units found; guess_trace.h recognises the format, trace_columns.h says which column
// is what.

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/diagnostic.h"
#include "core/base/geometry.h"
#include "core/trace/trace_clock.h"

namespace feedscope {

/// Faster than any machine tool [mm/s]: between two samples farther apart others are missing.
inline constexpr double fastest_possible = 5000;

/// Recording by a control, or by a device on it, of a program run: at most 64 bytes per sample. All lists are
/// empty or have one value per sample.
struct Trace {
  std::string name;                          ///< of the file
  std::string format;                        ///< "LinuxCNC halsampler"
  std::vector<double> time;                  ///< ascending, from 0 on [s]
  std::array<std::vector<double>, 3> place;  ///< of X, Y, Z [mm]; empty: the axis is not recorded
  /// Encoder positions of X, Y, Z, if `place` has the set positions [mm]; empty: not recorded.
  std::array<std::vector<double>, 3> actual;
  std::vector<float> feed;               ///< along the path, as reported by the control [mm/s]
  std::vector<std::uint32_t> line;       ///< of the program, as reported by the control
  double period = 0;                     ///< median between two samples [s]
  TraceClock clock = TraceClock::times;  ///< source of `time`
  double jitter = 0;     ///< root mean square difference of the steps from `period`, without gaps [s]
  std::size_t gaps = 0;  ///< stretches without samples
  double lost = 0;       ///< total time of those [s]
  std::vector<std::string> columns;  ///< sources of the quantities: "x: column 2 [mm]"
  std::vector<Diagnostic> notes;     ///< problems and assumptions, with their lines in the file

  std::size_t size() const { return time.size(); }
  SamplingRate rate() const { return {period, clock}; }
  double duration() const { return time.empty() ? 0 : time.back() - time.front(); }  ///< [s]
  bool has(std::size_t axis) const { return !place[axis].empty(); }
  /// Whether both set and actual position of the axis are recorded.
  bool has_drive(std::size_t axis) const { return has(axis) && !actual[axis].empty(); }
  /// Position at sample `i`; 0 for axes that are not recorded [mm].
  Vec3 place_at(std::size_t i) const {
    Vec3 at = Vec3::Zero();
    for (std::size_t axis = 0; axis < place.size(); ++axis) {
      at[static_cast<int>(axis)] = has(axis) ? place[axis][i] : 0;
    }
    return at;
  }
};

}  // namespace feedscope
