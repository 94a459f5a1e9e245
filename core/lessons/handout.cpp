#include "core/lessons/handout.h"

#include <cmark.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdlib>
#include <memory>

namespace feedscope {
namespace {

constexpr const char* style = R"(
@page { size: A4; margin: 20mm 18mm; }
body { font: 11pt/1.45 "DejaVu Sans", "Noto Sans", Arial, sans-serif; color: #111; max-width: 174mm; margin: 0 auto; }
h1 { font-size: 19pt; line-height: 1.2; margin: 0 0 2mm; }
h2 { font-size: 13pt; margin: 7mm 0 2mm; break-after: avoid; }
p, ul, ol { margin: 0 0 2.5mm; }
code { font-family: "DejaVu Sans Mono", monospace; font-size: 0.9em; }
.learn { font-style: italic; }
table.setup { border-collapse: collapse; margin: 3mm 0; }
table.setup th { text-align: left; font-weight: normal; color: #555; padding: 0.5mm 5mm 0.5mm 0; vertical-align: top; }
.question { break-inside: avoid; border-left: 0.8mm solid #0b5fa5; padding-left: 4mm; margin: 5mm 0; }
.hint { color: #555; font-size: 10pt; }
.lines { border-bottom: 0.2mm solid #999; height: 8mm; }
.answers { break-before: page; }
.answer { break-inside: avoid; }
footer { margin-top: 8mm; border-top: 0.2mm solid #999; font-size: 9pt; color: #555; padding-top: 2mm; }
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
  return fmt::format("<tr><th>{}</th><td>{}</td></tr>\n", escaped(name), escaped(value));
}

std::string setup_table(const Lesson& lesson) {
  const LessonSetup start = set_up(lesson, {});
  std::string table = "<table class=\"setup\">\n";
  table += row("Program", start.program.filename().string());
  table += row("Machine", fmt::format("{} ({})", start.setup.machine.name, start.setup.machine.control));
  table += row("Control model",
               fmt::format("{}: {}", start.setup.model->info().id, start.setup.model->info().title));
  for (const std::string& change : lesson.start) {
    const std::string key = assigned_key(change);
    if (key != "program" && key != "machine" && key != "model") {
      table += row("Setting", change);
    }
  }
  return table + "</table>\n";
}

std::string question_html(const Question& question, std::size_t number, const WrittenNumbers& numbers) {
  std::string html = fmt::format("<div class=\"question\">\n<h2>Question {}</h2>\n{}", number,
                                 html_of(filled(question.text, numbers)));
  if (!question.with.empty()) {
    html += fmt::format("<p><b>First set</b> <code>{}</code></p>\n",
                        escaped(fmt::format("{}", fmt::join(question.with, ", "))));
  }
  html +=
      fmt::format("<p><b>Move</b> <code>{}</code><br><b>Watch</b> {}{}</p>\n",
                  escaped(control_text(question.control)), escaped(title_of(question.watch)),
                  question.watch.spec->unit.empty() ? "" : fmt::format(" [{}]", question.watch.spec->unit));
  if (!question.hint.empty()) {
    html +=
        fmt::format("<div class=\"hint\">{}</div>\n", html_of("*Hint:* " + filled(question.hint, numbers)));
  }
  constexpr int lines = 3;
  for (int i = 0; i < lines; ++i) {
    html += "<div class=\"lines\"></div>\n";
  }
  return html + "</div>\n";
}

}  // namespace

std::string html_of(const std::string& markdown) {
  const std::unique_ptr<char, void (*)(void*)> html(
      cmark_markdown_to_html(markdown.data(), markdown.size(), CMARK_OPT_DEFAULT), std::free);
  return html.get();
}

std::string handout_html(const Lesson& lesson, const WrittenNumbers& numbers) {
  std::string html = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<title>{0}</title>\n<style>{1}"
      "</style>\n</head>\n<body>\n<h1>{0}</h1>\n<p class=\"learn\">{2} About {3} minutes.</p>\n",
      escaped(lesson.title), style, escaped(lesson.learn), lesson.minutes);
  html += setup_table(lesson) + html_of(filled(lesson.text, numbers));
  for (std::size_t i = 0; i < lesson.questions.size(); ++i) {
    html += question_html(lesson.questions[i], i + 1, numbers);
  }
  html += "<section class=\"answers\">\n<h1>Answers</h1>\n";
  for (std::size_t i = 0; i < lesson.questions.size(); ++i) {
    html += fmt::format("<div class=\"answer\">\n<h2>Question {}</h2>\n{}</div>\n", i + 1,
                        html_of(filled(lesson.questions[i].answer, numbers)));
  }
  html += "<h2>Sources</h2>\n<ul>\n";
  for (const std::string& source : lesson.sources) {
    html += fmt::format("<li>{}</li>\n", escaped(source));
  }
  return html +
         "</ul>\n</section>\n<footer>Feedscope. Every number of the simulation on these pages was simulated "
         "when "
         "they were made.</footer>\n</body>\n</html>\n";
}

}  // namespace feedscope
