#include "ui/film/film_times.h"

#include <gmock/gmock.h>

#include "core/base/error.h"

namespace feedscope::ui {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(FilmTimes, AFrameShowsWhatIsThatMuchLaterInTheRun) {
  const FilmTimes times{.from = 2, .to = 3, .speed = 0.5, .fps = 20};
  EXPECT_EQ(times.frames(), 41u) << "both ends are shown";
  for (std::size_t k = 0; k < times.frames(); ++k) {
    EXPECT_DOUBLE_EQ(times.time(k), 2 + static_cast<double>(k) * 0.5 / 20);
  }
  EXPECT_DOUBLE_EQ(times.length(), 41 / 20.0);
}

TEST(FilmTimes, TheLastFrameShowsTheEnd) {
  const FilmTimes times{.from = 0, .to = 1, .speed = 3, .fps = 10};  // steps of 0.3 s
  EXPECT_EQ(times.frames(), 5u);
  EXPECT_DOUBLE_EQ(times.time(3), 0.9);
  EXPECT_DOUBLE_EQ(times.time(4), 1);
}

TEST(FilmTimes, TheUsualSpeedGivesAFilmThatOneCanWatch) {
  EXPECT_EQ(usual_film_speed(5), 1);
  EXPECT_EQ(usual_film_speed(30), 1);
  for (const double span : {0.001, 0.4, 4.9, 31.0, 108.4, 18'000.0}) {
    const double length = span / usual_film_speed(span);
    EXPECT_GE(length, span < 5 ? 5 : 27) << span;
    EXPECT_LE(length, span < 5 ? 5.6 : 30) << span;
  }
  EXPECT_DOUBLE_EQ(usual_film_speed(108.4), 3.7) << "two digits, upwards";
  EXPECT_DOUBLE_EQ(usual_film_speed(0.53), 0.1);
}

TEST(FilmTimes, WhatIsWrongIsSaidWithWhatToChange) {
  const auto check = [](const FilmTimes& times) { return [times] { check_film_times(times, 60); }; };
  EXPECT_NO_THROW(check_film_times({.from = 0, .to = 60.0005}, 60)) << "a duration as it is shown";
  EXPECT_THAT(check({.from = 5, .to = 5}), ThrowsMessage<InputError>(HasSubstr("before that of --to")));
  EXPECT_THAT(check({.from = 70, .to = 60}),
              ThrowsMessage<InputError>(HasSubstr("begin at 70 s and end at 60 s")));
  EXPECT_THAT(check({.from = 0, .to = 61}), ThrowsMessage<InputError>(HasSubstr("the run takes 60 s")));
  EXPECT_THAT([] { check_film_times({.from = 0, .to = 0}, 0); },
              ThrowsMessage<InputError>(HasSubstr("does not move")));
}

TEST(FilmTimes, TooManyFramesNameTheSpeedThatIsEnough) {
  FilmTimes times{.from = 0, .to = 3600, .speed = 1, .fps = 25};
  EXPECT_THAT([&] { check_film_times(times, 3600); },
              ThrowsMessage<InputError>(testing::AllOf(HasSubstr("90001 frames"), HasSubstr("36000"),
                                                       HasSubstr("--speed 2.51 or more"))));
  times.speed = times.least_speed();
  EXPECT_NO_THROW(check_film_times(times, 3600));
  times.speed *= 0.99;
  EXPECT_THROW(check_film_times(times, 3600), InputError);
  times.speed = 1e-300;
  EXPECT_THROW(check_film_times(times, 3600), InputError) << "a count beyond all numbers";
}

}  // namespace
}  // namespace feedscope::ui
