#pragma once

#include <QJsonObject>
#include <QStringList>
#include <filesystem>

#include "ui/identification/identification_state.h"

namespace feedscope::ui {

/// Choices and results of the identification, as `identification` of a session file; empty for none. Names of
/// tables relative to `folder`.
QJsonObject to_json(const IdentificationState& state, const std::filesystem::path& folder,
                    const MachineLibrary& machines);

/// Notes unknown keys, and an unusable result, which is omitted.
IdentificationState read_identification(const QJsonObject& json, const std::filesystem::path& folder,
                                        const MachineLibrary& machines, QStringList& notes);

}  // namespace feedscope::ui
