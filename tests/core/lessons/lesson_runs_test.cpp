#include "core/lessons/lesson_runs.h"

#include <cmath>

#include "core/base/error.h"
#include "tests/core/lessons/lesson_folder.h"

namespace feedscope {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

class LessonRunsTest : public test::LessonFolder {
 protected:
  Lesson lesson_on(const std::string& program, const std::string& machine, const std::string& model) const {
    write(program, "mine.nc");
    std::string text = good_lesson;
    const std::size_t from = text.find("program =");
    text.replace(from, text.find("set =") - from,
                 "program = \"mine.nc\"\nmachine = \"" + machine + "\"\nmodel = \"" + model + "\"\n");
    const std::string with = "with = [\"lookahead_blocks=4\"]\n";
    return read_lesson(write(text.erase(text.find(with), with.size())));
  }

  static Measure of(const std::string& key, std::uint32_t line = 0) {
    Measure measure;
    measure.spec = &find_measure(key);
    measure.first_line = measure.last_line = line;
    return measure;
  }
};

/// 60 mm at 50 mm/s with J 15 m/s3 and A never reached: 60/50 + 2 sqrt(0.05/15) s; the peak acceleration is
/// sqrt(J F). Then 30 mm along Y after the exact stop that a tolerance of 0 makes.
TEST_F(LessonRunsTest, MeasuresAreThoseOfClosedForms) {
  const Lesson lesson = lesson_on("G1 X60 F3000\nY30\nG4 P0.5\n", "spinner-mvc850", "essid");
  LessonRuns runs(lesson);
  const feedscope::Run& run = runs.run({"tolerance=0"});
  const double ramps = 2 * std::sqrt(0.05 / 15);
  const auto value = [&](const Measure& measure) { return measured(measure, run); };

  EXPECT_NEAR(value(of("cycle_time_s")), 1.8 + 2 * ramps + 0.5, 1e-9);
  EXPECT_NEAR(value(of("cycle_time_s", 1)), 1.2 + ramps, 1e-9);
  EXPECT_NEAR(value(of("cycle_time_ms", 1)), 1200 + 1000 * ramps, 1e-6);
  EXPECT_NEAR(value(of("programmed_time_s")), 2.3, 1e-12);
  EXPECT_NEAR(value(of("against_cam")), (2.3 + 2 * ramps) / 2.3, 1e-9);
  EXPECT_NEAR(value(of("mean_feed_mm_min", 1)), 60 * 60 / (1.2 + ramps), 1e-6);
  EXPECT_NEAR(value(of("mean_feed_m_min", 1)), 0.06 * 60 / (1.2 + ramps), 1e-9);
  EXPECT_NEAR(value(of("peak_feed_mm_min")), 3000, 1e-6);
  EXPECT_NEAR(value(of("peak_feed_m_min", 2)), 3, 1e-9);
  EXPECT_NEAR(value(of("least_feed_mm_min", 1)), 0, 1e-6);
  EXPECT_NEAR(value(of("corner_feed_mm_min", 1)), 0, 0.1);
  EXPECT_NEAR(value(of("max_contour_error_um")), 0, 1e-9);
  EXPECT_NEAR(value(of("path_length_mm")), 90, 1e-9);
  EXPECT_NEAR(value(of("path_length_mm", 2)), 30, 1e-9);
  EXPECT_EQ(value(of("blends")), 0);
  EXPECT_NEAR(value(of("peak_velocity_m_min")), 3, 1e-9);
  EXPECT_NEAR(value(of("peak_acceleration_m_s2")), std::sqrt(15 * 0.05), 1e-9);
  EXPECT_NEAR(value(of("peak_jerk_m_s3")), 15, 1e-9);
  Measure along_z = of("peak_jerk_m_s3");
  along_z.axis = 'Z';
  EXPECT_EQ(value(along_z), 0);
  Measure waiting = of("share_by_cause_percent");
  waiting.cause = "dwell";
  EXPECT_NEAR(value(waiting), 100 * 0.5 / (2.3 + 2 * ramps), 1e-9);
  Measure jerk = of("time_by_cause_s");
  jerk.cause = "axis_jerk";
  Measure jerk_x = jerk;
  jerk_x.cause = "axis_jerk_x";
  EXPECT_NEAR(value(jerk), 2 * value(jerk_x), 1e-9);
  EXPECT_GT(value(jerk), 0);
}

/// They are at least what any instant on the lines has, and hardly more: between looks 10 us apart a value
/// rises by little.
TEST_F(LessonRunsTest, PeaksAreFoundBetweenLooks) {
  struct Peak {
    const char* key;
    double (*of)(const State&);
  };
  const std::array peaks{
      Peak{"peak_feed_mm_min", [](const State& s) { return s.velocity.norm() * 60; }},
      Peak{"peak_tangential_acceleration_m_s2",
           [](const State& s) { return std::abs(s.tangential_acceleration) / 1000; }},
      Peak{"peak_acceleration_across_m_s2",
           [](const State& s) {
             return s.velocity.cross(s.acceleration).norm() / std::max(s.velocity.norm(), 1e-9) / 1000;
           }},
  };
  for (const char* model : {"essid", "tapie", "ward"}) {
    const Lesson lesson =
        lesson_on("G1 X7 F6000\nX9 Y4\nG3 X9 Y10 I0 J3\nG1 X1 Y12\nX0 Y0.5\n", "spinner-mvc850", model);
    LessonRuns runs(lesson);
    const feedscope::Run& run = runs.run({});
    for (const Peak& peak : peaks) {
      double seen = 0;
      constexpr double step = 1e-5;  // [s]
      for (double time = 0; time < run.trajectory->duration(); time += step) {
        const State state = run.trajectory->state(time);
        if (state.line >= 2 && state.line <= 4) {
          seen = std::max(seen, peak.of(state));
        }
      }
      Measure measure = of(peak.key, 2);
      measure.last_line = 4;
      const double found = measured(measure, run);
      EXPECT_GE(found, seen * (1 - 1e-9)) << model << " " << peak.key;
      EXPECT_LE(found, seen * 1.002) << model << " " << peak.key;
    }
  }
}

/// Tapie 2007: from a line into an arc of 20 mm at sqrt(J t R); the speed at the end of the line is also that
/// at the end of the full circle behind it.
TEST_F(LessonRunsTest, CornerFeedIsThatAtTheEndOfTheLine) {
  const Lesson lesson = lesson_on("G1 X50 F6000\nG3 X50 Y0 I0 J20\nG1 X100\n", "mikron-ucp710", "tapie");
  LessonRuns runs(lesson);
  const double crossing = std::sqrt(5000 * 0.012 * 20) * 60;
  EXPECT_NEAR(measured(of("corner_feed_mm_min", 1), runs.run({})), crossing, 1e-3 * crossing);
  EXPECT_NEAR(measured(of("corner_feed_mm_min", 2), runs.run({})), crossing, 1e-3 * crossing);
  EXPECT_NEAR(measured(of("corner_feed_mm_min", 3), runs.run({})), 0, 0.1);
}

TEST_F(LessonRunsTest, LinesWithoutMotionAreNamed) {
  const Lesson lesson = lesson_on("G1 X50 F6000\n(nothing)\n", "mikron-ucp710", "tapie");
  LessonRuns runs(lesson);
  for (const char* key : {"cycle_time_s", "peak_feed_mm_min", "least_feed_mm_min", "corner_feed_mm_min"}) {
    EXPECT_THAT([&] { measured(of(key, 2), runs.run({})); },
                ThrowsMessage<InputError>(HasSubstr("nothing moves on line 2 of the program")));
  }
}

TEST_F(LessonRunsTest, AProgramWithErrorsIsRefused) {
  const Lesson lesson = lesson_on("G1 X50 F6000\nfoo\n", "mikron-ucp710", "tapie");
  LessonRuns runs(lesson);
  EXPECT_THAT([&] { runs.run({}); }, ThrowsMessage<InputError>(HasSubstr("has an error on line 2")));
}

TEST_F(LessonRunsTest, QuantitiesArePutAgainstEachOther) {
  const Lesson lesson = lesson_on("G1 X60 F3000\n", "spinner-mvc850", "cam");
  LessonRuns runs(lesson);
  LessonQuantity quantity;
  quantity.measure = of("cycle_time_s");
  quantity.with = {"model=essid"};
  quantity.against = Changes{};
  const double slow = 1.2 + 2 * std::sqrt(0.05 / 15);
  EXPECT_NEAR(runs.value(quantity), slow / 1.2, 1e-9);
  quantity.relation = Relation::difference;
  EXPECT_NEAR(runs.value(quantity), slow - 1.2, 1e-9);
  quantity.relation = Relation::percent_more;
  EXPECT_NEAR(runs.value(quantity), 100 * (slow / 1.2 - 1), 1e-9);
  quantity.relation = Relation::percent_less;
  EXPECT_NEAR(runs.value(quantity), 100 * (1 - slow / 1.2), 1e-9);
  quantity.measure = of("blends");
  EXPECT_THAT([&] { runs.value(quantity); }, ThrowsMessage<InputError>(HasSubstr("so there is no ratio")));
}

/// The first two corners are blended, the third is an exact stop.
TEST_F(LessonRunsTest, TheContourErrorOfLinesIsThatOfTheirPartOfThePath) {
  const Lesson lesson = lesson_on("G1 X20 F3000\nY20\nG9 X0\nY40\n", "spinner-mvc850", "essid");
  LessonRuns runs(lesson);
  const auto error = [&](std::uint32_t first, std::uint32_t last) {
    Measure measure = of("max_contour_error_um");
    measure.first_line = first;
    measure.last_line = last;
    return measured(measure, runs.run({}));
  };
  EXPECT_GT(error(0, 0), 1);
  EXPECT_NEAR(error(1, 3), error(0, 0), 1e-3);
  EXPECT_NEAR(error(1, 2), error(0, 0), 1e-3);
  EXPECT_NEAR(error(4, 4), 0, 1e-3);
  EXPECT_THROW(error(9, 9), InputError);
}

TEST_F(LessonRunsTest, ClaimsHoldOrDoNot) {
  const Lesson lesson = lesson_on("G1 X60 F3000\n", "spinner-mvc850", "cam");
  LessonRuns runs(lesson);
  const auto holds = [&](Claim::Kind kind, std::variant<double, Changes> bound, double upper, double within,
                         bool percent) {
    Claim claim;
    claim.quantity.measure = of("cycle_time_s");
    claim.kind = kind;
    claim.bound = std::move(bound);
    claim.upper = upper;
    claim.within = within;
    claim.within_percent = percent;
    return runs.check(claim).holds;
  };
  using enum Claim::Kind;
  EXPECT_TRUE(holds(less_than, 1.3, 0, 0, false));
  EXPECT_FALSE(holds(less_than, 1.1, 0, 0, false));
  EXPECT_TRUE(holds(less_than, Changes{"model=essid"}, 0, 0, false));
  EXPECT_FALSE(holds(more_than, Changes{"model=essid"}, 0, 0, false));
  EXPECT_TRUE(holds(more_than, 1.1, 0, 0, false));
  EXPECT_TRUE(holds(about, 1.25, 0, 0.06, false));
  EXPECT_FALSE(holds(about, 1.25, 0, 0.04, false));
  EXPECT_TRUE(holds(about, 1.25, 0, 5, true));
  EXPECT_FALSE(holds(about, 1.25, 0, 3, true));
  EXPECT_TRUE(holds(between, 1.1, 1.3, 0, false));
  EXPECT_FALSE(holds(between, 1.21, 1.3, 0, false));
  EXPECT_FALSE(holds(between, 1.0, 1.1, 0, false));
}

}  // namespace
}  // namespace feedscope
