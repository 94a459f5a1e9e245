#pragma once

#include "core/machine/settings.h"
#include "core/models/control_model.h"

namespace feedscope {

/// `refuse`: whether lines that the control rejects are not run.
SettingSpec refuse_setting();

/// What a control read: the path of `read`, whose diagnostics are the refused lines, with what else is known
/// of the lines from `as_written`, the same program as it is meant: path control, spindle and tool.
ControlReading reading_of(Program read, const Toolpath& as_written);

}  // namespace feedscope
