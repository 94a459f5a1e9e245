#pragma once

#include <QJsonObject>
#include <QStringList>

#include "ui/lessons/lesson_work.h"

namespace feedscope::ui {

/// Adds work on lessons to a session file: `lessons`, an object for each question with an answer or tries,
/// and `predictions` by the ids of lessons.
void put_lessons(const LessonWork& work, QJsonObject& session);
/// The inverse; notes unknown keys. Throws InputError naming key and value: a missing lesson, an invalid
/// question number or time.
LessonWork read_lessons(const QJsonObject& session, QStringList& notes);

}  // namespace feedscope::ui
