#pragma once

#include <optional>
#include <string>

#include "core/lessons/lesson.h"
#include "ui/lessons/lesson_work.h"

namespace feedscope::ui {

/// The value of the question's control, as the lesson writes it, that `run` of `program` was made with; none
/// where the run is not what the lesson begins with and that one value.
std::optional<std::string> tried_value(const Lesson& lesson, const Question& question,
                                       const std::filesystem::path& program, const Run& run);

/// What a run comes to for a question; `value` as tried_value().
LessonTry try_of(const Question& question, std::string value, const Run& run);

/// Of the cycle time of the whole run, which every try has anyway.
inline constexpr const char* cycle_time_name = "cycle_time_s";
/// What a question watches as a name without blanks: "peak_feed_m_min_line_16".
std::string watched_name(const Measure& watch);
/// Whether the tries are of what the question moves and watches, not of an older version of the lesson.
bool is_work_on(const Question& question, const QuestionWork& work);

/// Puts a try behind the others, or in the place of the earlier one with the same value.
void put_try(LessonTry one, std::vector<LessonTry>& tries);
/// The same with the tries at a question; those that are not is_work_on() go.
void keep_try(const Question& question, LessonTry one, QuestionWork& work);

/// The tries as CSV: value, cycle time [s], its change against the first try [%], what the question watches
/// and its change; numbers with a decimal point, cells without a number empty.
std::string tries_csv(const QuestionWork& work);

/// Change of a number against the first one [%]; none where that is 0.
std::optional<double> change_percent(double value, double first);

}  // namespace feedscope::ui
