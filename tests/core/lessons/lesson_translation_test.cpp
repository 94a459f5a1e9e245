#include "core/base/error.h"
#include "core/lessons/handout.h"
#include "core/lessons/lesson_language.h"
#include "core/lessons/lesson_runs.h"
#include "core/limits/cause.h"
#include "core/models/control_model.h"
#include "tests/core/lessons/lesson_folder.h"

namespace feedscope {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;
using testing::ThrowsMessage;

class LessonTranslation : public test::LessonFolder {
 protected:
  /// good_lesson with French texts, and their first `from` replaced.
  std::filesystem::path french(const std::string& from = "", const std::string& to = "") const {
    std::string texts =
        "[fr]\ntitle = \"Essai\"\nlearn = \"Quelque chose.\"\ntext = \"Il faut {time} à {feed}.\"\n\n[start]";
    std::string question =
        "[question.fr]\ntext = \"Combien ?\"\nhint = \"Voyez.\"\nanswer = \"{less} de moins.\"\n"
        "[[question.claim]]";
    for (std::string* part : {&texts, &question}) {
      if (const std::size_t at = part->find(from); !from.empty() && at != std::string::npos) {
        part->replace(at, from.size(), to);
        break;
      }
    }
    std::string lesson = good_lesson;
    for (const std::string& part : {texts, question}) {
      const std::string table = part.substr(part.rfind('\n') + 1);
      lesson.replace(lesson.find(table), table.size(), part);
    }
    return write(lesson);
  }

