#include "core/analysis/time/slow_places.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <random>

#include "core/analysis/explanation/explanation.h"
#include "core/analysis/time/ruled_instant.h"
#include "core/models/control_model.h"
#include "tests/core/analysis/hand_made_run.h"
#include "tests/support/folders.h"
#include "tests/support/paths.h"

namespace feedscope {
namespace {

using testing::line_to;
using testing::Passage;

const Vec3 axis_speed(500, 250, 100);
const Cause radial{CauseKind::radial_acceleration, -1};
const Cause jerk{CauseKind::axis_jerk, 0};

/// A stretch at constant speed [mm/s] for some time [s].
struct Steady {
  double speed;
  double duration;
  Cause cause = {};
};

/// A line of the program for each stretch, numbered from 1, all of the same programmed feed [mm/s].
Trajectory steady_run(const std::vector<Steady>& stretches, double feed = 50) {
  Toolpath toolpath;
  std::vector<Passage> passages;
  double x = 0;
  for (const Steady& stretch : stretches) {
    const double length = stretch.speed * stretch.duration;
    x += length;
    const auto i = static_cast<std::uint32_t>(toolpath.segments.size());
    toolpath.segments.push_back(line_to(Vec3(x, 0, 0), length, feed, i + 1));
    passages.push_back({{0, 0, stretch.speed, 0, 0, i, stretch.cause}, stretch.duration});
  }
  return testing::trajectory_of(toolpath, passages, axis_speed);
}

TEST(SlowPlaces, OfADipIsTheTimeBeyondTheProgrammedFeed) {
  const SlowPlaces found = find_slow_places(steady_run({{50, 1}, {25, 2, radial}, {50, 1}}));
  ASSERT_EQ(found.places.size(), 1U);
  const SlowPlace& place = found.places[0];
  EXPECT_NEAR(place.loss, 1, 1e-12);  // 50 mm in 2 s that would take 1 s
  EXPECT_NEAR(place.from, 1, 1e-12);
  EXPECT_NEAR(place.to, 3, 1e-12);
  EXPECT_EQ(place.line, 2U);
  EXPECT_EQ(place.first_line, 2U);
  EXPECT_EQ(place.last_line, 2U);
  EXPECT_NEAR(place.feed, 25, 1e-12);
  EXPECT_EQ(place.programmed_feed, 50);
  EXPECT_EQ(place.cause, radial);
  EXPECT_EQ(found.count, 1U);
  EXPECT_NEAR(found.loss, 1, 1e-12);
}

TEST(SlowPlaces, RunAtTheProgrammedFeedHasNone) {
  const SlowPlaces found = find_slow_places(steady_run({{50, 1}, {50, 2}}));
  EXPECT_TRUE(found.places.empty());
  EXPECT_NEAR(found.loss, 0, 1e-12);
}

TEST(SlowPlaces, AreCutAtThePeakBetweenTwoDips) {
  const SlowPlaces found = find_slow_places(
      steady_run({{50, 1}, {20, 1, radial}, {30, 1, radial}, {40, 1}, {30, 1}, {10, 1, jerk}, {50, 1}}));
  ASSERT_EQ(found.places.size(), 2U);
  EXPECT_NEAR(found.places[0].loss, 0.6 + 0.4 + 0.2, 1e-12);
  EXPECT_NEAR(found.places[0].to, 4, 1e-12);
  EXPECT_EQ(found.places[0].line, 2U);
  EXPECT_EQ(found.places[0].last_line, 4U);
  EXPECT_EQ(found.places[0].cause, radial);
  EXPECT_NEAR(found.places[1].loss, 0.4 + 0.8, 1e-12);
  EXPECT_NEAR(found.places[1].from, 4, 1e-12);
  EXPECT_EQ(found.places[1].line, 6U);
  EXPECT_EQ(found.places[1].cause, jerk);
}

TEST(SlowPlaces, ARippleOfLessThanATenthDoesNotCut) {
  const SlowPlaces found =
      find_slow_places(steady_run({{50, 1}, {20, 1}, {24, 1}, {20, 1}, {24, 1}, {19, 1}, {50, 1}}));
  ASSERT_EQ(found.places.size(), 1U);
  EXPECT_NEAR(found.places[0].from, 1, 1e-12);
  EXPECT_NEAR(found.places[0].to, 6, 1e-12);
  EXPECT_EQ(found.places[0].line, 6U);
}

/// At a programmed feed that the machine never comes near, what counts is how deep a dip is in the feed
/// beside it.
TEST(SlowPlaces, AreCutAtDipsOfAFeedFarBelowTheProgrammedOneToo) {
  const SlowPlaces found =
      find_slow_places(steady_run({{4, 1}, {1, 1}, {4, 1}, {3.5, 1}, {4, 1}, {1, 1}, {4, 1}}));
  ASSERT_EQ(found.places.size(), 2U);
  EXPECT_EQ(found.places[0].line, 2U);
  EXPECT_EQ(found.places[1].line, 6U);
}

/// A cut at half its feed and a rapid at half of its speed behind it: no peak lies between them.
TEST(SlowPlaces, ARapidIsAPlaceOfItsOwn) {
  Toolpath toolpath;
  toolpath.segments = {line_to(Vec3(50, 0, 0), 50, 50, 1), line_to(Vec3(75, 0, 0), 25, 50, 2),
                       line_to(Vec3(325, 0, 0), 250, 50, 3), line_to(Vec3(350, 0, 0), 25, 50, 4)};
  toolpath.segments[2].rapid = true;
  const SlowPlaces found = find_slow_places(testing::trajectory_of(toolpath,
                                                                   {{{0, 0, 50, 0, 0, 0, {}}, 1},
                                                                    {{0, 0, 25, 0, 0, 1, radial}, 1},
                                                                    {{0, 0, 250, 0, 0, 2, jerk}, 1},
                                                                    {{0, 0, 25, 0, 0, 3, radial}, 1}},
                                                                   axis_speed));
  ASSERT_EQ(found.places.size(), 3U);
  for (const std::uint32_t i : {0U, 1U, 2U}) {
    EXPECT_EQ(found.places[i].first_line, i + 2);
    EXPECT_EQ(found.places[i].last_line, i + 2);
    EXPECT_NEAR(found.places[i].loss, 0.5, 1e-9);
  }
  EXPECT_EQ(found.places[0].cause, radial);
  EXPECT_EQ(found.places[1].cause, jerk);
}

TEST(SlowPlaces, SlowingDownCountsForWhatSetsTheSlowerPlace) {
  Toolpath toolpath;
  toolpath.segments = {line_to(Vec3(100, 0, 0), 100, 50, 1), line_to(Vec3(125, 0, 0), 25, 50, 2)};
  Piece down{0, 0, 50, -50, 0, 1, {CauseKind::ramp_down, -1}};
  down.second = static_cast<std::uint8_t>(cause_index({CauseKind::exact_stop, -1}));
  const SlowPlaces found = find_slow_places(
      testing::trajectory_of(toolpath, {{{0, 0, 50, 0, 0, 0, {}}, 2}, {down, 1}}, axis_speed));
  ASSERT_EQ(found.places.size(), 1U);
  EXPECT_EQ(found.places[0].cause, (Cause{CauseKind::exact_stop, -1}));
  EXPECT_NEAR(found.places[0].loss, 1 - 25.0 / 50, 1e-12);
  EXPECT_NEAR(found.places[0].slowest, 3, 1e-12);
}

TEST(SlowPlaces, SeesADipInsideAPiece) {
  // v = 50 - 80 t + 40 t^2 over 2 s is slowest after 1 s, 10 mm/s.
  Toolpath toolpath;
  const double length = 100 - 40 * 4 + 40 * 8.0 / 3;
  toolpath.segments = {line_to(Vec3(length, 0, 0), length, 50, 1)};
  const SlowPlaces found =
      find_slow_places(testing::trajectory_of(toolpath, {{{0, 0, 50, -80, 80, 0, jerk}, 2}}, axis_speed));
  ASSERT_EQ(found.places.size(), 1U);
  EXPECT_NEAR(found.places[0].slowest, 1, 1e-12);
  EXPECT_NEAR(found.places[0].feed, 10, 1e-9);
  EXPECT_NEAR(found.places[0].loss, 2 - length / 50, 1e-12);
}

TEST(SlowPlaces, ADwellIsNoLoss) {
  Toolpath toolpath;
  toolpath.segments = {line_to(Vec3(50, 0, 0), 50, 50, 1)};
  testing::append_dwell(toolpath, 3);
  toolpath.segments.push_back(line_to(Vec3(100, 0, 0), 50, 50, 3));
  const SlowPlaces found =
      find_slow_places(testing::trajectory_of(toolpath,
                                              {{{0, 0, 50, 0, 0, 0, {}}, 1},
                                               {{0, 0, 0, 0, 0, 1, {CauseKind::dwell}}, 3},
                                               {{0, 0, 50, 0, 0, 2, {}}, 1}},
                                              axis_speed));
  EXPECT_TRUE(found.places.empty());
  EXPECT_NEAR(found.loss, 0, 1e-12);
}

TEST(SlowPlaces, KeepsThoseThatLoseMost) {
  std::vector<Steady> stretches{{50, 1}};
  std::mt19937 random(5);
  std::vector<double> losses;
  for (int i = 0; i < 500; ++i) {
    const double duration = std::uniform_real_distribution(0.1, 2.0)(random);
    losses.push_back(duration / 2);
    stretches.push_back({25, duration, radial});
    stretches.push_back({50, 0.1});
  }
  const Trajectory run = steady_run(stretches);
  const SlowPlaces found = find_slow_places(run, 7);
  EXPECT_EQ(found.count, 500U);
  EXPECT_NEAR(found.loss, find_slow_places(run).loss, 1e-9);
  ASSERT_EQ(found.places.size(), 7U);
  EXPECT_TRUE(std::ranges::is_sorted(found.places, {}, &SlowPlace::from));
  std::ranges::sort(losses, std::greater());
  std::vector<double> kept;
  for (const SlowPlace& place : found.places) {
    kept.push_back(place.loss);
  }
  std::ranges::sort(kept, std::greater());
  for (std::size_t i = 0; i < kept.size(); ++i) {
    EXPECT_NEAR(kept[i], losses[i], 1e-9);
  }
}

TEST(SlowPlaces, OfNothingIsEmpty) {
  EXPECT_TRUE(find_slow_places(Trajectory()).places.empty());
}

/// The losses of all places are the cycle time less the path at its programmed feeds.
TEST(SlowPlaces, AccountForAllTimeThatEveryModelLoses) {
  std::mt19937 random(3);
  for (const ControlModel* model : all_models()) {
    const Toolpath path = testing::random_path(random, 40);
    const Trajectory run = model->simulate(path, testing::spinner(), testing::spinner_settings(*model));
    const SlowPlaces found = find_slow_places(run);
    double programmed = 0;
    for (std::size_t i = 0; i < run.path().size(); ++i) {
      programmed += run.path().length(i) / run.feed_of(i);
    }
    double sum = 0;
    double before = 0;
    for (const SlowPlace& place : found.places) {
      sum += place.loss;
      ASSERT_LE(before, place.from + 1e-12 * run.duration()) << model->info().id;
      ASSERT_LT(place.from, place.to) << model->info().id;
      ASSERT_LE(place.slowest, run.duration());
      ASSERT_LE(place.first_line, place.last_line);
      ASSERT_LT(place.feed, place.programmed_feed);
      before = place.to;
    }
    const double scale = run.duration() + programmed;
    EXPECT_NEAR(found.loss, run.duration() - programmed, 1e-6 * scale) << model->info().id;
    if (model->info().id == "linuxcnc") {  // where blocks overlap it gains on the programmed feed
      EXPECT_GE(sum, found.loss);
    } else {
      EXPECT_NEAR(sum, found.loss, 1e-5 * scale) << model->info().id;
    }
    EXPECT_EQ(found.places.size() > 3, model->info().id != "cam") << model->info().id;  // which loses none
  }
}

/// What is said of a place must be said of an instant that its cause rules.
TEST(SlowPlaces, OfSamplesAreExplainedByTheirOwnCause) {
  int looked_at = 0;
  for (const char* name : {"essid_table1.nc", "msaddek_pocket.nc", "fanuc_flange.nc", "lesson_corners.nc",
                           "lesson_short_blocks.nc", "trochoidal_slot.nc", "tapie_bore.nc"}) {
    const LoadedProgram program =
        load_program(std::filesystem::path(FEEDSCOPE_SOURCE_DIR) / "resources/programs" / name);
    for (const char* model : {"essid", "gassara", "tapie", "msaddek", "ward", "optimal"}) {
      const feedscope::Run run = simulate_run(program, make_setup({"", model, {}, {}}));
      for (const SlowPlace& place : find_slow_places(*run.trajectory, 30).places) {
        const double instant = ruled_instant(*run.trajectory, place);
        const Explanation why = explain(run, run.trajectory->state(instant));
        EXPECT_GE(instant, place.from) << name << ", " << model;
        EXPECT_LE(instant, place.to) << name << ", " << model;
        const Cause told = why.ahead ? why.ahead->reason.cause : why.reason.cause;
        EXPECT_EQ(cause_key(told), cause_key(place.cause))
            << name << ", " << model << ", " << instant << " s";
        ++looked_at;
      }
    }
  }
  EXPECT_GT(looked_at, 200);
}

}  // namespace
}  // namespace feedscope
