#pragma once

#include "core/machine/settings.h"
#include "core/models/control_model.h"

namespace feedscope {

/// `refuse`: if on, lines that the control rejects are not run.
SettingSpec refuse_setting();

/// Combines the path of `read`, whose diagnostics are the refused lines, with other data of the lines from
/// `as_written`, the same program in its intended meaning: path control, spindle and tool.
/// `single_precision`: the control reads numbers of 32 bits. Then a line that no arc follows and that ends,
/// up to this rounding, at a point of `as_written` gets exactly this end: the path is the programmed one,
/// from which the contour error is measured, and the control's numbers follow from it. Next to arcs, and
/// where the control adds numbers up, points remain those of the control.
ControlReading reading_of(ReadProgram read, const Toolpath& as_written, bool single_precision = false);

}  // namespace feedscope
