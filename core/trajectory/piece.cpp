#include "core/trajectory/piece.h"

#include <algorithm>
#include <cmath>

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
  double low = 0;
  double high = duration;
  const double straight = (target - from.q) / from.v;  // exact at constant speed
  double tau = straight < duration ? straight : duration / 2;
  for (int i = 0; i < 100 && high - low > 1e-15 * (1 + duration); ++i) {
    const LawPoint at = advance(from, tau);
    const double off = at.q - target;
    (off < 0 ? low : high) = tau;
    const double newton = tau - off / at.v;
    if (std::abs(newton - tau) <= 1e-16 * (1 + duration)) {
      return tau;
    }
    tau = newton > low && newton < high ? newton : (low + high) / 2;
  }
  return high;
}

}  // namespace feedscope
