#pragma once

#include <optional>

#include "core/models/linuxcnc/linuxcnc_segment.h"

namespace feedscope {

/// An arc that LinuxCNC may put into a joint (README.md, "Blend arcs").
struct LinuxCncBlend {
  LinuxCncSegment arc;
  bool consumes_first = false;  ///< the rest of the first segment becomes the arc's lead
  double cut_first = 0;         ///< of a line [mm]
  double turn_first = 0;        ///< of an arc [rad]
  double cut_second = 0;
  double turn_second = 0;
};

/// Blend arc between two segments that meet at an angle; none if there is none.
std::optional<LinuxCncBlend> find_linuxcnc_blend(const LinuxCncSegment& first, const LinuxCncSegment& second,
                                                 const LinuxCncSettings& settings);

/// Speed at which two segments overlap in a parabolic blend.
struct LinuxCncOverlap {
  double first = 0;   ///< speed of the first one where the second starts [mm/s]
  double second = 0;  ///< [mm/s]
  double net = 0;     ///< of both combined [mm/s]
};
LinuxCncOverlap find_linuxcnc_overlap(const LinuxCncSegment& first, const LinuxCncSegment& second,
                                      const LinuxCncSettings& settings, bool only_in_overlap);

}  // namespace feedscope
