#pragma once

#include "core/machine/settings.h"
#include "core/models/control_model.h"

namespace feedscope {

/// `refuse`: whether lines that the control rejects are not run.
SettingSpec refuse_setting();

/// What a control read: the path of `read`, whose diagnostics are the refused lines, with what else is known
/// of the lines from `as_written`, the same program as it is meant: path control, spindle and tool.
/// `single_precision`: the control reads numbers of 32 bits. Then lines that lead to other lines, and to a
/// point of `as_written` but for that rounding, end there: the path is the programmed one, which the contour
/// error is measured from, and the numbers of the control follow from it. Next to arcs, and where the control
/// adds numbers up, points remain those of the control.
ControlReading reading_of(Program read, const Toolpath& as_written, bool single_precision = false);

}  // namespace feedscope
