#pragma once

#include <QJsonObject>
#include <QStringList>
#include <filesystem>

#include "ui/identification/identification_state.h"

namespace feedscope::ui {

/// What is chosen and found in the identification, as `identification` of a session file; empty for nothing.
/// Names of tables relative to `folder`.
QJsonObject to_json(const IdentificationState& state, const std::filesystem::path& folder,
                    const MachineLibrary& machines);

/// Unknown keys go to `notes`, and so does a result that cannot be used, which is omitted.
IdentificationState read_identification(const QJsonObject& json, const std::filesystem::path& folder,
                                        const MachineLibrary& machines, QStringList& notes);

}  // namespace feedscope::ui
