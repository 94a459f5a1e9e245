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
/// the charts. Empty if the pictures of the start or of an earlier question already show it. `question`: one
/// of those of `lesson`;
/// `start`: of the start of the lesson; `name`: of the picture.
QString question_figure(const Lesson& lesson, const Question& question, const ReportInput& start,
                        LessonRuns& runs, const QString& name, ReportPictures& pictures,
                        Progress* progress = nullptr);

}  // namespace feedscope::ui
