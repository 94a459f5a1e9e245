#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "app/commands/command.h"
#include "app/exit_codes.h"
#include "app/output_file.h"
#include "app/print.h"
#include "app/watch.h"
#include "core/base/error.h"
#include "core/lessons/handout.h"
#include "core/lessons/lesson_runs.h"
#include "core/lessons/plain_text.h"
#ifdef FEEDSCOPE_WITH_UI
#include "ui/report/handout.h"
#include "ui/theme/offscreen_application.h"
#endif

namespace feedscope {
namespace {

struct LessonsOptions {
  std::string id;
  bool check = false;
  std::string out;
};

void list_lessons() {
  for (const std::filesystem::path& file : shipped_lessons()) {
    const Lesson lesson = read_lesson(file);
    fmt::print("{}: {} ({} min)\n    {}\n", lesson.id, lesson.title, lesson.minutes,
               wrapped(lesson.learn, 4));
  }
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

void print_question(const Question& question, std::size_t number, const WrittenNumbers& numbers) {
  fmt::print("\nQuestion {}\n", number);
  print_text(filled(question.text, numbers), 2);
  if (!question.with.empty()) {
    fmt::print("  Set    {}\n", fmt::join(question.with, ", "));
  }
  fmt::print("  Move   {}\n  Watch  {}\n", control_text(question.control), title_of(question.watch));
  if (!question.hint.empty()) {
    fmt::print("  Hint   {}\n", wrapped(plain_line(filled(question.hint, numbers)), 9));
  }
}

void show_lesson(const Lesson& lesson, const WrittenNumbers& numbers) {
  fmt::print("{} ({} minutes)\n{}\n\n", lesson.title, lesson.minutes, wrapped(lesson.learn, 0));
  fmt::print("Begins with {}\n\n", wrapped(fmt::format("{}", fmt::join(lesson.start, ", ")), 4));
  print_text(filled(lesson.text, numbers), 0);
  for (std::size_t i = 0; i < lesson.questions.size(); ++i) {
    print_question(lesson.questions[i], i + 1, numbers);
  }
  fmt::print("\nAnswers\n");
  for (std::size_t i = 0; i < lesson.questions.size(); ++i) {
    fmt::print("\n  {}.\n", i + 1);
    print_text(filled(lesson.questions[i].answer, numbers), 2);
  }
  fmt::print("\nSources\n");
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

/// Simulates every claim and says what it comes to; how many do not hold.
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
  for (const std::string& number : unchecked_numbers(lesson)) {
    fmt::print("  note   nothing checks the number {}\n", number);
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

/// The hand-out as the ending of `out` asks for it, with pictures where this Feedscope can draw.
std::string handout([[maybe_unused]] const std::string& out, const Lesson& lesson, LessonRuns& runs,
                    Progress* progress) {
#ifdef FEEDSCOPE_WITH_UI
  const ui::OffscreenApplication application;
  const bool pages = out.ends_with(".pdf");
  return ui::make_handout(lesson, runs, pages ? ui::ReportFormat::pdf : ui::ReportFormat::html, progress);
#else
  return handout_html(lesson, runs.numbers(progress));
#endif
}

void check_ending(const std::string& out) {
  std::vector<std::string> endings{".html"};
#ifdef FEEDSCOPE_WITH_UI
  endings.insert(endings.begin(), ".pdf");
#endif
  const auto fits = [&](const std::string& ending) { return out.ends_with(ending); };
  if (!out.empty() && out != "-" && std::none_of(endings.begin(), endings.end(), fits)) {
    throw InputError(
        fmt::format("no kind of hand-out: '{}' must end in {}", out, fmt::join(endings, " or ")));
  }
}

int run_lessons(const LessonsOptions& options) {
  if (options.id.empty() && !options.out.empty()) {
    throw InputError("--out writes one lesson: give its ID ('feedscope lessons' lists them)");
  }
  if (options.check) {
    return check_lessons(options.id);
  }
  if (options.id.empty()) {
    list_lessons();
    return exit_code::done;
  }
  check_ending(options.out);
  const std::filesystem::path file = find_lesson(options.id);
  const Lesson lesson = read_lesson(file);
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
    out->stream() << handout(options.out, lesson, runs, watch.stage("simulating"));
  }
  out->commit();
  return exit_code::done;
}

}  // namespace

Command add_lessons_command(CLI::App& app) {
  const auto options = std::make_shared<LessonsOptions>();
  CLI::App* command = app.add_subcommand("lessons", "List the lessons for courses, show, check or print one");
  command->add_option("ID", options->id, "Lesson id, its number, or a lesson file");
  CLI::Option* check = command->add_flag(
      "--check", options->check,
      "Simulate what the lesson claims (without ID: all lessons) and say what does not hold (exit code 1)");
  command->add_option("--out", options->out, "Write a hand-out to print; - for standard output (HTML)")
      ->type_name("FILE.pdf|FILE.html")
      ->excludes(check);
  return {command, [options] { return run_lessons(*options); }};
}

}  // namespace feedscope