  static void expect_error(const std::filesystem::path& file, const std::string& place,
                           const std::string& message) {
    for (const char* language : {"en", "fr"}) {
      EXPECT_THAT([&] { read_lesson(file, language); },
                  ThrowsMessage<InputError>(AllOf(StartsWith(file.string() + place), HasSubstr(message))));
    }
  }
};

TEST_F(LessonTranslation, IsShownInItsLanguage) {
  const Lesson lesson = read_lesson(french(), "fr");
  EXPECT_EQ(lesson.language, "fr");
  EXPECT_EQ(lesson.title, "Essai");
  EXPECT_EQ(lesson.learn, "Quelque chose.");
  EXPECT_EQ(lesson.text, "Il faut {time} à {feed}.");
  EXPECT_EQ(lesson.questions[0].text, "Combien\u00a0?");
  EXPECT_EQ(lesson.questions[0].hint, "Voyez.");
  EXPECT_EQ(lesson.questions[0].answer, "{less} de moins.");
  EXPECT_THAT(lesson.untranslated, IsEmpty());
  EXPECT_EQ(read_lesson(french()).title, "Test");
}

TEST_F(LessonTranslation, NumbersFollowTheLanguage) {
  const Lesson lesson = read_lesson(french(), "fr");
  EXPECT_EQ(lesson.given.at("feed").written, "3000\u00a0mm/min");
  EXPECT_THAT(LessonRuns(lesson).numbers().at("time"), testing::ContainsRegex("^[0-9],[0-9][0-9]\u00a0s$"));
  EXPECT_EQ(value_text(lesson.numbers.at("time"), 1.2345, "fr"), "1,23\u00a0s");
  EXPECT_EQ(value_text(lesson.numbers.at("less"), 12.34, "fr"), "12\u00a0%");
  EXPECT_EQ(control_text(lesson.questions[0].control, "fr"), "tolerance\u00a0: 0,05\u00a0; 0,1");
  EXPECT_EQ(control_text({"program", {"a_2.5.nc"}, false}, "fr"), "program\u00a0: a_2.5.nc");
  EXPECT_EQ(control_text({"X.jerk", {"1.5", "2"}, true}, "fr"), "X.jerk\u00a0: de 1,5 à 2");
}

TEST_F(LessonTranslation, AnAngleStandsAtItsNumberInEveryLanguage) {
  EXPECT_EQ(number_with_unit("2.5", "°", "en"), "2.5°");
  EXPECT_EQ(number_with_unit("2.5", "°", "fr"), "2,5°");
  EXPECT_EQ(number_with_unit("2.5", "", "fr"), "2,5");
}

TEST_F(LessonTranslation, TypedSpacesDoNotBreakLines) {
  EXPECT_EQ(with_no_break_spaces("Oui : 12,5 % à 2 mm/min, 3 s ; « ça » va ?", "fr"),
            "Oui\u00a0: 12,5\u00a0% à 2\u00a0mm/min, 3\u00a0s\u00a0; «\u00a0ça\u00a0» va\u00a0?");
  EXPECT_EQ(with_no_break_spaces("Yes : 3 s", "en"), "Yes : 3 s");
  EXPECT_EQ(with_no_break_spaces("2 segments\n\n    v = √( J t )", "fr"), "2 segments\n\n    v = √( J t )");
}

TEST_F(LessonTranslation, ATextWithoutOneIsEnglish) {
  const Lesson lesson = read_lesson(french("hint = \"Voyez.\"\n"), "fr");
  EXPECT_EQ(lesson.language, "fr");
  EXPECT_EQ(lesson.questions[0].hint, "Look.");
  EXPECT_EQ(lesson.questions[0].answer, "{less} de moins.");
  EXPECT_THAT(lesson.untranslated, ElementsAre("'hint' of question 1"));
}

TEST_F(LessonTranslation, ALessonWithoutOneIsEnglishAndSoAreItsNumbers) {
  const Lesson lesson = read_lesson(write(good_lesson), "fr");
  EXPECT_EQ(lesson.language, "en");
  EXPECT_EQ(lesson.title, "Test");
  EXPECT_EQ(lesson.given.at("feed").written, "3000 mm/min");
  EXPECT_EQ(lesson.untranslated.size(), 6U);
  EXPECT_EQ(read_lesson(french(), "de").title, "Test") << "a language that lessons do not have";
}

TEST_F(LessonTranslation, NamesWhatIsWrong) {
  expect_error(french("learn", "lern"),
               ":9:", "unknown key 'lern' in 'fr' of the file; did you mean 'learn'?");
  expect_error(french("hint", "hnt"),
               ":40:", "unknown key 'hnt' in 'fr' of question 1; did you mean 'hint'?");
  expect_error(french("{time}", "{tim}"), ":10:", "did you mean {time}?");
  expect_error(french("{less}", "{les}"), ":41:", "did you mean {less}?");
  expect_error(french("[fr]", "[fe]"), ":7:",
               "unknown key 'fe' in the file; known: title, learn, minutes, course, replaces, sources, text, "
               "predict, transfer, start, window, numbers, given, question, fr");
  expect_error(french("[question.fr]", "[question.fe]"), ":38:", "unknown key 'fe' in question 1");
  expect_error(changed("[start]", "fr = \"x\"\n[start]"), ":7:", "fr");
  expect_error(french("\"Essai\"", "3"), ":8:", "'title' in 'fr' of the file");
}

TEST_F(LessonTranslation, TranslatesOnlyWhatIsThere) {
  std::ifstream in(french());
  std::string lesson{std::istreambuf_iterator<char>(in), {}};
  lesson.erase(lesson.find("hint = \"Look.\"\n"), std::string("hint = \"Look.\"\n").size());
  expect_error(write(lesson),
               ":39:", "'hint' in 'fr' of question 1: there is no English 'hint' to translate");
}

TEST_F(LessonTranslation, NumbersThatNothingChecksAreFoundInIt) {
  EXPECT_THAT(unchecked_numbers(read_lesson(french(), "fr")), IsEmpty());
  EXPECT_THAT(unchecked_numbers(read_lesson(french("Voyez.", "4,2 s, 0,05 mm, 7 s et § 5.3.2."), "fr")),
              ElementsAre("4,2 in the hint of question 1", "7 in the hint of question 1",
                          "5.3.2 in the hint of question 1"));
  EXPECT_THAT(unchecked_numbers(read_lesson(french("Voyez.", "À 0.05 mm."), "fr")),
              ElementsAre("0.05 in the hint of question 1"))
      << "the decimal sign is the comma";
}

TEST_F(LessonTranslation, TheHandOutHasItsHeadingsInTheLanguage) {
  const Lesson lesson = read_lesson(french(), "fr");
  LessonRuns runs(lesson);
  const std::string html = handout_html(lesson, handout_contents(lesson, runs, HandoutReader::everybody));
  EXPECT_THAT(html, AllOf(HasSubstr("<html lang=\"fr\">"), HasSubstr("<h1>Essai</h1>"),
                          HasSubstr("Environ 10 minutes."), HasSubstr(">Réponses</h1>"),
                          HasSubstr("temps limité par\u00a0: jerk d’un axe [s]"),
                          HasSubstr("Modèle de commande"), HasSubstr("raccords cubiques")));
  for (const char* english : {"Hint", "Answers", "Watch", "Move", "Setting", "Control model", "First set",
                              "Every number", "About"}) {
    EXPECT_THAT(html.substr(html.find("<body>")), testing::Not(HasSubstr(english)));
  }
}

TEST_F(LessonTranslation, TitlesOfMeasuresAreSentences) {
  const auto title = [](const char* measure, const char* cause, char axis, std::uint32_t first,
                        std::uint32_t last) {
    return title_of({&find_measure(measure), cause, axis, first, last}, "fr");
  };
  EXPECT_EQ(title("cycle_time_s", "", 0, 9, 10), "temps de cycle, lignes 9 à 10");
  EXPECT_EQ(title("peak_jerk_m_s3", "", 'X', 0, 0), "jerk maximal de l’axe X");
  EXPECT_EQ(title("peak_jerk_m_s3", "", 0, 0, 0), "jerk maximal d’un axe");
  EXPECT_EQ(title("share_by_cause_percent", "axis_jerk_y", 0, 0, 0),
            "part du temps de cycle limité par\u00a0: jerk de l’axe Y");
}

TEST_F(LessonTranslation, EveryMeasureCauseAndModelHasAName) {
  for (const MeasureSpec& measure : all_measures()) {
    EXPECT_NE(lesson_word(measure.title, "fr"), measure.title);
  }
  for (const ControlModel* model : all_models()) {
    const std::string title(model->info().title);
    EXPECT_NE(lesson_word(title, "fr"), title);
  }
  for (std::size_t i = 0; i < cause_kind_count; ++i) {
    const CauseInfo& info = info_of(static_cast<CauseKind>(i));
    for (const std::string& title : {std::string(info.title), std::string(info.axis_title)}) {
      EXPECT_TRUE(title.empty() || lesson_word(title, "fr") != title) << title;
    }
  }
}

}  // namespace
}  // namespace feedscope
