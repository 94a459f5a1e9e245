#include "core/trajectory/piece.h"

#include <algorithm>
#include <cmath>

#include "core/base/roots.h"

namespace feedscope {

PiecePhases::PiecePhases(const Piece& piece, double duration) {
  at_[0] = {piece.q, piece.v, piece.a, piece.j};
  begin_[1] = duration;
  if (piece.law != Law::ramp) {
    return;
  }
  count_ = 3;
  const double rise = std::min(piece.a / piece.j, duration / 2);
  begin_[1] = rise;
  begin_[2] = duration - rise;
  begin_[3] = duration;
  at_[0].a = 0;
  at_[1] = advance(at_[0], rise);
  at_[1].j = 0;
  at_[2] = advance(at_[1], begin_[2] - rise);
  at_[2].j = -piece.j;
}

int PiecePhases::at_time(double tau) const {
  int phase = 0;
  while (phase + 1 < count_ && tau >= begin_[phase + 1]) {
    ++phase;
  }
  return phase;
}

LawPoint PiecePhases::at(double tau) const {
  const int phase = at_time(tau);
  return advance(at_[phase], tau - begin_[phase]);
}

double time_to_reach(const LawPoint& from, double target, double duration) {
  if (from.q >= target) {
    return 0;
  }
  if (advance(from, duration).q < target) {
    return duration;
  }
  const double straight = (target - from.q) / from.v;  // exact at constant speed
  const RootTolerance tolerance{.step = 1e-16 * (1 + duration), .width = 1e-15 * (1 + duration)};
  return rising_root({0, duration}, straight < duration ? straight : duration / 2, tolerance,
                     [&](double tau) {
                       const LawPoint at = advance(from, tau);
                       return ValueAndSlope{at.q - target, at.v};
                     });
}

}  // namespace feedscope
