#pragma once

#include <QJsonArray>
#include <QStringList>

#include "ui/lessons/lesson_work.h"

namespace feedscope::ui {

/// What was done in lessons, as `lessons` of a session file: an object for each question with an answer or
/// tries.
QJsonArray to_json(const LessonWork& work);
/// Unknown keys go to `notes`. Throws InputError naming key and value: no lesson, no question number, a time
/// that is none.
LessonWork read_lessons(const QJsonArray& json, QStringList& notes);

}  // namespace feedscope::ui
