#pragma once

#include <cstdint>

#include "core/trajectory/trajectory.h"

namespace feedscope {

/// A place of a program that stays where it is, whatever control runs the program: a share of what is
/// executed of one programmed segment, the corner at its end included.
struct ProgrammedPlace {
  std::uint32_t segment = 0;  ///< index into the programmed toolpath
  double share = 0;           ///< of the executed path length of the segment, 0 to 1

  bool operator==(const ProgrammedPlace&) const = default;
};

/// The place at path length `s` of an executed path, clamped to it [mm]; the earlier segment at a border.
ProgrammedPlace programmed_place(const BlendedPath& path, double s);

/// Path length at which an executed path is at `place` [mm], as time_of().
double path_length_of(const BlendedPath& path, const ProgrammedPlace& place);

/// The place under way at `time` [s], clamped to the run. The origin of an empty trajectory.
ProgrammedPlace programmed_place(const Trajectory& trajectory, double time);

/// First instant at which a run is at `place` [s]; a segment that the control omitted stands for the
/// beginning of the next one, one beyond the program for its end. 0 for an empty trajectory.
double time_of(const Trajectory& trajectory, const ProgrammedPlace& place);

}  // namespace feedscope
