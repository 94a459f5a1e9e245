// Any bytes as a lesson: each question of what is read can be set up, whatever value its control has.
#include <array>
#include <cstdint>
#include <string>

#include "core/base/data_folder.h"
#include "core/base/error.h"
#include "core/lessons/lesson.h"
#include "tests/fuzz/must.h"

using namespace feedscope;

namespace {

void set_up_questions(const Lesson& lesson) {
  for (const Question& question : lesson.questions) {
    set_up(lesson, question.with);
    for (const std::string& value : question.control.values) {
      Changes changes = question.with;
      changes.push_back(question.control.key + "=" + value);
      set_up(lesson, changes);
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const auto file = data_folder() / "resources/lessons/fuzz.toml";
  const std::string text(data, data + size);
  for (const char* language : std::array{"en", "fr"}) {
    Lesson lesson;
    try {
      lesson = parse_lesson(text, file, language);
    } catch (const InputError&) {
      continue;
    }
    fuzz::must(!lesson.questions.empty(), "a lesson without questions");
    set_up_questions(lesson);
  }
  return 0;
}
