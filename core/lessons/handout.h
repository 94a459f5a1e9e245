#pragma once

#include <string>

#include "core/lessons/lesson.h"
#include "core/lessons/lesson_text.h"

namespace feedscope {

/// A lesson on paper: one HTML file with everything inside, laid out for A4; text and questions with room to
/// write, the answers and sources on a page of their own at the end. `numbers` as LessonRuns::numbers().
/// `figures`: HTML of pictures of what the lesson begins with; may be empty.
std::string handout_html(const Lesson& lesson, const WrittenNumbers& numbers,
                         const std::string& figures = {});

}  // namespace feedscope
