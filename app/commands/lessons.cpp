#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "app/commands/command.h"
#include "app/exit_codes.h"
#include "app/output_file.h"
#include "app/output_format.h"
#include "app/print.h"
#include "app/watch.h"
#include "core/base/error.h"
#include "core/lessons/handout.h"
#include "core/lessons/lesson_language.h"
#include "core/lessons/lesson_runs.h"
#include "core/lessons/plain_text.h"
#ifdef FEEDSCOPE_WITH_UI
#include <QLocale>

#include "ui/language/language.h"
#include "ui/report/handout.h"
#include "ui/scene_view/scene_texts.h"
#include "ui/session/session_file.h"
#include "ui/theme/offscreen_application.h"
#endif

namespace feedscope {
namespace {

#ifdef FEEDSCOPE_WITH_UI
const std::string printed_format = "feedpages";
#endif

struct LessonsOptions {
  std::string id;
  bool check = false;
  std::string out;
  std::string format;
  std::string language = lesson_languages().front();
  std::string reader = handout_readers().front();
  std::string session;
};

/// Prints the lessons in their order, and the two ways through them.
void list_lessons(const std::string& language) {
  const auto word = [&](const char* english) { return lesson_word(english, language); };
  std::vector<std::size_t> half_day;
  double minutes = 0;
  std::size_t number = 0;
  for (const std::filesystem::path& file : shipped_lessons()) {
    const Lesson lesson = read_lesson(file, language);
    ++number;
    if (lesson.half_day) {
      half_day.push_back(number);
      minutes += lesson.minutes;
    }
    fmt::print("{}: {} ({} min{})\n    {}\n", lesson.id, lesson.title, lesson.minutes,
               lesson.half_day ? ", " + word("half day") : "", wrapped(lesson.learn, 4));
  }
  fmt::print("\n{}\n{}\n",
             fmt::format(fmt::runtime(word("Half a day, {} minutes: lessons {}")), minutes,
                         fmt::join(half_day, ", ")),
             word("Two days: all, with own programs after 4, 8 and 12"));
}

/// Paragraphs and list items of a Markdown text, each wrapped by itself; code as it is.
void print_text(const std::string& text, std::size_t indent) {
  bool first = true;
  for (const PlainBlock& block : plain_blocks(text)) {
    fmt::print("{}", first || block.follows ? "" : "\n");
    first = false;
    const std::size_t inside = indent + block.indent;
    const std::string blanks(inside - block.marker.size(), ' ');
    fmt::print("{}{}{}\n", blanks, block.marker,
               block.code ? "    " + block.text : wrapped(block.text, inside));
  }
}

void print_question(const Question& question, std::size_t number, const WrittenNumbers& numbers,
                    const std::string& language) {
  const auto print_row = [&](const char* name, const std::string& text) {
    constexpr std::size_t column = 8;
    fmt::print("  {:<{}}  {}\n", lesson_word(name, language), column, wrapped(text, column + 4));
  };
  fmt::print("\n{} {}\n", lesson_word("Question", language), number);
  print_text(filled(question.text, numbers), 2);
  if (!question.with.empty()) {
    print_row("Set", fmt::format("{}", fmt::join(question.with, ", ")));
  }
  print_row("Move", control_text(question.control, language));
  print_row("Watch", title_of(question.watch, language));
  if (!question.hint.empty()) {
    print_row("Hint", plain_line(filled(question.hint, numbers)));
  }
}

void show_lesson(const Lesson& lesson, const WrittenNumbers& numbers) {
  const auto word = [&](const char* english) { return lesson_word(english, lesson.language); };
  fmt::print("{} ({} {})\n{}\n\n", lesson.title, lesson.minutes, word("minutes"), wrapped(lesson.learn, 0));
  fmt::print("{} {}\n\n", word("Begins with"), wrapped(fmt::format("{}", fmt::join(lesson.start, ", ")), 4));
  print_text(filled(lesson.text, numbers), 0);
  const auto print_part = [&](const char* heading, const std::string& text) {
    if (!text.empty()) {
      fmt::print("\n{}\n", word(heading));
      print_text(filled(text, numbers), 2);
    }
  };
  print_part("Before you look", lesson.predict);
  for (std::size_t i = 0; i < lesson.questions.size(); ++i) {
    print_question(lesson.questions[i], i + 1, numbers, lesson.language);
  }
  print_part("On my control", lesson.transfer);
  fmt::print("\n{}\n", word("Answers"));
  for (std::size_t i = 0; i < lesson.questions.size(); ++i) {
    fmt::print("\n  {}.\n", i + 1);
    print_text(filled(lesson.questions[i].answer, numbers), 2);
  }
  fmt::print("\n{}\n", word("Sources"));
  for (const std::string& source : lesson.sources) {
    fmt::print("  - {}\n", wrapped(source, 4));
  }
}

std::string result_text(const Claim& claim, const ClaimResult& result) {
  LessonQuantity quantity = claim.quantity;
  quantity.decimals += 2;
  std::string text = fmt::format("{}: {}, expected {}", quantity_text(quantity),
                                 value_text(quantity, result.value), expectation_text(claim));
  if (std::holds_alternative<Changes>(claim.bound)) {
    text += fmt::format(" ({})", value_text(quantity, result.bound));
  }
  return text;
}

/// Notes a language without checks, and the texts of a lesson that lack a translation.
void note_texts(const Lesson& lesson, const std::string& language, bool shipped) {
  const bool english = language == lesson_languages().front();
  const bool translated = lesson.language == language;
  if (!english && !translated) {
    if (shipped) {
      fmt::print("  note   no translation ({})\n", language);
    }
    return;
  }
  const std::string mark = english ? "" : fmt::format(" ({})", language);
  for (const std::string& number : unchecked_numbers(lesson)) {
    fmt::print("  note   nothing checks the number {}{}\n", number, mark);
  }
  for (const std::string& text : lesson.untranslated) {
    fmt::print("  note   no translation of {}{}\n", text, mark);
  }
}

bool is_shipped(const std::filesystem::path& file) {
  const std::vector<std::filesystem::path> shipped = shipped_lessons();
  return std::any_of(shipped.begin(), shipped.end(), [&](const std::filesystem::path& one) {
    std::error_code ignored;
    return std::filesystem::equivalent(one, file, ignored);
  });
}

/// Simulates every claim and prints its result; returns how many do not hold.
int check_lesson(const Lesson& lesson) {
  struct Line {
    std::size_t question;
    const Claim* claim;
    ClaimResult result;
  };
  std::vector<Line> lines;
  {
    Watch watch;
    Progress* progress = watch.stage("simulating");
    LessonRuns runs(lesson);
    runs.numbers(progress);
    for (std::size_t i = 0; i < lesson.questions.size(); ++i) {
      for (const Claim& claim : lesson.questions[i].claims) {
        lines.push_back({i + 1, &claim, runs.check(claim, progress)});
      }
    }
  }
  int failed = 0;
  fmt::print("{}: {}\n", lesson.id, lesson.title);
  for (const Line& line : lines) {
    failed += line.result.holds ? 0 : 1;
    fmt::print("  {} question {}: {}\n", line.result.holds ? "holds " : "FAILS ", line.question,
               wrapped(result_text(*line.claim, line.result), 9));
    if (!line.result.holds) {
      fmt::print("         {}\n", line.claim->place);
    }
  }
  const bool shipped = is_shipped(lesson.file);
  for (const std::string& language : lesson_languages()) {
    note_texts(read_lesson(lesson.file, language), language, shipped);
  }
  return failed;
}

int check_lessons(const std::string& id) {
  const std::vector<std::filesystem::path> files =
      id.empty() ? shipped_lessons() : std::vector{find_lesson(id)};
  int failed = 0;
  for (const std::filesystem::path& file : files) {
    failed += check_lesson(read_lesson(file));
  }
  if (failed > 0) {
    fmt::print("{} claim{} not hold\n", failed, failed == 1 ? " does" : "s do");
  }
  return failed > 0 ? exit_code::claim_fails : exit_code::done;
}

std::string format_of(const LessonsOptions& options) {
#ifdef FEEDSCOPE_WITH_UI
  if (options.format.empty() && asks_for_pages(options.out)) {
    return printed_format;
  }
  return output_format(options.out, options.format, {"html", "pdf"});
#else
  return output_format(options.out, options.format, {"html"});
#endif
}

/// The hand-out in a format, with pictures if this build can draw.
std::string handout([[maybe_unused]] const std::string& format, const LessonsOptions& options,
                    const Lesson& lesson, LessonRuns& runs, Progress* progress) {
  const HandoutReader reader = handout_reader(options.reader);
#ifdef FEEDSCOPE_WITH_UI
  const LearnersWork work =
      options.session.empty() ? LearnersWork() : ui::work_on(lesson, ui::read_lesson_work(options.session));
  const ui::OffscreenApplication application;
  ui::SceneTexts texts;
  if (lesson.language != lesson_languages().front()) {
    const QString language = QString::fromStdString(lesson.language);
    ui::speak(language);
    texts = ui::scene_texts();
  }
  return ui::make_handout(lesson, runs, reader,
                          format == "pdf"            ? ui::ReportFormat::pdf
                          : format == printed_format ? ui::ReportFormat::pages
                                                     : ui::ReportFormat::html,
                          texts, progress, work);
#else
  return handout_html(lesson, handout_contents(lesson, runs, reader, progress));
#endif
}

int run_lessons(const LessonsOptions& options) {
  if (options.id.empty() && !options.out.empty()) {
    throw InputError("--out writes one lesson: give its ID ('feedscope lessons' lists them)");
  }
  if (!options.session.empty() && handout_reader(options.reader) == HandoutReader::teacher) {
    throw InputError("--session fills in the learner's sheet, not the teacher's; use --for learners");
  }
  if (options.check) {
    return check_lessons(options.id);
  }
  if (options.id.empty()) {
    list_lessons(options.language);
    return exit_code::done;
  }
  const std::string format = options.out.empty() ? "" : format_of(options);
  const std::filesystem::path file = find_lesson(options.id);
  const Lesson lesson = read_lesson(file, options.language);
  std::unique_ptr<OutputFile> out;
  if (!options.out.empty()) {
    check_outputs(file.string(), {options.out});
    out = std::make_unique<OutputFile>(options.out);
  }
  LessonRuns runs(lesson);
  if (out == nullptr) {
    WrittenNumbers numbers;
    {
      Watch watch;
      numbers = runs.numbers(watch.stage("simulating"));
    }
    show_lesson(lesson, numbers);
    return exit_code::done;
  }
  {
    Watch watch;
    out->stream() << handout(format, options, lesson, runs, watch.stage("simulating"));
  }
  out->commit();
  return exit_code::done;
}

}  // namespace

Command add_lessons_command(CLI::App& app) {
  const auto options = std::make_shared<LessonsOptions>();
  CLI::App* command = app.add_subcommand("lessons", "List the lessons for courses, show, check or print one");
  command->add_option("ID", options->id, "Lesson id, its number, or a lesson file");
  CLI::Option* check = command->add_flag("--check", options->check,
                                         "Simulate the claims of the lesson (without ID: of all lessons) and "
                                         "report those that fail (exit code 1)");
  CLI::Option* out =
      command->add_option("--out", options->out, "Write a printable hand-out; - for standard output")
          ->type_name("FILE.pdf|FILE.html")
          ->excludes(check);
  command
      ->add_option("--format", options->format, "html or pdf [the ending of --out; html on standard output]")
      ->check(CLI::IsMember({"html", "pdf"}))
      ->needs(out)
      ->type_name("FORMAT");
  command
      ->add_option("--for", options->reader,
                   fmt::format("Whom the hand-out is for: {}; learners get no answers, the teacher gets them "
                               "with the numbers computed [{}]",
                               fmt::join(handout_readers(), ", "), options->reader))
      ->check(CLI::IsMember(handout_readers()))
      ->needs(out)
      ->type_name("READER");
#ifdef FEEDSCOPE_WITH_UI
  command
      ->add_option("--session", options->session,
                   "Print the prediction, answers and values tried of this session on the learner's sheet")
      ->needs(out)
      ->type_name("FILE.feedscope");
#endif
  command
      ->add_option("--language", options->language,
                   fmt::format("Language of texts and numbers: {} [{}]",
                               fmt::join(lesson_languages(), " or "), options->language))
      ->check(CLI::IsMember(lesson_languages()))
      ->type_name("LANGUAGE")
      ->excludes(check);
  return {command, [options] { return run_lessons(*options); }};
}

}  // namespace feedscope
