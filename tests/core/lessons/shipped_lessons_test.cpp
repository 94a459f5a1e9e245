#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>

#include <regex>
#include <set>

#include "core/lessons/handout.h"
#include "core/lessons/lesson_language.h"
#include "core/lessons/lesson_runs.h"
#include "tests/core/lessons/lesson_folder.h"
#include "tests/support/folders.h"

namespace feedscope {
namespace {

class ShippedLesson : public testing::TestWithParam<std::string> {
 protected:
  const Lesson lesson_ = read_lesson(find_lesson(GetParam()));
};

std::vector<std::string> shipped_ids() {
  std::vector<std::string> ids;
  for (const auto& file : shipped_lessons()) {
    ids.push_back(file.stem().string());
  }
  return ids;
}

/// Every claim of the lesson, simulated.
void expect_claims(const Lesson& lesson) {
  LessonRuns runs(lesson);
  for (const Question& question : lesson.questions) {
    for (const Claim& claim : question.claims) {
      const ClaimResult result = runs.check(claim);
      EXPECT_TRUE(result.holds) << claim.place << ": " << quantity_text(claim.quantity) << " is "
                                << result.value << ", expected " << expectation_text(claim);
    }
  }
}

TEST_P(ShippedLesson, EveryClaimHolds) {
  expect_claims(lesson_);
}

/// {names} in a text, sorted.
std::multiset<std::string> names_in(const std::string& text) {
  static const std::regex name(R"(\{\w+\})");
  return {std::sregex_token_iterator(text.begin(), text.end(), name), std::sregex_token_iterator()};
}

TEST_P(ShippedLesson, IsTranslatedWithTheSameNumbers) {
  for (const std::string& language : lesson_languages()) {
    const Lesson other = read_lesson(lesson_.file, language);
    EXPECT_EQ(other.language, language);
    EXPECT_THAT(other.untranslated, testing::IsEmpty()) << language;
    EXPECT_THAT(unchecked_numbers(other), testing::IsEmpty()) << language;
    EXPECT_EQ(names_in(other.text), names_in(lesson_.text));
    EXPECT_EQ(names_in(other.predict), names_in(lesson_.predict));
    for (std::size_t i = 0; i < lesson_.questions.size(); ++i) {
      EXPECT_EQ(names_in(other.questions[i].text), names_in(lesson_.questions[i].text));
      EXPECT_EQ(names_in(other.questions[i].hint), names_in(lesson_.questions[i].hint));
      EXPECT_EQ(names_in(other.questions[i].answer), names_in(lesson_.questions[i].answer));
    }
  }
}

TEST_P(ShippedLesson, EveryNumberThatIsNamedIsUsed) {
  std::string texts = lesson_.text + lesson_.learn + lesson_.predict;
  std::set<double> bounds;
  for (const Question& question : lesson_.questions) {
    texts += question.text + question.hint + question.answer;
    for (const Claim& claim : question.claims) {
      if (const double* bound = std::get_if<double>(&claim.bound)) {
        bounds.insert(*bound);
      }
    }
  }
  for (const auto& [name, number] : lesson_.numbers) {
    EXPECT_THAT(texts, testing::HasSubstr("{" + name + "}"));
  }
  for (const auto& [name, given] : lesson_.given) {
    EXPECT_TRUE(texts.find("{" + name + "}") != std::string::npos || bounds.contains(given.value) ||
                texts.find(fmt::format("{}", given.value)) != std::string::npos)
        << name;
  }
}

TEST_P(ShippedLesson, EveryControlCanBeMovedAndWhatToWatchMeasured) {
  LessonRuns runs(lesson_);
  for (const Question& question : lesson_.questions) {
    for (const std::string& value : question.control.values) {
      Changes changes = question.with;
      changes.push_back(question.control.key + "=" + value);
      const double watched = measured(question.watch, runs.run(changes));
      EXPECT_TRUE(std::isfinite(watched)) << question.control.key << "=" << value;
    }
  }
  for (const Changes& run : lesson_.window.runs) {
    EXPECT_GT(runs.run(run).summary.cycle_time, 0);
  }
}

TEST_P(ShippedLesson, PrintsWithAllItsNumbers) {
  for (const std::string& language : lesson_languages()) {
    const Lesson lesson = read_lesson(lesson_.file, language);
    LessonRuns runs(lesson);
    const std::string html = handout_html(lesson, handout_contents(lesson, runs, HandoutReader::everybody));
    EXPECT_THAT(names_in(html.substr(html.find("<body>"))), testing::IsEmpty());
    EXPECT_THAT(html, testing::HasSubstr(lesson.title));
  }
}

/// A source in the project is a file of it.
TEST_P(ShippedLesson, ItsSourcesAreThere) {
  std::string sources = fmt::format("{}", fmt::join(lesson_.sources, " "));
  for (const auto& [name, given] : lesson_.given) {
    sources += " " + given.source;
  }
  static const std::regex file(R"((core|resources|machines)/[\w/.-]*\w)");
  for (auto found = std::sregex_iterator(sources.begin(), sources.end(), file);
       found != std::sregex_iterator(); ++found) {
    EXPECT_TRUE(std::filesystem::exists(std::filesystem::path(FEEDSCOPE_SOURCE_DIR) / found->str()))
        << found->str();
  }
  EXPECT_THAT(sources, testing::Not(testing::HasSubstr("core/models/README.md")))
      << "derivations are in the folders of the models";
}

INSTANTIATE_TEST_SUITE_P(Lessons, ShippedLesson, testing::ValuesIn(shipped_ids()),
                         [](const auto& lesson) { return lesson.param; });

/// A prediction, room for one's own control, and questions that two pages have room for.
TEST_P(ShippedLesson, IsALessonOfTheCourse) {
  EXPECT_EQ(lesson_.minutes, 20);
  EXPECT_NE(lesson_.predict, "");
  EXPECT_THAT(lesson_.transfer, testing::HasSubstr("…"));
  EXPECT_EQ(lesson_.questions.size(), 2U);
}

TEST(ShippedLessons, AreTwelveNumberedWithoutGapsAndSevenMakeHalfADay) {
  const std::vector<std::string> ids = shipped_ids();
  EXPECT_EQ(ids.size(), 12U);
  std::vector<std::size_t> half_day;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    EXPECT_THAT(ids[i], testing::StartsWith(fmt::format("{:02}_", i + 1)));
    if (read_lesson(find_lesson(ids[i])).half_day) {
      half_day.push_back(i + 1);
    }
  }
  EXPECT_THAT(half_day, testing::ElementsAre(1, 2, 3, 4, 5, 8, 12));
}

class Readme : public test::LessonFolder {};

TEST_F(Readme, ItsExampleIsALessonWhoseClaimsHold) {
  std::ifstream in(std::filesystem::path(FEEDSCOPE_SOURCE_DIR) / "resources/lessons/README.md");
  const std::string readme{std::istreambuf_iterator<char>(in), {}};
  const std::string fence = "```toml\n";
  const std::size_t begin = readme.find(fence) + fence.size();
  const Lesson lesson = read_lesson(write(readme.substr(begin, readme.find("```", begin) - begin)));
  expect_claims(lesson);
  EXPECT_THAT(unchecked_numbers(lesson), testing::IsEmpty());
  EXPECT_EQ(LessonRuns(lesson).numbers().at("time"), "1.241 s");
}

TEST_F(Readme, NamesEveryMeasureAndColouring) {
  std::ifstream in(std::filesystem::path(FEEDSCOPE_SOURCE_DIR) / "resources/lessons/README.md");
  const std::string readme{std::istreambuf_iterator<char>(in), {}};
  for (const MeasureSpec& measure : all_measures()) {
    EXPECT_THAT(readme, testing::HasSubstr("`" + measure.key + "`"));
  }
  for (const std::string& name : lesson_colourings()) {
    EXPECT_THAT(readme, testing::HasSubstr("`" + name + "`"));
  }
  for (const std::string& name : lesson_cameras()) {
    EXPECT_THAT(readme, testing::HasSubstr("`" + name + "`"));
  }
}

}  // namespace
}  // namespace feedscope
