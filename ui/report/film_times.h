#pragma once

#include <cstddef>

namespace feedscope::ui {

inline constexpr std::size_t most_film_frames = 36'000;
inline constexpr int most_frames_a_second = 120;

/// The instants of a run that the frames of a film show: frame k what is at from + k speed / fps, and the
/// last one what is at `to`.
struct FilmTimes {
  double from = 0;   ///< of the run [s]
  double to = 0;     ///< of the run [s]
  double speed = 1;  ///< seconds of the run in a second of the film
  int fps = 25;      ///< frames a second

  /// At least one; a number that is too large for any film stands for all that are.
  std::size_t frames() const;
  /// What frame `k` of frames() shows [s].
  double time(std::size_t k) const;
  /// Of the film [s].
  double length() const { return static_cast<double>(frames()) / fps; }
  /// The lowest speed, of three digits, at which the film has at most most_film_frames.
  double least_speed() const;
};

/// The speed of a film of a stretch of `span` seconds: real time, where the film lasts 5 to 30 s at it, or
/// else the one of two digits at which it lasts about so long.
double usual_film_speed(double span);

/// Throws InputError that says what to change if `times` are no stretch of a run that takes `duration` [s],
/// or the film would have more than most_film_frames.
void check_film_times(const FilmTimes& times, double duration);

}  // namespace feedscope::ui
