#pragma once

#include <cstdint>

#include "core/limits/cause.h"

namespace feedscope {

/// Meaning of q(t) of a piece, and its law.
enum class Law : std::uint8_t {
  path_length,  ///< path length from the element's start [mm], constant jerk
  ramp,         ///< the same; jerk j until the acceleration is a, then constant a, then back to 0 by -j
  parameter,    ///< the blend's own parameter u, constant third derivative
  filtered,     ///< path length; the motion is that of a FilteredMotion, q its value at the piece's start
};

/// Motion from `time` to the start of the next piece, over one path element or, by path length, over several
/// consecutive ones: q(tau) = q + v tau + a tau^2/2 + j tau^3/6. A filtered piece uses q only.
struct Piece {
  static constexpr std::uint8_t no_cause = 255;

  double time = 0;  ///< start [s]
  double q = 0;     ///< from the start of `element`
  double v = 0;
  double a = 0;  ///< ramp: reached in the middle, with the sign of j
  double j = 0;
  std::uint32_t element = 0;  ///< first one, index into the BlendedPath
  Cause cause;
  Law law = Law::path_length;
  /// cause_index() of a second cause: of the constant acceleration of a ramp; where `cause` is ramp_down, of
  /// the slower place ahead.
  std::uint8_t second = no_cause;
};
static_assert(sizeof(Piece) == 48);

/// Part of a piece on one element with one jerk. A piece of law path_length, parameter or filtered on a
/// single element is one part.
struct Part {
  double time = 0;      ///< start [s]
  double duration = 0;  ///< [s]
  double q = 0;         ///< as Piece, but from the start of this `element`
  double v = 0;
  double a = 0;
  double j = 0;
  std::uint32_t element = 0;
  std::uint32_t piece = 0;  ///< index of its piece
  Cause cause;
  Law law = Law::path_length;  ///< never `ramp`
};

/// q and its derivatives at one time.
struct LawPoint {
  double q = 0;
  double v = 0;
  double a = 0;
  double j = 0;
};
/// Law `tau` after `from`, at constant jerk.
inline LawPoint advance(const LawPoint& from, double tau) {
  return {from.q + tau * (from.v + tau * (from.a / 2 + tau * from.j / 6)),
          from.v + tau * (from.a + tau * from.j / 2), from.a + tau * from.j, from.j};
}

/// Phases of constant jerk within a piece: three of a ramp, otherwise one.
class PiecePhases {
 public:
  PiecePhases(const Piece& piece, double duration);
  int count() const { return count_; }
  double begin(int phase) const { return begin_[phase]; }    ///< from the start of the piece [s]
  double end(int phase) const { return begin_[phase + 1]; }  ///< [s]
  const LawPoint& at_begin(int phase) const { return at_[phase]; }
  /// First phase that ends after `tau`, at most the last.
  int at_time(double tau) const;
  LawPoint at(double tau) const;

 private:
  int count_ = 1;
  double begin_[4] = {0, 0, 0, 0};
  LawPoint at_[3];
};

/// First tau in [0, duration] at which a non-decreasing law that begins at `from` reaches `target`;
/// `duration` if it does not reach it.
double time_to_reach(const LawPoint& from, double target, double duration);

}  // namespace feedscope
