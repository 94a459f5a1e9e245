#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "core/program/path/path_writer.h"
#include "core/program/path/plane.h"

namespace feedscope::heidenhain {

/// Parameters of a drilling, tapping or boring cycle by their Q numbers; [mm], [s], [mm/s].
struct DrillingParameters {
  double clearance = 0;          ///< Q200, above the surface
  double depth = 0;              ///< Q201, below the surface: negative
  double infeed = 0;             ///< Q202
  double surface = 0;            ///< Q203, coordinate
  double second_clearance = 0;   ///< Q204, above the surface
  double min_infeed = 0;         ///< Q205
  double feed = 0;               ///< Q206
  double retract_feed = 0;       ///< Q208; 0: by the cycle
  double top_dwell = 0;          ///< Q210
  double bottom_dwell = 0;       ///< Q211
  double decrement = 0;          ///< Q212, of the infeed each time
  double breaks = 0;             ///< Q213, chip breaks before the tool is taken out
  double retreat = 0;            ///< Q214, direction away from the wall, 0 to 4
  double pitch = 0;              ///< Q239
  double start_feed = 0;         ///< Q253
  double break_distance = 0;     ///< Q256
  double break_infeed = 0;       ///< Q257
  double upper_stop = 0;         ///< Q258, distance to the last depth, at the first infeed
  double lower_stop = 0;         ///< Q259, at the last
  double counterbore = 0;        ///< Q249, from the underside upwards
  double thickness = 0;          ///< Q250, of the workpiece
  double off_center = 0;         ///< Q251, sideways so that the tool fits through the hole
  double edge_height = 0;        ///< Q252, of the cutting edge above the tool's lower end
  double counterbore_feed = 0;   ///< Q254
  double counterbore_dwell = 0;  ///< Q255
  double helix_infeed = 0;       ///< Q334
  double diameter = 0;           ///< Q335
  double by_diameter = 0;        ///< Q343
  double climb = 1;              ///< Q351
  double start_depth = 0;        ///< Q379
  double to_shoulder = 0;        ///< Q395: the depth refers to the drill's cylinder, not to its tip
  double feed_factor = 0;        ///< Q401, after the dwell depth [%]
  double retract_factor = 1;     ///< Q403, of the speed out of a thread
  double dwell_depth = 0;        ///< Q435, below the surface
};

enum class CycleUnit : std::uint8_t { length, feed, plain };

struct CycleParameter {
  int q = 0;
  double DrillingParameters::*value = nullptr;
  CycleUnit unit = CycleUnit::plain;
  std::optional<double> otherwise;  ///< default for an older program without it; none: required
};

/// Parameters of cycle `number`; empty for an unsupported one.
std::span<const CycleParameter> parameters_of_drilling(int number);

/// Place where holes are drilled.
struct DrillingPlace {
  PathWriter& path;
  Plane plane = Plane::xy;   ///< across the holes
  double spindle_speed = 0;  ///< [1/s]
  std::optional<double> tool_radius;
};

enum class DrillingFault : std::uint8_t {
  none,
  depth,        ///< positive
  by_diameter,  ///< centring to a diameter: the tool's point angle is not known
  tool_radius,  ///< of bore milling, not known
  pitch,        ///< no pitch, or no spindle speed
  steps,        ///< more than 10000 infeeds
  counterbore,  ///< of back boring, not positive
  infeeds,      ///< of deep drilling: the motion between them is not known
  direction,    ///< of back boring, for the offset through the hole, not 1 to 4
};

/// Drills at the tool's position in the plane with cycle `number`, 200 to 241, and ends at the second
/// clearance. With a fault it drills nothing.
DrillingFault drill(int number, const DrillingParameters& words, const DrillingPlace& place);

/// Cycles of older programs, 1 pecking, 2 tapping, 17 rigid tapping; they start and end at the tool's
/// position.
struct OldDrilling {
  double clearance = 0;  ///< from the tool to the surface [mm]
  double depth = 0;      ///< signed: the direction [mm]
  double infeed = 0;     ///< [mm]
  double dwell = 0;      ///< [s]
  double feed = 0;       ///< [mm/s]
  double pitch = 0;      ///< [mm]
};
DrillingFault drill_old(int number, const OldDrilling& words, const DrillingPlace& place);

}  // namespace feedscope::heidenhain
