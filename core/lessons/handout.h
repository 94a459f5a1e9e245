#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/lessons/lesson.h"
#include "core/lessons/lesson_runs.h"
#include "core/lessons/lesson_text.h"

namespace feedscope {

/// Whom a hand-out is for: prediction and questions with room to write, on two pages; hints and answers with
/// the numbers that they build on; the learners' pages, then answers from a page of their own on.
enum class HandoutReader : std::uint8_t { everybody, learners, teacher };
/// "everybody", "learners", "teacher", in the order of HandoutReader.
const std::vector<std::string>& handout_readers();
/// Throws InputError for a name that is none of them.
HandoutReader handout_reader(const std::string& name);

/// A value that a learner has given the control of a question, and what the run with it measures.
struct LessonTry {
  std::string value;               ///< as in Changes
  double cycle_time = 0;           ///< [s]
  std::optional<double> measured;  ///< what the question watches, in its unit; none: there is nothing of it
  bool operator==(const LessonTry&) const = default;
};

/// What a learner has written and tried in a lesson. It is printed in place of blank lines and cells.
struct LearnersWork {
  struct Answer {
    std::string text;              ///< may be empty
    std::vector<LessonTry> tries;  ///< of the control of the question
  };
  std::string prediction;       ///< may be empty
  std::vector<Answer> answers;  ///< of each question; may be shorter
};

/// What a lesson on paper holds beside its texts.
struct HandoutContents {
  HandoutReader reader = HandoutReader::everybody;
  WrittenNumbers numbers;                        ///< as LessonRuns::numbers()
  std::vector<std::vector<ClaimResult>> claims;  ///< of each question's claims; may be shorter
  std::string figures;                           ///< HTML of pictures of what the lesson begins with
  std::vector<std::string> question_figures;     ///< for the teacher, of each question; may be shorter
  SettingWords words = {};                       ///< titles with their units, in the language of the lesson
  LearnersWork work = {};                        ///< not for the teacher
};

/// Numbers, and for the teacher what the claims come to; no pictures. Throws as LessonRuns.
HandoutContents handout_contents(const Lesson& lesson, LessonRuns& runs, HandoutReader reader,
                                 Progress* progress = nullptr);

/// A lesson on paper: one HTML file with everything inside, laid out for A4.
std::string handout_html(const Lesson& lesson, const HandoutContents& contents);

}  // namespace feedscope
