#pragma once

#include <QJsonObject>
#include <QStringList>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "ui/session/session.h"
#include "ui/shared/paths.h"

namespace feedscope::ui {

/// Of the files written now. One with a higher version is refused; a key that is missing has the value of a
/// new session, so that a version lasts as long as no key changes its meaning.
inline constexpr int session_version = 1;

inline InputError input_error(const QString& message) {
  return InputError(message.toStdString());
}

/// Notes the keys of `json` that are not in `known`, with the nearest one that is. `place`: of `json`, for
/// people.
void note_unknown(const QJsonObject& json, const std::vector<std::string>& known, const QString& place,
                  QStringList& notes);

/// Paths relative to `folder`, where the session file is.
QJsonObject to_json(const Session& session, const std::filesystem::path& folder);

struct ReadSession {
  Session session;
  QStringList notes;  ///< for the user: keys that are not known, values that are not kept
};

/// Throws InputError naming key and value: no session, a newer version, a run on a machine, model or setting
/// that is not known or out of bounds. `machines`: those that go by their id.
ReadSession read_session(const QJsonObject& json, const std::filesystem::path& folder,
                         const MachineLibrary& machines);

/// Only what was done in lessons, as a session has it.
QJsonObject lesson_work_json(const LessonWork& work);
/// That of a session or of lesson_work_json(). Throws InputError as read_session().
LessonWork read_lesson_work(const QJsonObject& json);

}  // namespace feedscope::ui
