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

/// Reader of a hand-out. Learners: prediction and questions with room to write, on two pages. Teacher: hints
/// and answers with the numbers that they build on. Everybody: the learners' pages with hints, then the
/// answers from a new page on.
enum class HandoutReader : std::uint8_t { everybody, learners, teacher };
/// Names "everybody", "learners", "teacher", in the order of HandoutReader.
const std::vector<std::string>& handout_readers();
/// Throws InputError for any other name.
HandoutReader handout_reader(const std::string& name);

/// A value that a learner has set in the control of a question, with the result of the run.
struct LessonTry {
  std::string value;               ///< as in Changes
  double cycle_time = 0;           ///< [s]
  std::optional<double> measured;  ///< watched quantity, in its unit; none if it does not exist
  bool operator==(const LessonTry&) const = default;
};

/// Texts and tries of a learner in a lesson, printed in place of blank lines and cells.
struct LearnersWork {
  struct Answer {
    std::string text;              ///< may be empty
    std::vector<LessonTry> tries;  ///< with the control of the question
  };
  std::string prediction;       ///< may be empty
  std::vector<Answer> answers;  ///< per question; may be shorter
  std::string transfer;         ///< the completed sentence; may be empty
};

/// Contents of a lesson on paper in addition to its texts.
struct HandoutContents {
  HandoutReader reader = HandoutReader::everybody;
  WrittenNumbers numbers;                        ///< from LessonRuns::numbers()
  std::vector<std::vector<ClaimResult>> claims;  ///< per question; may be shorter
  std::string figures;                           ///< HTML of pictures of the initial situation
  std::string charts;                            ///< the same, after the prediction
  std::vector<std::string> question_figures;     ///< for the teacher, per question; may be shorter
  SettingWords words = {};                       ///< titles with their units, in the language of the lesson
  LearnersWork work = {};                        ///< not for the teacher
};

/// Numbers, and for the teacher the results of the claims; no pictures. Throws as LessonRuns does.
HandoutContents handout_contents(const Lesson& lesson, LessonRuns& runs, HandoutReader reader,
                                 Progress* progress = nullptr);

/// A lesson on paper: one self-contained HTML file, laid out for A4.
std::string handout_html(const Lesson& lesson, const HandoutContents& contents);

}  // namespace feedscope
