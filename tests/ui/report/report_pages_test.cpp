#include <gtest/gtest.h>

#include <QLocale>
#include <QRegularExpression>

#include "core/base/data_folder.h"
#include "core/lessons/lesson_language.h"
#include "core/lessons/lesson_runs.h"
#include "tests/support/random_cases.h"
#include "tests/ui/report/page_checks.h"
#include "tests/ui/report/report_fixture.h"
#include "ui/language/language.h"
#include "ui/report/handout.h"
#include "ui/report/paged_document.h"
#include "ui/report/report.h"

namespace feedscope::ui {
namespace {

void check(const ReportPage& page) {
  const PagedDocument document(page.html, page.pictures);
  test::check_pages(document.text(), document.pages(), Paper().contents_height());
}

struct SampleReport {
  const char* program;
  std::vector<const char*> models;
  std::vector<double> tolerances;
};

class ReportPages : public testing::TestWithParam<SampleReport> {};

TEST_P(ReportPages, AreWellFilledAndKeepTogetherWhatBelongsTogether) {
  const LoadedProgram program = load_program(data_folder() / "resources" / "programs" / GetParam().program);
  std::vector<std::shared_ptr<const ShownRun>> shown;
  for (const char* model : GetParam().models) {
    for (const double tolerance : GetParam().tolerances) {
      shown.push_back(make_shown(simulate_run(program, make_setup({"", model, tolerance, {}}))));
    }
  }
  ReportInput input;
  input.runs = report_runs(shown);
  input.commands = QStringList(1 + static_cast<int>(shown.size()),
                               QStringLiteral("feedscope simulate part.nc --model essid --tolerance 0.01"));
  for (const QString& language : languages()) {
    if (language != languages().front()) {
      speak(language);
    }
    check(report_page(input, load_report_template(), ReportFormat::pdf));
    check(report_page(test::with_appendices(input), load_report_template(), ReportFormat::pdf));
  }
  speak(languages().front());
  QLocale::setDefault(QLocale::c());
}

INSTANTIATE_TEST_SUITE_P(
    OfSamples, ReportPages,
    testing::Values(SampleReport{"trochoidal_slot.nc", {"essid"}, {0.01, 0.05}},
                    SampleReport{"trochoidal_slot.nc", {"essid"}, {0.02}},
                    SampleReport{"fanuc_flange.nc", {"essid"}, {0.01}},
                    SampleReport{"heidenhain_plate.h", {"essid", "ward"}, {0.01, 0.1}},
                    SampleReport{"sinumerik_plate.mpf", {"essid", "gassara", "ward"}, {0.02}},
                    SampleReport{"lesson_corners.nc", {"essid"}, {0.01, 0.02, 0.03, 0.05, 0.1, 0.2}},
                    SampleReport{"essid_table1.nc", {"cam"}, {0.01}}));

class HandoutPages : public testing::TestWithParam<std::filesystem::path> {};

TEST_P(HandoutPages, AreWellFilledAndKeepTogetherWhatBelongsTogether) {
  for (const std::string& language : lesson_languages()) {
    speak(QString::fromStdString(language));  // titles of settings are those of the window
    const Lesson lesson = read_lesson(GetParam(), language);
    LessonRuns runs(lesson);
    for (const HandoutReader reader :
         {HandoutReader::everybody, HandoutReader::learners, HandoutReader::teacher}) {
      SCOPED_TRACE(handout_readers()[static_cast<std::size_t>(reader)]);
      const ReportPage page = handout_page(lesson, runs, reader);
      EXPECT_TRUE(reader != HandoutReader::teacher || !page.pictures.all().empty());
      check(page);
      if (reader == HandoutReader::learners) {
        EXPECT_EQ(PagedDocument(page.html, page.pictures).pages().size(), 2U) << language;
      }
    }
  }
  speak(languages().front());
  QLocale::setDefault(QLocale::c());
}

TEST(Handout, ItsFiguresAreExplainedInTheLanguageOfTheLesson) {
  const Lesson lesson = read_lesson(find_lesson("3"), "fr");
  LessonRuns runs(lesson);
  const QString html = handout_page(lesson, runs, HandoutReader::teacher).html;
  EXPECT_TRUE(html.contains("Figure 1. Trajectoires programmée et exécutée"));
  EXPECT_TRUE(html.contains("Figure 2. Avance et ses causes de limitation"));
}

TEST(Handout, CallsSettingsAsTheWindowDoes) {
  const Lesson lesson = read_lesson(find_lesson("6"));
  LessonRuns runs(lesson);
  const QString html = handout_page(lesson, runs, HandoutReader::learners).html;
  EXPECT_TRUE(html.contains("Look-ahead (blocks): 4, 8, 16, 17, 32"))
      << html.mid(html.indexOf("Move"), 200).toStdString();
  EXPECT_TRUE(html.contains("Program: lesson_lookahead.nc"));
  EXPECT_FALSE(html.contains("lookahead_blocks"));
}

/// Who has to predict sees the path in one colour, and neither charts nor what limits the feed.
TEST(Handout, LearnersSeeNothingThatTellsTheAnswer) {
  const Lesson lesson = read_lesson(find_lesson("3"));
  LessonRuns runs(lesson);
  const ReportPage page = handout_page(lesson, runs, HandoutReader::learners);
  EXPECT_EQ(page.pictures.all().size(), 1U);
  EXPECT_TRUE(page.html.contains("Figure 1. Path of"));
}

/// Of their own, or an earlier one that shows the same.
TEST(Handout, MostQuestionsHaveAPicture) {
  std::size_t questions = 0;
  qsizetype pictures = 0;
  for (const std::filesystem::path& file : shipped_lessons()) {
    const Lesson lesson = read_lesson(file);
    LessonRuns runs(lesson);
    const QString html = handout_page(lesson, runs, HandoutReader::teacher).html;
    questions += lesson.questions.size();
    pictures += html.count(QStringLiteral("src=\"picture:question"));
    const qsizetype of_causes = html.count(QStringLiteral("src=\"picture:causes1\""));
    EXPECT_LE(of_causes, 1) << lesson.title;
    static const QRegularExpression reference("<p class=\"caption\">[^<]* \\(<a href=\"#figure");
    pictures += of_causes + html.count(reference);
    EXPECT_EQ(html.count(QRegularExpression("Already shown: [^<]*</p>")), 0) << "each names its figure";
    EXPECT_EQ(html.count(QRegularExpression("</a>\\)</p>\\s*<h3")), 0) << "and stays with its question";
    EXPECT_FALSE(html.contains("along the path:")) << "a cycle time is no limit";
  }
  EXPECT_GT(2 * pictures, static_cast<qsizetype>(questions)) << pictures << " of " << questions;
}

INSTANTIATE_TEST_SUITE_P(OfEveryLesson, HandoutPages, testing::ValuesIn(test::in_turns(shipped_lessons())),
                         [](const auto& each) { return "Lesson" + each.param.stem().string(); });

}  // namespace
}  // namespace feedscope::ui
