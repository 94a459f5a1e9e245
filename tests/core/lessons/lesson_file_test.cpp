#include "core/base/error.h"
#include "tests/core/lessons/lesson_folder.h"

namespace feedscope {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;
using testing::ThrowsMessage;

class LessonFile : public test::LessonFolder {
 protected:
  /// Reading `file` must fail at the place (":LINE:") with `message`.
  static void expect_error(const std::filesystem::path& file, const std::string& place,
                           const std::string& message) {
    EXPECT_THAT([&] { read_lesson(file); },
                ThrowsMessage<InputError>(AllOf(StartsWith(file.string() + place), HasSubstr(message))));
  }
};

TEST_F(LessonFile, IsReadWhole) {
  const Lesson lesson = read_lesson(write(good_lesson, "03_corner.toml"));
  EXPECT_EQ(lesson.id, "03_corner");
  EXPECT_EQ(lesson.title, "Test");
  EXPECT_EQ(lesson.learn, "Something.");
  EXPECT_EQ(lesson.minutes, 10);
  EXPECT_THAT(lesson.sources, ElementsAre("Nobody 2020"));
  EXPECT_THAT(lesson.start, ElementsAre("program=lesson_right_angle.nc", "machine=spinner-mvc850",
                                        "model=essid", "tolerance=0.1"));
  EXPECT_EQ(lesson.window.colouring, "cause");
  EXPECT_EQ(lesson.window.camera, "iso");
  EXPECT_EQ(lesson.window.chart_range, (std::pair{0.0, 0.5}));
  EXPECT_THAT(lesson.window.runs, ElementsAre(Changes{"tolerance=0.2"}, Changes{"model=cam"}));
  EXPECT_EQ(lesson.numbers.at("time").decimals, 2);
  EXPECT_EQ(lesson.numbers.at("less").relation, Relation::percent_less);
  EXPECT_EQ(lesson.given.at("feed").written, "3000 mm/min");
  ASSERT_EQ(lesson.questions.size(), 1u);
  const Question& question = lesson.questions.front();
  EXPECT_THAT(question.with, ElementsAre("lookahead_blocks=4"));
  EXPECT_EQ(question.control.key, "tolerance");
  EXPECT_THAT(question.control.values, ElementsAre("0.05", "0.1"));
  EXPECT_EQ(question.watch.cause, "axis_jerk");
  ASSERT_EQ(question.claims.size(), 3u);
  EXPECT_EQ(question.claims[0].kind, Claim::Kind::less_than);
  EXPECT_EQ(std::get<Changes>(question.claims[0].bound), Changes{"tolerance=0.1"});
  EXPECT_EQ(question.claims[1].kind, Claim::Kind::about);
  EXPECT_EQ(std::get<double>(question.claims[1].bound), 3000);
  EXPECT_TRUE(question.claims[1].within_percent);
  EXPECT_EQ(question.claims[2].upper, 1);
}

TEST_F(LessonFile, ATextIsReadAsTheFileThatHoldsIt) {
  const Lesson lesson = parse_lesson(good_lesson, folder_ / "03_corner.toml");
  EXPECT_EQ(lesson.file, folder_ / "03_corner.toml");
  EXPECT_EQ(lesson.id, "03_corner");
  EXPECT_EQ(lesson.start, read_lesson(write(good_lesson)).start);
  EXPECT_THAT([] { parse_lesson("titel = 1", "a.toml"); },
              ThrowsMessage<InputError>(StartsWith("a.toml:1:1: unknown key 'titel'")));
}

TEST_F(LessonFile, NamesAMisspeltKey) {
  expect_error(changed("title =", "titel ="),
               ":1:", "unknown key 'titel' in the file; did you mean 'title'?");
  expect_error(changed("machine =", "machin ="),
               ":9:", "unknown key 'machin' in [start]; did you mean 'machine'?");
  expect_error(changed("colour =", "color ="), ":14:", "did you mean 'colour'?");
  expect_error(changed("decimals", "decimal"), ":20:", "unknown key 'decimal' in 'time' in [numbers]");
  expect_error(changed("unit =", "units ="), ":24:", "unknown key 'units' in 'feed' in [given]");
  expect_error(changed("hint", "hnt"), ":31:", "unknown key 'hnt' in question 1; did you mean 'hint'?");
  expect_error(changed("values =", "value ="), ":29:", "unknown key 'value' in 'control' of question 1");
  expect_error(changed("less_than", "les_than"), ":36:", "unknown key 'les_than' in claim 1 of question 1");
}

TEST_F(LessonFile, NamesAMissingKey) {
  expect_error(changed("learn = \"Something.\"", ""), ":1:", "key 'learn' is missing in the file");
  expect_error(changed("machine = \"spinner-mvc850\"", ""), ":7:", "key 'machine' is missing in [start]");
  expect_error(changed("answer = \"{less} less.\"", ""), ":26:", "key 'answer' is missing in question 1");
  expect_error(changed("measure = \"time_by_cause_s\", ", ""),
               ":30:", "key 'measure' is missing in 'watch' of question 1");
  expect_error(changed(", cause = \"axis_jerk\"", ""),
               ":30:", "key 'cause' is missing in 'watch' of question 1");
  expect_error(changed("line = 4\nbetween", "between"),
               ":42:", "key 'line' is missing in claim 3 of question 1");
  expect_error(
      changed("less_than = [\"tolerance=0.1\"]\n", ""),
      ":33:", "claim 1 of question 1 claims nothing: one of less_than, more_than, about, between is missing");
  expect_error(changed("within_percent = 1\n", ""),
               ":37:", "'about' in claim 2 of question 1 needs one of within");
  expect_error(changed(", source = \"the program\"", ""),
               ":24:", "key 'source' is missing in 'feed' in [given]");
  expect_error(changed("values = [0.05, 0.1]", ""), ":29:", "not valid TOML");
  expect_error(changed(", values = [0.05, 0.1]", ""),
               ":29:", "'control' of question 1 needs one of values = [...] and range = [from, to]");
}

TEST_F(LessonFile, NamesProgramMachineModelAndSettingThatAreNotThere) {
  expect_error(
      changed("lesson_right_angle.nc", "lesson_right_angel.nc"), ":8:",
      "program 'lesson_right_angel.nc' is neither next to the lesson nor in resources/programs; did you mean "
      "'lesson_right_angle.nc'?");
  expect_error(changed("spinner-mvc850", "spiner-mvc850"), ":9:", "did you mean 'spinner-mvc850'?");
  expect_error(changed("\"essid\"", "\"esid\""), ":10:", "did you mean 'essid'?");
  expect_error(changed("lookahead_blocks=4", "lookahead_block=4"), ":28:", "lookahead_block");
  expect_error(changed("lookahead_blocks=4", "lookahead_blocks=0"),
               ":28:", "lookahead_blocks = 0 is out of bounds");
  expect_error(changed("lookahead_blocks=4", "lookahead_blocks"), ":28:", "has no value; write KEY=VALUE");
  expect_error(changed("[0.05, 0.1]", "[0.05, -0.1]"),
               ":29:", "contour_tolerance_mm = -0.1 is out of bounds");
  expect_error(changed("key = \"tolerance\"", "key = \"tolerence\""), ":29:", "tolerence");
  expect_error(changed("[\"model=cam\"], against", "[\"model=can\"], against"),
               ":21:", "did you mean 'cam'?");
  expect_error(changed("less_than = [\"tolerance=0.1\"]", "less_than = [\"tolerance=x\"]"), ":36:", "x");
}

TEST_F(LessonFile, NamesMeasureCauseAndNumberThatAreNotThere) {
  expect_error(changed("\"cycle_time_s\", decimals", "\"cycle_time\", decimals"),
               ":20:", "unknown measure 'cycle_time'; did you mean 'cycle_time_s'?");
  expect_error(changed("\"axis_jerk\"", "\"axis_jork\""),
               ":30:", "unknown cause 'axis_jork'; did you mean 'axis_jerk'?");
  expect_error(changed("{time}", "{tim}"), ":5:",
               "the text speaks of {tim}, which is in neither [numbers] nor [given]; did you mean {time}?");
  expect_error(changed("{less}", "{more}"), ":32:", "the text speaks of {more}");
  expect_error(changed("{time}", "{time"), ":5:", "the text speaks of {time at {feed}");
  expect_error(changed("at {feed}", "at {feed"), ":5:", "'{' is not closed by '}'");
  expect_error(changed("about = \"feed\"", "about = \"fed\""),
               ":40:", "which is not in [given]; did you mean 'feed'?");
  expect_error(changed("\"iso\"", "\"isometric\""), ":15:", "'view' in [window] is 'isometric'");
  expect_error(changed("\"cause\"\n", "\"causes\"\n"), ":14:", "did you mean 'cause'?");
  expect_error(changed("\"percent less\"", "\"percent fewer\""), ":21:", "'as' in 'less' in [numbers]");
}

TEST_F(LessonFile, NamesWrongValues) {
  expect_error(changed("minutes = 10", "minutes = 0"),
               ":3:", "'minutes' in the file is 0; it must be a whole number, at least 1");
  expect_error(changed("minutes = 10", "minutes = \"ten\""), ":3:", "must be a number");
  expect_error(changed("minutes = 10", "minutes = nan"), ":3:", "must be a number");
  expect_error(changed("decimals = 2", "decimals = 7"), ":20:", "at most 6");
  expect_error(changed("[0.0, 0.5]", "[0.5, 0.5]"), ":16:", "the first must be less than the second");
  expect_error(changed("[0.0, 0.5]", "[0.5]"), ":16:", "must be two numbers: [from, to]");
  expect_error(changed("[[\"tolerance=0.2\"], [\"model=cam\"]]", "[\"tolerance=0.2\"]"),
               ":17:", "must be a list of texts");
  expect_error(changed("[[\"tolerance=0.2\"], [\"model=cam\"]]", "3"), ":17:", "must be a list of lists");
  expect_error(changed("[\"Nobody 2020\"]", "[]"), ":4:", "'sources' in the file must be a list of texts");
  expect_error(changed("[\"Nobody 2020\"]", "[3]"), ":4:", "must hold texts in quotes");
  expect_error(changed("line = 4\nabout", "line = 0\nabout"),
               ":39:", "it must be a whole number, at least 1");
  expect_error(changed("within_percent = 1", "within_percent = -1"), ":41:", "it must be at least 0");
  expect_error(changed("value = 3000", "value = inf"), ":24:", "must be a number");
  expect_error(changed("values = [0.05, 0.1]", "range = [0.1, 0.05]"), ":29:", "the first must be less");
  expect_error(changed("values = [0.05, 0.1]", "values = []"), ":29:", "must be a list");
}

TEST_F(LessonFile, NamesWhatDoesNotFitTogether) {
  expect_error(changed("cause = \"axis_jerk\" }", "cause = \"axis_jerk\", axis = \"X\" }"),
               ":30:", "'axis' in 'watch' of question 1: the measure time_by_cause_s knows none");
  expect_error(changed("line = 4\nabout", "cause = \"dwell\"\nabout"),
               ":39:", "the measure peak_feed_mm_min knows none");
  expect_error(changed("cause = \"axis_jerk\" }", "cause = \"axis_jerk\", line = 3 }"),
               ":30:", "'line' in 'watch' of question 1: the measure time_by_cause_s knows none");
  expect_error(changed("line = 4\nabout", "line = 4\nlines = [4, 5]\nabout"), ":40:", "give one of them");
  expect_error(changed("between = [0.1, 1]", "between = [0.1, 1]\nless_than = 3"),
               ":45:", "claim 3 of question 1 has two of");
  expect_error(changed("between = [0.1, 1]", "between = [0.1, 1]\nwithin = 3"), ":46:", "belongs to 'about'");
  expect_error(changed("against = [], as", "as"), ":21:", "'against' is missing");
  expect_error(changed("feed = {", "time = {"), ":24:", "'time' in [given] is in [numbers] too");
}

TEST_F(LessonFile, TellsWhatIsNoLesson) {
  EXPECT_THAT([&] { read_lesson(folder_); },
              ThrowsMessage<InputError>(HasSubstr("is a folder; give a lesson")));
  EXPECT_THAT([&] { read_lesson(folder_ / "none.toml"); },
              ThrowsMessage<InputError>(HasSubstr("cannot read lesson")));
  expect_error(changed("minutes = 10", "minutes = "), ":3:", "not valid TOML");
  expect_error(changed("[[question]]", "[question]"), ":", "");
  EXPECT_THAT([] { find_lesson("tolerence_and_time"); },
              ThrowsMessage<InputError>(HasSubstr("did you mean '01_lost_time'?")))
      << "the lesson that replaces it";
}

/// Cut off anywhere, or with one character too many, a lesson is read or refused with its place.
TEST_F(LessonFile, BrokenFilesAreRefusedCleanly) {
  const std::string good = good_lesson;
  const auto try_to_read = [&](const std::string& text) {
    const auto file = write(text);
    try {
      read_lesson(file);
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), StartsWith(file.string() + ":"));
    }
  };
  for (std::size_t end = 0; end < good.size(); end += 13) {
    try_to_read(good.substr(0, end));
    for (const char* noise : {"\"", "[", "{", "=", "\xff"}) {
      try_to_read(good.substr(0, end) + noise + good.substr(end));
    }
  }
}

