#include "ui/lessons/lesson_work.h"

#include <set>

#include "ui/lessons/lesson_tries.h"

namespace feedscope::ui {

namespace {

std::set<std::string> lessons_of(const LessonWork& work) {
  std::set<std::string> lessons;
  for (const auto& [where, done] : work) {
    if (!done.answer.trimmed().isEmpty() || !done.tries.empty()) {
      lessons.insert(where.first);
    }
  }
  return lessons;
}

}  // namespace

LearnersWork work_on(const Lesson& lesson, const LessonWork& work) {
  LearnersWork made;
  made.answers.resize(lesson.questions.size());
  for (const auto& [where, done] : work) {
    if (where.first != lesson.id) {
      continue;
    }
    if (where.second == prediction) {
      made.prediction = done.answer.trimmed().toStdString();
    } else if (where.second == transfer) {
      made.transfer = done.answer.trimmed().toStdString();
    } else if (where.second < made.answers.size()) {
      const bool fits = is_work_on(lesson.questions[where.second], done);
      made.answers[where.second] = {done.answer.trimmed().toStdString(),
                                    fits ? done.tries : std::vector<LessonTry>()};
    }
  }
  return made;
}

LessonWork of_other_lessons(const LessonWork& work, const LessonWork& held) {
  const std::set<std::string> there = lessons_of(held);
  const std::set<std::string> all = lessons_of(work);
  LessonWork other;
  for (const auto& [where, done] : work) {
    if (all.contains(where.first) && !there.contains(where.first)) {
      other[where] = done;
    }
  }
  return other;
}

std::size_t lesson_count(const LessonWork& work) {
  return lessons_of(work).size();
}

}  // namespace feedscope::ui
