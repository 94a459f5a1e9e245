#pragma once

#include <cstddef>

namespace feedscope::ui {

inline constexpr std::size_t most_film_frames = 36'000;
inline constexpr int most_frames_a_second = 120;

/// The times of a run in the frames of a film: frame k is at from + k speed / fps, the last one at `to`.
struct FilmTimes {
  double from = 0;   ///< of the run [s]
  double to = 0;     ///< of the run [s]
  double speed = 1;  ///< seconds of the run per second of the film
  int fps = 25;      ///< frames per second

  /// At least one; a number too large for any film represents all larger ones.
  std::size_t frames() const;
  /// Time of frame `k` of frames() in the run [s].
  double time(std::size_t k) const;
  /// Of the film [s].
  double length() const { return static_cast<double>(frames()) / fps; }
  /// The lowest speed, rounded to three digits, at which the film has at most most_film_frames.
  double least_speed() const;
};

/// Speed of a film of `span` seconds of the run: real time if the film then lasts 5 to 30 s, else a speed of
/// two digits with about such a length.
double usual_film_speed(double span);

/// Throws InputError naming what to change if `times` are not a range of a run of `duration` [s], or the film
/// would have more than most_film_frames.
void check_film_times(const FilmTimes& times, double duration);

}  // namespace feedscope::ui
