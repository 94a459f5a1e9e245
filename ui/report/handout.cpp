#include "ui/report/handout.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "core/lessons/lesson_language.h"
#include "ui/language/core_texts.h"
#include "ui/language/texts.h"
#include "ui/paper/html_table.h"
#include "ui/report/question_figure.h"

namespace feedscope::ui {

namespace {

/// Contents of the window at the start of the lesson.
ReportInput input_of(const Lesson& lesson, LessonRuns& runs, Progress* progress) {
  std::vector<std::shared_ptr<const ShownRun>> shown{make_shown(runs.run({}, progress))};
  for (const Changes& changes : lesson.window.runs) {
    const Run& run = runs.run(changes, progress);
    if (run.input.program == shown.front()->run.input.program) {
      shown.push_back(make_shown(run));
    }
  }
  ReportInput input;
  input.runs = report_runs(shown);
  input.scene.colouring = *std::ranges::find(all_colourings(), lesson.window.colouring,
                                             [](Colouring c) { return colouring_key(c); });
  const auto camera = std::ranges::find(lesson_cameras(), lesson.window.camera);
  input.view = static_cast<StandardView>(camera - lesson_cameras().begin());
  if (lesson.window.chart_range) {
    input.charts.time = Interval{lesson.window.chart_range->first, lesson.window.chart_range->second};
  }
  return input;
}

std::string title_with_unit(const std::string& key) {
  return setting_title_with_unit(key).toStdString();
}

/// Programs by their names, words as in the window.
std::string word_for_value(const std::string& key, const std::string& value) {
  return key == "program" ? std::filesystem::path(value).filename().string() : core_text(value).toStdString();
}

}  // namespace

ReportPage handout_page(const Lesson& lesson, LessonRuns& runs, HandoutReader reader, const SceneTexts& texts,
                        Progress* progress, LearnersWork work) {
  HandoutContents contents = handout_contents(lesson, runs, reader, progress);
  contents.words = {.title = title_with_unit, .value = word_for_value};
  contents.work = std::move(work);
  ReportInput input = input_of(lesson, runs, progress);
  input.texts = texts;
  ReportPage page{{}, ReportPictures(progress)};
  constexpr double charts_height = 360;
  const auto caption = [&](const char* english) {
    return QString::fromStdString(fmt::format(fmt::runtime(lesson_word(english, lesson.language)),
                                              html_text(input.run().name).toStdString()));
  };
  const bool of_teacher = reader == HandoutReader::teacher;
  const double view_height = of_teacher ? 270 : 180;  // copies for learners have two pages
  if (!of_teacher) {                                  // a learner who has to predict sees the path only
    input.scene.colouring = Colouring::run;
  }
  if (!is_straight(*input.run().shown->samples)) {
    ReportInput alone = without_other_runs(input);
    alone.texts = without_line_names(std::move(alone.texts));  // they would lie over so low a picture
    contents.figures = run_view(alone, page.pictures, view_height,
                                caption(of_teacher ? "Programmed and executed path of {}." : "Path of {}."))
                           .toStdString();
  }
  if (of_teacher) {
    contents.charts = run_charts(input, input.current, page.pictures, charts_height,
                                 caption("Feed with its limiting causes, acceleration and jerk of {}."))
                          .toStdString();
  }
  for (std::size_t i = 0; of_teacher && i < lesson.questions.size(); ++i) {
    contents.question_figures.push_back(
        question_figure(lesson, i, input, runs, page.pictures, progress).toStdString());
  }
  page.html = with_figure_numbers(QString::fromStdString(handout_html(lesson, contents)));
  return page;
}

std::string make_handout(const Lesson& lesson, LessonRuns& runs, HandoutReader reader, ReportFormat format,
                         const SceneTexts& texts, Progress* progress, LearnersWork work) {
  const ReportPage page = handout_page(lesson, runs, reader, texts, progress, std::move(work));
  const PageTexts on_pages{QString::fromStdString(lesson.title),
                           {},
                           {},
                           QString::fromStdString(lesson_word("page %1 of %2", lesson.language))};
  return file_of(page, format, on_pages);
}

}  // namespace feedscope::ui
