#include "core/lessons/handout.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/base/markdown.h"
#include "core/lessons/lesson_language.h"

namespace feedscope {
namespace {

// Lengths in px, which are 1/96 inch on paper: page layouts that know no mm read this as well.
constexpr const char* style = R"(
@page { size: A4; margin: 20mm 18mm; }
body { font-family: "DejaVu Sans", "Noto Sans", Arial, sans-serif; font-size: 14px; line-height: 145%; color: #111; max-width: 660px; margin: 0; }
h1 { font-size: 25px; line-height: 120%; margin: 0 0 8px; }
h2 { font-size: 17px; margin: 26px 0 8px; break-after: avoid; }
p, ul, ol { margin: 0 0 10px; }
code { font-family: "DejaVu Sans Mono", monospace; font-size: 12px; }
.learn { font-style: italic; }
table.setup { border-collapse: collapse; margin: 11px 0; }
table.setup td { padding: 2px 19px 2px 0; vertical-align: top; }
.name { color: #555; }
table.question { border-collapse: collapse; width: 100%; margin: 19px 0; }
table.question td { break-inside: avoid; }
.question h2 { margin-top: 0; }
.hint { color: #555; font-size: 13px; }
table.lines { border-collapse: collapse; width: 100%; }
table.lines td { border-bottom: 1px solid #999; height: 30px; font-size: 17px; }
h1.answers { break-before: page; page-break-before: always; }
.answer { break-inside: avoid; }
.figure { break-inside: avoid; margin-top: 6px; }
.figure td { line-height: 100%; }
.caption { color: #555; font-size: 12px; margin: 3px 0 10px; }
img { max-width: 100%; height: auto; }
.footer { margin-top: 30px; border-top: 1px solid #999; font-size: 12px; color: #555; padding-top: 8px; }
)";

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

std::string row(const std::string& name, const std::string& value) {
  return fmt::format("<tr><td class=\"name\">{}</td><td>{}</td></tr>\n", escaped(name), escaped(value));
}

std::string setup_table(const Lesson& lesson) {
  const auto word = [&](const std::string& english) { return lesson_word(english, lesson.language); };
  const LessonSetup start = set_up(lesson, {});
  const ModelInfo& model = start.setup.model->info();
  std::string table = "<table class=\"setup\">\n";
  table += row(word("Program"), start.program.filename().string());
  table +=
      row(word("Machine"), fmt::format("{} ({})", start.setup.machine.name, start.setup.machine.control));
  table += row(word("Control model"),
               fmt::format(fmt::runtime(word("{}: {}")), model.id, word(std::string(model.title))));
  for (const std::string& change : lesson.start) {
    const std::string key = assigned_key(change);
    if (key != "program" && key != "machine" && key != "model") {
      table += row(word("Setting"), change);
    }
  }
  return table + "</table>\n";
}

std::string question_html(const Question& question, std::size_t number, const WrittenNumbers& numbers,
                          const std::string& language) {
  const auto word = [&](const std::string& english) { return lesson_word(english, language); };
  std::string html = fmt::format("<table class=\"question\" width=\"100%\"><tr><td>\n<h2>{} {}</h2>\n{}",
                                 word("Question"), number, markdown_as_html(filled(question.text, numbers)));
  if (!question.with.empty()) {
    html += fmt::format("<p><b>{}</b> <code>{}</code></p>\n", word("First set"),
                        escaped(fmt::format("{}", fmt::join(question.with, ", "))));
  }
  html +=
      fmt::format("<p><b>{}</b> <code>{}</code><br><b>{}</b> {}{}</p>\n", word("Move"),
                  escaped(control_text(question.control, language)), word("Watch"),
                  escaped(title_of(question.watch, language)),
                  question.watch.spec->unit.empty() ? "" : fmt::format(" [{}]", question.watch.spec->unit));
  if (!question.hint.empty()) {
    html += fmt::format(
        "<div class=\"hint\">{}</div>\n",
        markdown_as_html(fmt::format(fmt::runtime(word("*Hint:* {}")), filled(question.hint, numbers))));
  }
  constexpr int lines = 3;
  html += "<table class=\"lines\" width=\"100%\">\n";
  for (int i = 0; i < lines; ++i) {
    html += "<tr><td>&nbsp;</td></tr>\n";
  }
  return html + "</table>\n</td></tr></table>\n";
}

}  // namespace

std::string handout_html(const Lesson& lesson, const WrittenNumbers& numbers, const std::string& figures) {
  const auto word = [&](const std::string& english) { return lesson_word(english, lesson.language); };
  std::string html = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"{4}\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, "
      "initial-scale=1\">\n<title>{0}</title>\n<style>{1}"
      "</style>\n</head>\n<body>\n<h1>{0}</h1>\n<p class=\"learn\">{2} {3}</p>\n",
      escaped(lesson.title), style, escaped(lesson.learn),
      fmt::format(fmt::runtime(word("About {} minutes.")), lesson.minutes), lesson.language);
  html += setup_table(lesson) + markdown_as_html(filled(lesson.text, numbers)) + figures;
  for (std::size_t i = 0; i < lesson.questions.size(); ++i) {
    html += question_html(lesson.questions[i], i + 1, numbers, lesson.language);
  }
  html += fmt::format("<h1 class=\"answers\">{}</h1>\n", word("Answers"));
  for (std::size_t i = 0; i < lesson.questions.size(); ++i) {
    html += fmt::format("<div class=\"answer\">\n<h2>{} {}</h2>\n{}</div>\n", word("Question"), i + 1,
                        markdown_as_html(filled(lesson.questions[i].answer, numbers)));
  }
  html += fmt::format("<h2>{}</h2>\n<ul>\n", word("Sources"));
  for (const std::string& source : lesson.sources) {
    html += fmt::format("<li>{}</li>\n", escaped(source));
  }
  return html + fmt::format("</ul>\n<p class=\"footer\">{}</p>\n</body>\n</html>\n",
                            word("Every number of the simulation on these pages was simulated by Feedscope "
                                 "when they were made."));
}

}  // namespace feedscope
