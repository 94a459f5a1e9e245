#pragma once

#include <QJsonObject>
#include <QStringList>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "ui/session/session.h"
#include "ui/shared/paths.h"

namespace feedscope::ui {

/// Version of written files. Higher versions are refused; a missing key has the value of a new session, so
/// that the version changes only when a key changes its meaning.
inline constexpr int session_version = 1;

inline InputError input_error(const QString& message) {
  return InputError(message.toStdString());
}

/// Notes the keys of `json` that are not in `known`, with the nearest known one. `place`: of `json`, for
/// people.
void note_unknown(const QJsonObject& json, const std::vector<std::string>& known, const QString& place,
                  QStringList& notes);

/// Paths relative to `folder`, that of the session file.
QJsonObject to_json(const Session& session, const std::filesystem::path& folder);

struct ReadSession {
  Session session;
  QStringList notes;  ///< for the user: unknown keys, discarded values
};

/// Throws InputError naming key and value: not a session, a newer version, an unknown or out-of-bounds
/// machine, model or setting of a run. `machines`: those known by id.
ReadSession read_session(const QJsonObject& json, const std::filesystem::path& folder,
                         const MachineLibrary& machines);

/// The work on lessons only, as in a session.
QJsonObject lesson_work_json(const LessonWork& work);
/// Work on lessons from a session or lesson_work_json(). Throws InputError as read_session().
LessonWork read_lesson_work(const QJsonObject& json);

}  // namespace feedscope::ui
