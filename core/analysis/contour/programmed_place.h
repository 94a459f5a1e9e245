#pragma once

#include <cstdint>

#include "core/trajectory/trajectory.h"

namespace feedscope {

/// A place of a program that is independent of the control: a share of the executed path of one programmed
/// segment, from the middle of the corner before it to the middle of the one after it.
struct ProgrammedPlace {
  std::uint32_t segment = 0;  ///< index into the programmed toolpath
  double share = 0;           ///< of the executed path length of the segment, 0 to 1

  bool operator==(const ProgrammedPlace&) const = default;
};

/// Place at path length `s` of an executed path, clamped to it [mm]; the earlier segment at a border.
ProgrammedPlace programmed_place(const BlendedPath& path, double s);

/// Path length of `place` on an executed path [mm], as time_of().
double path_length_of(const BlendedPath& path, const ProgrammedPlace& place);

/// Place at `time` [s], clamped to the run. The origin for an empty trajectory.
ProgrammedPlace programmed_place(const Trajectory& trajectory, double time);

/// First time at which a run is at `place` [s]. A segment that the control omitted maps to the start of the
/// next one, a segment beyond the program to its end. 0 for an empty trajectory.
double time_of(const Trajectory& trajectory, const ProgrammedPlace& place);

}  // namespace feedscope
