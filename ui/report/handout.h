#pragma once

#include <string>

#include "core/lessons/handout.h"
#include "ui/report/report.h"

namespace feedscope::ui {

/// The hand-out of a lesson (handout_html) with pictures of the run that it begins with, the path, unless it
/// is one straight line, and the charts, and one of most questions (question_figure). `texts` of the 3D view
/// in the language of the lesson; charts are in that of the application. `work`: of a learner, whose own
/// sheet it is. Throws as LessonRuns.
ReportPage handout_page(const Lesson& lesson, LessonRuns& runs, HandoutReader reader,
                        const SceneTexts& texts = {}, Progress* progress = nullptr, LearnersWork work = {});

/// The bytes of the same as a file; needs a QApplication. The same lesson gives the same bytes.
std::string make_handout(const Lesson& lesson, LessonRuns& runs, HandoutReader reader, ReportFormat format,
                         const SceneTexts& texts = {}, Progress* progress = nullptr, LearnersWork work = {});

}  // namespace feedscope::ui
