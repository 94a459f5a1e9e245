#pragma once

#include <string>

#include "core/lessons/lesson.h"
#include "core/lessons/lesson_text.h"

namespace feedscope {

/// A Markdown text (CommonMark, no HTML in it) as HTML.
std::string html_of(const std::string& markdown);

/// A lesson on paper: one HTML file with everything inside, laid out for A4; text and questions with room to
/// write, the answers and sources on a page of their own at the end. `numbers` as LessonRuns::numbers().
/// `figures`: HTML of pictures of what the lesson begins with; may be empty.
std::string handout_html(const Lesson& lesson, const WrittenNumbers& numbers,
                         const std::string& figures = {});

}  // namespace feedscope
