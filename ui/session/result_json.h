#pragma once

#include <QJsonObject>
#include <QStringList>

#include "ui/identification/identification_state.h"

namespace feedscope::ui {

/// What was identified, without the simulated runs: their times over the recordings are kept in at most 200
/// stretches.
QJsonObject to_json(const IdentificationResult& result, const MachineLibrary& machines);

/// Unknown keys go to `notes`. Throws InputError for a result without models or recordings, and for a machine
/// or model that is not known.
IdentificationResult read_result(const QJsonObject& json, const MachineLibrary& machines, QStringList& notes);

}  // namespace feedscope::ui