TEST_F(LessonFile, HasAPlaceInACourseAndTextsToBeWrittenInto) {
  const Lesson plain = read_lesson(write(good_lesson));
  EXPECT_FALSE(plain.half_day);
  EXPECT_EQ(plain.predict + plain.transfer, "");
  const std::string more =
      "minutes = 10\ncourse = \"half day\"\nreplaces = [\"01_old\"]\npredict = \"Longer than {time}?\"\n"
      "transfer = \"On mine …\"";
  const Lesson lesson = read_lesson(changed("minutes = 10", more));
  EXPECT_TRUE(lesson.half_day);
  EXPECT_THAT(lesson.replaces, ElementsAre("01_old"));
  EXPECT_EQ(lesson.predict, "Longer than {time}?");
  EXPECT_EQ(lesson.transfer, "On mine …");
  expect_error(changed("minutes = 10", "minutes = 10\ncourse = \"half a day\""),
               ":4:", "did you mean 'half day'?");
  expect_error(changed("minutes = 10", "minutes = 10\npredict = \"{tim}\""), ":4:", "did you mean {time}?");
}

/// A load file names tools and lines of the program that the lesson begins with.
TEST(LessonSetup, AnotherProgramHasNoLoad) {
  const Lesson lesson = read_lesson(find_lesson("9"));
  EXPECT_FALSE(set_up(lesson, {"tolerance=0.05"}).setup.load.operations.empty());
  EXPECT_TRUE(set_up(lesson, {"program=lesson_slot.nc"}).setup.load.operations.empty());
}

