#pragma once

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

/// Changes against what a lesson begins with, each KEY=VALUE: a setting or axis limit as of --set,
/// `tolerance` (mm, as of --tolerance), `machine`, `model` or `program`.
using Changes = std::vector<std::string>;

/// How a quantity of one run is put against that of another.
enum class Relation : std::uint8_t { ratio, difference, percent_more, percent_less };

/// A measure of the run with some changes, alone or against the run with others.
struct LessonQuantity {
  Measure measure;
  Changes with;
  std::optional<Changes> against;
  Relation relation = Relation::ratio;  ///< to `against`
  int decimals = 0;                     ///< when it is written
};

/// A number that texts of the lesson take from somewhere else.
struct GivenNumber {
  double value = 0;
  std::string unit;     ///< may be ""
  std::string written;  ///< in the language of the lesson, with its unit: "2.01 m/min"
  std::string source;   ///< "Tapie 2007, table 3"
};

/// What must hold of a quantity, so that a text that builds on it is right.
struct Claim {
  enum class Kind : std::uint8_t { less_than, more_than, about, between };
  LessonQuantity quantity;
  Kind kind = Kind::less_than;
  /// A number, or the run whose quantity it is compared with; of `between` the lower bound.
  std::variant<double, Changes> bound = 0.0;
  double upper = 0;             ///< of `between`
  double within = 0;            ///< of `about`: allowed difference [unit of the quantity]
  bool within_percent = false;  ///< `within` is in percent of the bound
  std::string place;            ///< FILE:LINE:COLUMN
};

/// The one setting that a question moves.
struct Control {
  std::string key;                  ///< as of Changes
  std::vector<std::string> values;  ///< suggested, or both ends of a range
  bool range = false;
};

struct Question {
  std::string text;  ///< Markdown with {numbers}, as hint and answer
  Changes with;      ///< what to set before the control is moved
  Control control;
  Measure watch;
  std::string hint;  ///< may be ""
  std::string answer;
  std::vector<Claim> claims;
};

/// What the window shows when the lesson begins, beyond program, machine, model and settings.
struct LessonWindow {
  std::string colouring = "feed";                        ///< one of lesson_colourings()
  std::string camera = "top";                            ///< one of lesson_cameras()
  std::optional<std::pair<double, double>> chart_range;  ///< [s]
  std::vector<Changes> runs;                             ///< shown beside the first one
};

/// A lesson for a course: a text, and questions that are answered by moving one control.
struct Lesson {
  std::filesystem::path file;
  std::string id;               ///< file name without ending
  std::string language = "en";  ///< of the texts and their numbers
  /// What the language asked for has no text for, which is English: "'hint' of question 2".
  std::vector<std::string> untranslated;
  std::string title;
  std::string learn;  ///< what one learns, a sentence or two
  double minutes = 0;
  bool half_day = false;  ///< of the course of half a day; all are of that of two days
  /// Ids of earlier lessons that this one answers for.
  std::vector<std::string> replaces;
  std::vector<std::string> sources;
  std::string text;      ///< Markdown with {numbers}, as the next two
  std::string predict;   ///< to be written down before anything is shown; may be ""
  std::string transfer;  ///< a sentence about one's own control, to be completed; may be ""
  Changes start;         ///< program, machine, perhaps model, settings
  LoadSetup load;        ///< how the tools are engaged in the program of the start; may be empty
  LessonWindow window;
  std::map<std::string, LessonQuantity> numbers;
  std::map<std::string, GivenNumber> given;
  std::vector<Question> questions;
};

/// Valid names of LessonWindow; the window knows all of them.
const std::vector<std::string>& lesson_colourings();
const std::vector<std::string>& lesson_cameras();

/// A program and what it runs on.
struct LessonSetup {
  std::filesystem::path program;
  Setup file;   ///< machine and model as their files have them
  Setup setup;  ///< with all settings of the lesson
};
/// The start of a lesson with `changes`. A setting of the start that another model does not know is omitted,
/// one of `changes` is not. Throws InputError naming key, value, bounds and the nearest valid name.
LessonSetup set_up(const Lesson& lesson, const Changes& changes);
/// The same again and again: each machine file is read once.
class LessonSetups {
 public:
  LessonSetup set_up(const Lesson& lesson, const Changes& changes);

 private:
  std::map<std::pair<std::string, std::string>, Setup> files_;  ///< by machine and model
};
/// A load file beside the lesson, or else the one of resources/examples.
std::filesystem::path find_load_file(const Lesson& lesson, const std::string& name);

/// Reads a lesson; resources/lessons/README.md says what is in it. A program is looked for beside the file,
/// then in resources/programs. Throws InputError naming file, line, key, value and the nearest valid name:
/// unknown or missing key, program, machine, model, setting, measure, cause or number, value out of bounds.
/// `language`: one of lesson_languages(); texts without translation are English, and so is a lesson without
/// any. Mistakes in all languages are found.
Lesson read_lesson(const std::filesystem::path& file, const std::string& language = "en");
/// The same of a text; `file` is where it belongs, for messages, id and program.
Lesson parse_lesson(const std::string& text, const std::filesystem::path& file,
                    const std::string& language = "en");

/// The lessons of resources/lessons in the data folder, sorted by file name.
std::vector<std::filesystem::path> shipped_lessons();
/// The file of a lesson: by id, by the number or the name in an id, by those of a lesson that it replaces, or
/// an existing file. Throws InputError with the nearest id.
std::filesystem::path find_lesson(const std::string& id_or_file);

}  // namespace feedscope
