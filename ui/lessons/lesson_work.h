#pragma once

#include <QString>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace feedscope::ui {

/// A value that someone has given the control of a question, and what the run with it measures.
struct LessonTry {
  std::string value;               ///< as in Changes
  double cycle_time = 0;           ///< [s]
  std::optional<double> measured;  ///< what the question watches, in its unit; none: there is nothing of it
  bool operator==(const LessonTry&) const = default;
};

/// What someone has done at one question.
struct QuestionWork {
  QString answer;                ///< in their own words; may be empty
  std::string setting;           ///< key of the control that `tries` are of
  std::string measure;           ///< key of what they measure
  std::vector<LessonTry> tries;  ///< each value once, in the order in which they were tried first
  bool operator==(const QuestionWork&) const = default;
};

/// By the id of a lesson and the number of its question, from 0.
using LessonWork = std::map<std::pair<std::string, std::size_t>, QuestionWork>;
/// What `work` has of lessons of which `held` has nothing.
LessonWork of_other_lessons(const LessonWork& work, const LessonWork& held);
/// How many lessons it is of.
std::size_t lesson_count(const LessonWork& work);
/// Those that are not empty, by the same places.
using LessonAnswers = std::map<std::pair<std::string, std::size_t>, QString>;

}  // namespace feedscope::ui
