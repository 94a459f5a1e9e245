#pragma once

#include "core/lessons/lesson_runs.h"
#include "ui/report/report_input.h"
#include "ui/report/report_pictures.h"

namespace feedscope::ui {

/// Whether a path is one straight line, which a 3D view need not show.
bool is_straight(const SampledPath& path);

/// A picture of a question before its control is moved: the watched corner or lines in 3D, the chart of the
/// watched quantity over their time, circular tests for deviations of full circles, or the path by limiting
/// cause. It follows from the lesson: its start with the question's changes, its view, colours and range of
/// the charts. If the pictures of the start or of an earlier question already show it, a reference to that
/// figure; empty where nothing shows it. `question`: counted from 0; `start`: of the start of the lesson;
/// `pictures`: those of the start and of all earlier questions.
QString question_figure(const Lesson& lesson, std::size_t question, const ReportInput& start,
                        LessonRuns& runs, ReportPictures& pictures, Progress* progress = nullptr);

}  // namespace feedscope::ui
