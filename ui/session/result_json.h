#pragma once

#include <QJsonObject>
#include <QStringList>

#include "ui/identification/identification_state.h"

namespace feedscope::ui {

/// Identification results without the simulated runs: at most 200 ranges keep their times over the
/// recordings.
QJsonObject to_json(const IdentificationResult& result, const MachineLibrary& machines);

/// Notes unknown keys. Throws InputError for a result without models or recordings, and for an unknown
/// machine or model.
IdentificationResult read_result(const QJsonObject& json, const MachineLibrary& machines, QStringList& notes);

}  // namespace feedscope::ui
