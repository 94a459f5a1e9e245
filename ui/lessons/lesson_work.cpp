#include "ui/lessons/lesson_work.h"

#include <set>

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
