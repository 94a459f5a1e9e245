#pragma once

#include <QJsonObject>
#include <QString>

#include "ui/workbench/setup_state.h"

namespace feedscope::ui {

/// Machine, model and what differs from the machine's file: `machine` or, of one that is not among
/// `machines`, `machine_file`; `model`; `set`.
QJsonObject to_json(const SetupState& state, const MachineLibrary& machines);

/// Other keys are of no concern. `place`: which setup of the session, for messages. Throws InputError naming
/// it and the machine, model or setting that is not known or out of bounds.
SetupState read_setup(const QJsonObject& json, const QString& place, const MachineLibrary& machines);

}  // namespace feedscope::ui
