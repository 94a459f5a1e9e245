#include "ui/film/film_times.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"

namespace feedscope::ui {

namespace {

constexpr double frame_rounding = 1e-9;   // of a frame
constexpr double typed_too_long = 0.001;  // [s]: durations are shown with so many decimals

/// The nearest number of `digits` digits not below (`up`) or not above `value` > 0.
double rounded(double value, int digits, bool up) {
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - digits + 1);
  return (up ? std::ceil(value / unit - frame_rounding) : std::floor(value / unit + frame_rounding)) * unit;
}

}  // namespace

std::size_t FilmTimes::frames() const {
  constexpr double too_many = 1e12;
  const double steps = (to - from) / speed * fps;
  return static_cast<std::size_t>(std::clamp(std::ceil(steps - frame_rounding), 0.0, too_many)) + 1;
}

double FilmTimes::time(std::size_t k) const {
  return std::min(from + static_cast<double>(k) * speed / fps, to);
}

double FilmTimes::least_speed() const {
  return rounded((to - from) * fps / static_cast<double>(most_film_frames - 1), 3, true);
}

double usual_film_speed(double span) {
  constexpr double shortest = 5;  // [s]
  constexpr double longest = 30;  // [s]
  if (span <= 0 || (span >= shortest && span <= longest)) {
    return 1;
  }
  return span > longest ? rounded(span / longest, 2, true) : rounded(span / shortest, 2, false);
}

void check_film_times(const FilmTimes& times, double duration) {
  if (duration <= 0) {
    throw InputError(NC_("core", "the program does not move, so that there is nothing to film"));
  }
  if (times.from >= times.to) {
    throw InputError(message(
        NC_("core",
            "the film would begin at {:.6g} s and end at {:.6g} s; give --from a time before that of --to"),
        times.from, times.to));
  }
  if (times.to > duration + typed_too_long) {
    throw InputError(
        message(NC_("core", "the film would end at {:.6g} s, but the run takes {:.6g} s; use a smaller --to"),
                times.to, duration));
  }
  if (times.frames() > most_film_frames) {
    throw InputError(message(NC_("core",
                                 "the film would have {} frames, and at most {} can be written; use --speed "
                                 "{:.6g} or more, a smaller --fps, or a shorter stretch by --from and --to"),
                             times.frames(), most_film_frames, times.least_speed()));
  }
}

}  // namespace feedscope::ui
