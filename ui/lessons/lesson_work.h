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

/// A learner's work on one question.
struct QuestionWork {
  QString answer;                ///< in the learner's words; may be empty
  std::string setting;           ///< key of the control of `tries`
  std::string measure;           ///< key of their measured quantity
  std::vector<LessonTry> tries;  ///< each value once, in the order of its first try
  bool operator==(const QuestionWork&) const = default;
};

/// By the id of a lesson and the number of its question, from 0; the prediction is the answer to
/// `prediction`, the completed sentence about one's own control that to `transfer`.
using LessonWork = std::map<std::pair<std::string, std::size_t>, QuestionWork>;
inline constexpr std::size_t prediction = std::numeric_limits<std::size_t>::max();
inline constexpr std::size_t transfer = prediction - 1;
/// The part of `work` on a lesson, for its hand-out; only tries that are is_work_on() its questions.
LearnersWork work_on(const Lesson& lesson, const LessonWork& work);
/// The part of `work` on lessons that `held` does not contain.
LessonWork of_other_lessons(const LessonWork& work, const LessonWork& held);
/// Number of lessons in `work`.
std::size_t lesson_count(const LessonWork& work);
/// Non-empty answers, by the same keys.
using LessonAnswers = std::map<std::pair<std::string, std::size_t>, QString>;

}  // namespace feedscope::ui
