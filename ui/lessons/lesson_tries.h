#pragma once

#include <optional>
#include <string>

#include "core/lessons/lesson.h"
#include "ui/lessons/lesson_work.h"

namespace feedscope::ui {

/// The value of the question's control in `run` of `program`, in the lesson's notation; none if the run
/// differs from the lesson's setup in more than that value.
std::optional<std::string> tried_value(const Lesson& lesson, const Question& question,
                                       const std::filesystem::path& program, const Run& run);

/// Results of a run for a question; `value` as tried_value().
LessonTry try_of(const Question& question, std::string value, const Run& run);

/// Name of the whole run's cycle time, which every try has.
inline constexpr const char* cycle_time_name = "cycle_time_s";
/// Name without blanks of the watched quantity: "peak_feed_m_min_line_16".
std::string watched_name(const Measure& watch);
/// Whether the tries have the control and measure of the question, not of an older version of the lesson.
bool is_work_on(const Question& question, const QuestionWork& work);

/// Appends a try, or replaces the earlier one with the same value.
void put_try(LessonTry one, std::vector<LessonTry>& tries);
/// Appends a try at a question in this way; discards tries that are not is_work_on().
void keep_try(const Question& question, LessonTry one, QuestionWork& work);

/// The tries as CSV: value, cycle time [s], its change against the first try [%], the watched quantity and
/// its change; numbers with a decimal point, cells without a number empty.
std::string tries_csv(const QuestionWork& work);

/// Change relative to the first number [%]; none if that is 0.
std::optional<double> change_percent(double value, double first);

}  // namespace feedscope::ui