TEST_F(LessonFile, AProgramBesideTheLessonComesFirst) {
  write("G1 X5 F1000\n", "mine.nc");
  const Lesson lesson = read_lesson(changed("lesson_right_angle.nc", "mine.nc"));
  EXPECT_EQ(set_up(lesson, {}).program, folder_ / "mine.nc");
}

TEST_F(LessonFile, ChangesAreMadeOnTopOfTheStart) {
  const Lesson lesson = read_lesson(write(good_lesson));
  EXPECT_EQ(set_up(lesson, {}).setup.settings.number("contour_tolerance_mm"), 0.1);
  EXPECT_EQ(set_up(lesson, {}).setup.settings.text("program_tolerance"), "off");
  EXPECT_EQ(set_up(lesson, {"tolerance=0.2"}).setup.settings.number("contour_tolerance_mm"), 0.2);
  EXPECT_EQ(set_up(lesson, {"X.jerk=30"}).setup.machine.axes[0].jerk, 30000);
  // cam knows no tolerance: what the lesson begins with is left out for it, silently.
  EXPECT_EQ(set_up(lesson, {"model=cam"}).setup.model->info().id, "cam");
  EXPECT_THROW(set_up(lesson, {"model=cam", "alpha=2"}), InputError);
}

TEST(LessonLibrary, FindsLessonsByIdNumberAndName) {
  const auto file = find_lesson("08_small_circle");
  EXPECT_EQ(find_lesson("8"), file);
  EXPECT_EQ(find_lesson("08"), file);
  EXPECT_EQ(find_lesson("small_circle"), file);
  EXPECT_EQ(find_lesson(file.string()), file);
  EXPECT_THROW(find_lesson("99"), InputError);
  EXPECT_THROW(find_lesson(""), InputError);
}

TEST(LessonLibrary, EarlierLessonsAreAnsweredByThoseThatReplaceThem) {
  EXPECT_EQ(find_lesson("04_small_circle"), find_lesson("8"));
  EXPECT_EQ(find_lesson("05_approach_arcs"), find_lesson("8"));
  for (const char* name : {"15_compressor", "compressor", "15"}) {
    EXPECT_EQ(find_lesson(name).stem(), "04_two_tolerances") << name;
  }
  for (int number = 1; number <= 18; ++number) {
    EXPECT_NO_THROW(find_lesson(std::to_string(number))) << number;
  }
}

}  // namespace
}  // namespace feedscope
