#pragma once

#include <QJsonObject>
#include <QString>

#include "ui/workbench/setup_state.h"

namespace feedscope::ui {

/// Machine, model and changes to the machine's file: `machine` or, for one that is not among `machines`,
/// `machine_file`; `model`; `set`.
QJsonObject to_json(const SetupState& state, const MachineLibrary& machines);

/// Ignores other keys. `place`: of the setup in the session, for messages. Throws InputError with it and the
/// unknown or out-of-bounds machine, model or setting.
SetupState read_setup(const QJsonObject& json, const QString& place, const MachineLibrary& machines);

}  // namespace feedscope::ui
