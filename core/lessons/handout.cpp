#include "core/lessons/handout.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <regex>

#include "core/base/error.h"
#include "core/base/markdown.h"
#include "core/lessons/lesson_language.h"
#include "core/models/control_model.h"

namespace feedscope {
namespace {

// Lengths in px, 1/96 inch on paper: page layouts that do not support mm read this as well.
constexpr const char* style = R"(
@page { size: A4; margin: 20mm 18mm; }
body { font-family: "DejaVu Sans", "Noto Sans", Arial, sans-serif; font-size: 14px; line-height: 145%; color: #22262a; max-width: 660px; margin: 0; }
h1 { font-size: 25px; color: #16324f; line-height: 120%; margin: 0 0 8px; }
h2 { font-size: 17px; color: #16324f; margin: 22px 0 8px; break-after: avoid; }
h3 { font-size: 14px; margin: 10px 0 6px; break-after: avoid; }
p, ul, ol { margin: 0 0 10px; }
code { font-family: "DejaVu Sans Mono", monospace; font-size: 12px; }
.learn { font-style: italic; }
table.setup { border-collapse: collapse; margin: 11px 0; }
table.setup td { padding: 2px 19px 2px 0; vertical-align: top; }
.name { color: #555; }
table.question { border-collapse: collapse; width: 100%; margin: 7px 0; }
table.question td { break-inside: avoid; }
.question h2 { margin-top: 0; }
.hint { color: #555; font-size: 13px; }
table.lines { border-collapse: collapse; width: 100%; }
table.lines td { border-bottom: 1px solid #999; height: 27px; font-size: 17px; }
table.blank { border-collapse: collapse; width: 100%; margin: 8px 0; }
table.blank td, table.blank th { border: 1px solid #999; padding: 3px 6px; font-size: 12px; text-align: left; height: 22px; }
.transfer p { line-height: 175%; }
.written { font-style: italic; color: #16324f; margin: 6px 0; }
table.claims { border-collapse: collapse; width: 100%; margin: 6px 0 12px; }
table.claims td, table.claims th { border-bottom: 1px solid #ccc; padding: 3px 8px 3px 0; font-size: 12px; text-align: left; vertical-align: top; }
.fails { color: #c62818; }
h1.answers { break-before: page; page-break-before: always; }
.answer { break-inside: avoid; }
.figure { break-inside: avoid; margin-top: 6px; }
.figure td { line-height: 100%; }
.caption { color: #5a6068; font-size: 12px; margin: 3px 0 10px; }
img { max-width: 100%; height: auto; }
.sources { font-size: 12px; line-height: 130%; }
.footer { margin-top: 14px; border-top: 1px solid #999; font-size: 12px; color: #555; padding-top: 8px; }
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

/// HTML of a text of the lesson.
std::string text_html(const std::string& text, const WrittenNumbers& numbers) {
  return markdown_as_html(kept_together(filled(text, numbers)));
}

std::string row(const std::string& name, const std::string& value) {
  return fmt::format("<tr><td class=\"name\">{}</td><td>{}</td></tr>\n", escaped(name), escaped(value));
}

std::string setup_table(const Lesson& lesson, const SettingWords& words) {
  const auto word = [&](const std::string& english) { return lesson_word(english, lesson.language); };
  const LessonSetup start = set_up(lesson, {});
  const ModelInfo& model = start.setup.model->info();
  std::string table = "<table class=\"setup\">\n";
  table += row(word("Program"), start.program.filename().string());
  table += row(word("Machine"), start.setup.machine.name);
  table += row(word("Control model"),
               fmt::format(fmt::runtime(word("{}: {}")), model.id, word(std::string(model.title))));
  for (const std::string& change : lesson.start) {
    const std::string key = assigned_key(change);
    if (key != "program" && key != "machine" && key != "model") {
      table += row(word("Setting"), change_text(change, lesson.language, words));
    }
  }
  return table + "</table>\n";
}

std::string figure_of(const HandoutContents& contents, std::size_t question) {
  return question < contents.question_figures.size() ? contents.question_figures[question] : std::string();
}

std::string watched_text(const Question& question, const std::string& language) {
  const std::string& unit = question.watch.spec->unit;
  return title_of(question.watch, language) + (unit.empty() ? "" : fmt::format(" [{}]", unit));
}

std::string empty_lines(int count) {
  std::string html = "<table class=\"lines\" width=\"100%\">\n";
  for (int i = 0; i < count; ++i) {
    html += "<tr><td>&nbsp;</td></tr>\n";
  }
  return html + "</table>\n";
}

/// `written` with its line breaks; if empty, `lines` blank lines to write on.
std::string written_or_lines(const std::string& written, int lines) {
  if (written.empty()) {
    return empty_lines(lines);
  }
  std::string html = escaped(written);
  for (std::size_t at = 0; (at = html.find('\n', at)) != std::string::npos; at += 4) {
    html.replace(at, 1, "<br>");
  }
  return fmt::format("<p class=\"written\">{}</p>\n", html);
}

/// A part that stays on one page.
std::string unbroken(const std::string& part) {
  return "<table class=\"question\" width=\"100%\"><tr><td>\n" + part + "</td></tr></table>\n";
}

/// The prediction, with room to write it where it is not written; "" without one.
std::string prediction_html(const Lesson& lesson, const HandoutContents& contents) {
  if (lesson.predict.empty()) {
    return {};
  }
  constexpr int lines = 2;
  const std::string part = fmt::format("<h2>{}</h2>\n{}", lesson_word("Before you look", lesson.language),
                                       text_html(lesson.predict, contents.numbers));
  return contents.reader == HandoutReader::teacher
             ? part
             : unbroken(part + written_or_lines(contents.work.prediction, lines));
}

/// The sentence to complete, with room for a word or a number in place of each "…"; "" without one.
std::string transfer_html(const Lesson& lesson, const HandoutContents& contents) {
  if (lesson.transfer.empty()) {
    return {};
  }
  static const std::regex gap("…");
  const std::string heading = fmt::format("<h2>{}</h2>\n", lesson_word("On my control", lesson.language));
  const std::string text = text_html(lesson.transfer, contents.numbers);
  if (contents.reader == HandoutReader::teacher) {
    return heading + text;
  }
  const std::string& own = contents.work.transfer;
  return unbroken(heading + (own.empty() ? "<div class=\"transfer\">" +
                                               std::regex_replace(text, gap, "__________") + "</div>\n"
                                         : written_or_lines(own, 0)));
}

std::string task_html(const Question& question, std::size_t number, const HandoutContents& contents,
                      const std::string& language) {
  const WrittenNumbers& numbers = contents.numbers;
  const auto word = [&](const std::string& english) { return lesson_word(english, language); };
  std::string html =
      fmt::format("<h2>{} {}</h2>\n{}", word("Question"), number, text_html(question.text, numbers));
  std::string first;
  if (!question.with.empty()) {
    std::vector<std::string> set;
    for (const std::string& assignment : question.with) {
      set.push_back(change_text(assignment, language, contents.words));
    }
    first = fmt::format("<b>{}</b> {}<br>", word("First set"),
                        escaped(fmt::format("{}", fmt::join(set, word("; ")))));
  }
  html += fmt::format("<p>{}<b>{}</b> {}<br><b>{}</b> {}</p>\n", first, word("Move"),
                      escaped(control_text(question.control, language, contents.words)), word("Watch"),
                      escaped(watched_text(question, language)));
  if (!question.hint.empty() && contents.reader != HandoutReader::learners) {
    html += fmt::format("<div class=\"hint\">{}</div>\n",
                        text_html(fmt::format(fmt::runtime(word("*Hint:* {}")), question.hint), numbers));
  }
  return html;
}

/// A row of the values to try: the value, and its result or room for it.
std::string try_row(const std::string& value, const LessonTry* one, const Question& question, bool of_time,
                    const std::string& language) {
  const auto cell = [&](double number, const MeasureSpec& spec) {
    return number_in(fmt::format("{:.{}f}", number, spec.decimals), language);
  };
  std::string time;
  std::string watched;
  if (one != nullptr) {
    time = cell(one->cycle_time, find_measure("cycle_time_s"));
    watched = one->measured ? cell(one->measured.value(), *question.watch.spec) : std::string();
  }
  return fmt::format("<tr><td>{}</td><td>{}</td>{}</tr>\n", escaped(value), time,
                     of_time ? std::string() : fmt::format("<td>{}</td>", watched));
}

/// Table of the values to try, followed by the learner's own values or a row for one.
std::string table_of_tries(const Question& question, const std::vector<LessonTry>& tries,
                           const HandoutContents& contents, const std::string& language) {
  const auto word = [&](const std::string& english) { return lesson_word(english, language); };
  const bool of_time = question.watch.spec->key == "cycle_time_s" && question.watch.first_line == 0;
  std::string html = "<table class=\"blank\" width=\"100%\" border=\"1\" cellspacing=\"0\"><tr>";
  html += fmt::format(
      "<th width=\"34%\">{}</th><th width=\"{}%\">{} [s]</th>",
      escaped(contents.words.title ? contents.words.title(question.control.key) : question.control.key),
      of_time ? 66 : 33, word("cycle time"));
  html += of_time ? std::string()
                  : fmt::format("<th width=\"33%\">{}</th>", escaped(watched_text(question, language)));
  html += "</tr>\n";
  const auto row = [&](const std::string& value, const LessonTry* one) {
    return try_row(value, one, question, of_time, language);
  };
  const std::vector<std::string>& suggested = question.control.values;
  for (const std::string& value : suggested) {
    const auto tried = std::ranges::find(tries, value, &LessonTry::value);
    html += row(written_value(question.control, value, language, contents.words),
                tried == tries.end() ? nullptr : &*tried);
  }
  bool own = false;
  for (const LessonTry& one : tries) {
    if (std::ranges::find(suggested, one.value) == suggested.end()) {
      html += row(fmt::format("{} {}", word("my value:"),
                              written_value(question.control, one.value, language, contents.words)),
                  &one);
      own = true;
    }
  }
  return html + (own ? std::string() : row(word("my value:"), nullptr)) + "</table>\n";
}

std::string learners_question(const Lesson& lesson, std::size_t index, const HandoutContents& contents) {
  const Question& question = lesson.questions[index];
  constexpr int lines = 2;
  const std::vector<LearnersWork::Answer>& answers = contents.work.answers;
  const LearnersWork::Answer answer = index < answers.size() ? answers[index] : LearnersWork::Answer();
  return unbroken(task_html(question, index + 1, contents, lesson.language) +
                  table_of_tries(question, answer.tries, contents, lesson.language) +
                  written_or_lines(answer.text, lines));
}

/// Table of the claims that the answer builds on, with the simulated values.
std::string claims_table(const Lesson& lesson, std::size_t index, const HandoutContents& contents) {
  const std::vector<Claim>& claims = lesson.questions[index].claims;
  if (index >= contents.claims.size() || claims.empty()) {
    return {};
  }
  const auto word = [&](const std::string& english) { return lesson_word(english, lesson.language); };
  SettingWords words = contents.words;
  words.of_question = lesson.questions[index].with;
  std::string html = fmt::format(
      "<table class=\"claims\" width=\"100%\" cellspacing=\"0\"><tr><th width=\"50%\">{}</th>"
      "<th width=\"28%\">{}</th><th width=\"22%\">{}</th></tr>\n",
      word("What the answers build on"), word("Expected"), word("Computed"));
  for (std::size_t i = 0; i < std::min(claims.size(), contents.claims[index].size()); ++i) {
    const ClaimResult& result = contents.claims[index][i];
    LessonQuantity quantity = claims[i].quantity;
    quantity.decimals += 1;  // to distinguish values close to a bound
    std::string computed = value_text(quantity, result.value, lesson.language);
    if (std::holds_alternative<Changes>(claims[i].bound)) {
      computed += fmt::format(" ({})", value_text(quantity, result.bound, lesson.language));
    }
    html += fmt::format(
        "<tr><td>{}</td><td>{}</td><td>{}{}</td></tr>\n",
        escaped(quantity_text(claims[i].quantity, lesson.language, words)),
        escaped(kept_together(expectation_text(claims[i], lesson.language, words))),
        escaped(kept_together(computed)),
        result.holds ? std::string() : fmt::format(" <b class=\"fails\">{}</b>", word("does not hold")));
  }
  return html + "</table>\n";
}

std::string answer_html(const Lesson& lesson, std::size_t index, const HandoutContents& contents,
                        bool with_task) {
  const Question& question = lesson.questions[index];
  std::string html = "<div class=\"answer\">\n";
  if (with_task) {
    // A reference to a picture shown before stays with the question.
    const std::string figure = figure_of(contents, index);
    const bool is_picture = figure.find("<img") != std::string::npos;
    html += unbroken(task_html(question, index + 1, contents, lesson.language) +
                     (is_picture ? std::string() : figure)) +
            (is_picture ? figure : std::string());
    html += fmt::format("<h3>{}</h3>\n", lesson_word("Answer", lesson.language));
  } else {
    html += fmt::format("<h2>{} {}</h2>\n", lesson_word("Question", lesson.language), index + 1);
  }
  return html + text_html(question.answer, contents.numbers) + claims_table(lesson, index, contents) +
         "</div>\n";
}

/// Sources of a lesson and of its numbers.
std::string sources_html(const Lesson& lesson) {
  std::string html =
      fmt::format("<h2>{}</h2>\n<ul class=\"sources\">\n", lesson_word("Sources", lesson.language));
  for (const std::string& source : lesson.sources) {
    html += fmt::format("<li>{}</li>\n", escaped(source));
  }
  return html + fmt::format("</ul>\n<p class=\"footer\">{}</p>\n",
                            lesson_word("Every number of the simulation on these pages was simulated by "
                                        "Feedscope when they were made.",
                                        lesson.language));
}

}  // namespace

const std::vector<std::string>& handout_readers() {
  static const std::vector<std::string> names{"everybody", "learners", "teacher"};
  return names;
}

HandoutReader handout_reader(const std::string& name) {
  const auto found = std::ranges::find(handout_readers(), name);
  if (found == handout_readers().end()) {
    throw InputError(fmt::format("unknown reader '{}' of a hand-out; known: {}", name,
                                 fmt::join(handout_readers(), ", ")));
  }
  return static_cast<HandoutReader>(found - handout_readers().begin());
}

HandoutContents handout_contents(const Lesson& lesson, LessonRuns& runs, HandoutReader reader,
                                 Progress* progress) {
  HandoutContents contents;
  contents.reader = reader;
  contents.numbers = runs.numbers(progress);
  if (reader == HandoutReader::learners) {
    return contents;
  }
  for (const Question& question : lesson.questions) {
    std::vector<ClaimResult>& results = contents.claims.emplace_back();
    for (const Claim& claim : question.claims) {
      results.push_back(runs.check(claim, progress));
    }
  }
  return contents;
}

std::string handout_html(const Lesson& lesson, const HandoutContents& contents) {
  const auto word = [&](const std::string& english) { return lesson_word(english, lesson.language); };
  const bool of_teacher = contents.reader == HandoutReader::teacher;
  std::string html = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"{3}\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, "
      "initial-scale=1\">\n<title>{0}</title>\n<style>{1}"
      "</style>\n</head>\n<body>\n<h1>{0}</h1>\n<div class=\"learn\">{2}</div>\n",
      escaped(lesson.title), style,
      markdown_as_html(fmt::format("{} {}", lesson.learn,
                                   fmt::format(fmt::runtime(word("About {} minutes.")), lesson.minutes))),
      lesson.language);
  if (contents.reader != HandoutReader::everybody) {
    html += fmt::format("<p><b>{}</b></p>\n", word(of_teacher ? "For the teacher" : "For learners"));
  }
  html += setup_table(lesson, contents.words) + text_html(lesson.text, contents.numbers) + contents.figures +
          prediction_html(lesson, contents) + contents.charts;
  for (std::size_t i = 0; i < lesson.questions.size(); ++i) {
    html += of_teacher ? answer_html(lesson, i, contents, true) : learners_question(lesson, i, contents);
  }
  html += transfer_html(lesson, contents);
  if (contents.reader == HandoutReader::everybody) {
    html += fmt::format("<h1 class=\"answers\">{}</h1>\n", word("Answers"));
    for (std::size_t i = 0; i < lesson.questions.size(); ++i) {
      html += answer_html(lesson, i, contents, false);
    }
  }
  return html + (contents.reader == HandoutReader::learners ? std::string() : sources_html(lesson)) +
         "</body>\n</html>\n";
}

}  // namespace feedscope
