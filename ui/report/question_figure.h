#pragma once

#include "core/lessons/lesson_runs.h"
#include "ui/report/report_input.h"
#include "ui/report/report_pictures.h"

namespace feedscope::ui {

/// Whether a path is one straight line, of which a 3D view shows nothing.
bool is_straight(const SampledPath& path);

/// A picture of what a question is about, before its control is moved: the corner or the lines that it
/// watches in 3D, the chart of what it watches over their time, circular tests for deviations of full
/// circles, or the path by limiting cause. All of it follows from the lesson: its start with the question's
/// changes, its view, colours and range of the charts. Empty where the pictures of the start, or of an
/// earlier question, already show it. `question`: one of those of `lesson`;
/// `start`: of the start of the lesson; `name`: of the picture.
QString question_figure(const Lesson& lesson, const Question& question, const ReportInput& start,
                        LessonRuns& runs, const QString& name, ReportPictures& pictures,
                        Progress* progress = nullptr);

}  // namespace feedscope::ui
