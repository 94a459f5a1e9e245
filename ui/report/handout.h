#pragma once

#include <string>

#include "core/lessons/handout.h"
#include "ui/report/report.h"

namespace feedscope::ui {

/// The hand-out of a lesson (handout_html) with pictures: of the initial run, its path, unless that is one
/// straight line, and its charts; and of most questions (question_figure). `texts` of the 3D view in the
/// language of the lesson; charts are in that of the application. `work`: of the learner whose copy it is.
/// Throws as LessonRuns.
ReportPage handout_page(const Lesson& lesson, LessonRuns& runs, HandoutReader reader,
                        const SceneTexts& texts = {}, Progress* progress = nullptr, LearnersWork work = {});

/// The hand-out as the bytes of a file; needs a QApplication. The same lesson gives the same bytes.
std::string make_handout(const Lesson& lesson, LessonRuns& runs, HandoutReader reader, ReportFormat format,
                         const SceneTexts& texts = {}, Progress* progress = nullptr, LearnersWork work = {});

}  // namespace feedscope::ui
