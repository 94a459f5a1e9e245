#pragma once

// Room `lessons`: lessons as data. lesson_file.cpp reads texts, runs, questions and claims; lesson_runs.h
// simulates what they need and measure.h measures it, so that every number in a text comes from the run;
// handout.h has the parts of a hand-out.

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/lessons/measure.h"

namespace feedscope {

/// Changes to the start of a lesson, each KEY=VALUE: a setting or axis limit as for --set, `tolerance` (mm,
/// as for --tolerance), `machine`, `model` or `program`.
using Changes = std::vector<std::string>;

/// How a quantity of one run is compared with that of another.
enum class Relation : std::uint8_t { ratio, difference, percent_more, percent_less };

/// A measure of the run with some changes, alone or compared with another run.
struct LessonQuantity {
  Measure measure;
  Changes with;
  std::optional<Changes> against;
  Relation relation = Relation::ratio;  ///< to `against`
  int decimals = 0;                     ///< for display
};

/// A number from another source, used in texts of the lesson.
struct GivenNumber {
  double value = 0;
  std::string unit;     ///< may be ""
  std::string written;  ///< in the language of the lesson, with its unit: "2.01 m/min"
  std::string source;   ///< "Tapie 2007, table 3"
};

/// Condition on a quantity that makes a text based on it correct.
struct Claim {
  enum class Kind : std::uint8_t { less_than, more_than, about, between };
  LessonQuantity quantity;
  Kind kind = Kind::less_than;
  /// A number, or the run for comparison; for `between` the lower bound.
  std::variant<double, Changes> bound = 0.0;
  double upper = 0;             ///< for `between`
  double within = 0;            ///< for `about`: permitted difference [unit of the quantity]
  bool within_percent = false;  ///< `within` is in percent of the bound
  std::string place;            ///< FILE:LINE:COLUMN
};

/// The one setting that a question changes.
struct Control {
  std::string key;                  ///< as in Changes
  std::vector<std::string> values;  ///< suggested ones, or both ends of a range
  bool range = false;
};

struct Question {
  std::string text;  ///< Markdown with {numbers}, like hint and answer
  Changes with;      ///< applied before the control is moved
  Control control;
  Measure watch;
  std::string hint;  ///< may be ""
  std::string answer;
  std::vector<Claim> claims;
};

/// Initial state of the window, besides program, machine, model and settings.
struct LessonWindow {
  std::string colouring = "feed";                        ///< one of lesson_colourings()
  std::string camera = "top";                            ///< one of lesson_cameras()
  std::optional<std::pair<double, double>> chart_range;  ///< [s]
  std::vector<Changes> runs;                             ///< shown together with the first one
};

/// A lesson for a course: a text, and questions to answer by moving one control.
struct Lesson {
  std::filesystem::path file;
  std::string id;               ///< file name without extension
  std::string language = "en";  ///< of the texts and their numbers
  /// Texts missing in the requested language, shown in English: "'hint' of question 2".
  std::vector<std::string> untranslated;
  std::string title;
  std::string learn;  ///< learning goal, one or two sentences
  double minutes = 0;
  bool half_day = false;  ///< part of the half-day course; the two-day course has all lessons
  /// Ids of earlier lessons that this one replaces.
  std::vector<std::string> replaces;
  std::vector<std::string> sources;
  std::string text;      ///< Markdown with {numbers}, like the next two
  std::string predict;   ///< prediction to write down beforehand; may be ""
  std::string transfer;  ///< a sentence about the learner's own control to complete; may be ""
  Changes start;         ///< program, machine, possibly model, settings
  LoadSetup load;        ///< engagement of the tools in the initial program; may be empty
  LessonWindow window;
  std::map<std::string, LessonQuantity> numbers;
  std::map<std::string, GivenNumber> given;
  std::vector<Question> questions;
};

/// Valid names in LessonWindow; the window supports all of them.
const std::vector<std::string>& lesson_colourings();
const std::vector<std::string>& lesson_cameras();

/// A program and its setup.
struct LessonSetup {
  std::filesystem::path program;
  Setup file;   ///< machine and model as in their files
  Setup setup;  ///< with all settings of the lesson
};
/// Start of a lesson with `changes`. A setting of the start that another model does not have is omitted,
/// unlike one in `changes`. Throws InputError with key, value, bounds and the nearest valid name.
LessonSetup set_up(const Lesson& lesson, const Changes& changes);
/// set_up() with cached machine files.
class LessonSetups {
 public:
  LessonSetup set_up(const Lesson& lesson, const Changes& changes);

 private:
  std::map<std::pair<std::string, std::string>, Setup> files_;  ///< by machine and model
};
/// Load file next to the lesson, else the one in resources/examples.
std::filesystem::path find_load_file(const Lesson& lesson, const std::string& name);

/// Reads a lesson in the format of resources/lessons/README.md. A program is searched next to the file, then
/// in resources/programs. Throws InputError with file, line, key, value and the nearest valid name: unknown
/// or missing key, program, machine, model, setting, measure, cause or number, value out of bounds.
/// `language`: one of lesson_languages(); texts without translation are English, and so is a lesson without
/// any. Mistakes in all languages are found.
Lesson read_lesson(const std::filesystem::path& file, const std::string& language = "en");
/// Reads a text; `file` is its place, for messages, id and program.
Lesson parse_lesson(const std::string& text, const std::filesystem::path& file,
                    const std::string& language = "en");

/// Lessons of resources/lessons in the data folder, sorted by file name.
std::vector<std::filesystem::path> shipped_lessons();
/// File of a lesson: by id, by number or name in an id, by those of a lesson that it replaces, or an existing
/// file. Throws InputError with the nearest id.
std::filesystem::path find_lesson(const std::string& id_or_file);

}  // namespace feedscope
