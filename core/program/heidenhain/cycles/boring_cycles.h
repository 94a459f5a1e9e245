#pragma once

#include "core/program/heidenhain/cycles/drilling_cycles.h"
#include "core/program/heidenhain/geometry/tool_axis_moves.h"

namespace feedscope::heidenhain {

/// Cycles 201 and 202, from the set-up clearance.
void bore(const DrillingParameters& words, const Hole& hole, ToolAxisMoves& moves);

/// Cycle 204: goes through the hole off its axis, back onto the axis below the workpiece, and upwards into
/// the underside. The programmed position of the tool is that of its lower end; the cutting edge lies Q252
/// above.
void bore_backwards(const DrillingParameters& words, const Hole& hole, ToolAxisMoves& moves);

/// Cycle 208, from the clearance. Its circles are arcs, not steps of a plan. `place.tool_radius` is known.
void mill_bore(const DrillingParameters& words, const Hole& hole, const DrillingPlace& place);

}  // namespace feedscope::heidenhain
