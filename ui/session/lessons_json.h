#pragma once

#include <QJsonObject>
#include <QStringList>

#include "ui/lessons/lesson_work.h"

namespace feedscope::ui {

/// Puts what was done in lessons into a session file: `lessons`, an object for each question with an answer
/// or tries, and `predictions` by the ids of lessons.
void put_lessons(const LessonWork& work, QJsonObject& session);
/// The reverse; unknown keys go to `notes`. Throws InputError naming key and value: no lesson, no question
/// number, a time that is none.
LessonWork read_lessons(const QJsonObject& session, QStringList& notes);

}  // namespace feedscope::ui
