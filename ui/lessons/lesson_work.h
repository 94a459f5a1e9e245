#pragma once

#include <QString>
#include <cstddef>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/lessons/handout.h"

namespace feedscope::ui {

/// What someone has done at one question.
struct QuestionWork {
  QString answer;                ///< in their own words; may be empty
  std::string setting;           ///< key of the control that `tries` are of
  std::string measure;           ///< key of what they measure
  std::vector<LessonTry> tries;  ///< each value once, in the order in which they were tried first
  bool operator==(const QuestionWork&) const = default;
};

/// By the id of a lesson and the number of its question, from 0; the prediction is the answer to
/// `prediction`.
using LessonWork = std::map<std::pair<std::string, std::size_t>, QuestionWork>;
inline constexpr std::size_t prediction = std::numeric_limits<std::size_t>::max();
/// What `work` has of a lesson, for its hand-out; tries only where they are is_work_on() its questions.
LearnersWork work_on(const Lesson& lesson, const LessonWork& work);
/// What `work` has of lessons of which `held` has nothing.
LessonWork of_other_lessons(const LessonWork& work, const LessonWork& held);
/// How many lessons it is of.
std::size_t lesson_count(const LessonWork& work);
/// Those that are not empty, by the same places.
using LessonAnswers = std::map<std::pair<std::string, std::size_t>, QString>;

}  // namespace feedscope::ui
