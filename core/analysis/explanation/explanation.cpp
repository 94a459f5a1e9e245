#include "core/analysis/explanation/explanation.h"

#include <array>
#include <cmath>

#include "core/analysis/explanation/reason_finder.h"

namespace feedscope {
namespace {

constexpr double no_time = 1e-9;  // rounding error of a piece, even in long programs [s]

/// Whether a piece on the way to a slower place is not significant by itself: it is very short, or a sample
/// of the law on a blend.
bool is_between(const Trajectory& trajectory, std::size_t index) {
  constexpr double brief = 1e-5;  // [s]
  const Piece& piece = trajectory.pieces()[index];
  const bool sample = piece.law == Law::parameter && (piece.a != 0 || piece.j != 0);
  return sample || trajectory.piece_end(index) - piece.time <= brief;
}

/// Drops the formula of a speed ceiling if the limiting place is farther along the path.
void drop_if_far_off(Reason& reason) {
  constexpr double near = 0.05;
  const bool speed = !reason.formula.empty() && reason.formula.dimension() == Dimension::feed;
  if (speed && std::abs(reason.formula.value() - reason.reached) > near * reason.reached) {
    reason.formula = {};
    reason.source.clear();
  }
}

/// Follows the pieces that brake for the same place, starting at `state.time`. What brakes from a higher
/// speed than was reached brakes for another place.
SlowerPlace find_slower_place(const Run& run, const ReasonFinder& reasons, const State& state) {
  constexpr int max_looks = 64;  // boundaries examined closely where nodes lower each other
  const Trajectory& trajectory = *run.trajectory;
  const std::size_t count = trajectory.pieces().size();
  const auto brakes = [&](std::size_t piece) {
    return piece < count && trajectory.pieces()[piece].cause.kind == CauseKind::ramp_down &&
           trajectory.slower_place(piece) == state.slower_place;
  };
  std::size_t piece = trajectory.piece_at(state.time);
  State there;
  Reason reason;
  for (int looks = 0;; ++looks) {
    std::size_t next = piece + 1;
    while (next < count && !brakes(next) && is_between(trajectory, next)) {
      ++next;
    }
    const auto speeds_up = [&] {
      constexpr double rounding = 1e-6;
      const double reached = trajectory.state(trajectory.piece_end(piece)).speed;
      return next != piece + 1 &&
             trajectory.state(trajectory.pieces()[next].time).speed > (1 + rounding) * reached + rounding;
    };
    const bool brakes_on = brakes(next) && !speeds_up();
    if (!brakes_on || looks < max_looks) {
      there = trajectory.state(trajectory.piece_end(piece));
      reason = reasons.find_at_start(there, state.slower_place);
    }
    if (!brakes_on || reason.sets_it()) {
      drop_if_far_off(reason);
      return {there.time, there.path_length, there.speed, std::move(reason)};
    }
    piece = next;
  }
}

/// Successive causes of a piece: that of a ramp is replaced by another while its acceleration is constant.
struct PieceCauses {
  int count = 1;
  std::array<Cause, 3> cause;
  std::array<double, 4> border{};  ///< [s]

  PieceCauses(const Trajectory& trajectory, std::size_t index) {
    const Piece& piece = trajectory.pieces()[index];
    const double end = trajectory.piece_end(index);
    cause[0] = piece.cause;
    border[0] = piece.time;
    border[1] = end;
    if (piece.law != Law::ramp || piece.cause.kind == CauseKind::ramp_down) {
      return;
    }
    const PiecePhases phases(piece, end - piece.time);
    count = phases.count();
    for (int i = 0; i < count; ++i) {
      const auto at = static_cast<std::size_t>(i);
      cause[at] = i == 1 ? all_causes()[piece.second] : piece.cause;
      border[at] = piece.time + phases.begin(i);
    }
    border[static_cast<std::size_t>(count)] = end;
  }
};

/// Moves from cause to cause within and between pieces.
class CauseWalk {
 public:
  CauseWalk(const Trajectory& trajectory, double time)
      : trajectory_(trajectory), piece_(trajectory.piece_at(time)), causes_(trajectory, piece_) {
    while (part_ + 1 < causes_.count && causes_.border[part_ + 1U] <= time) {
      ++part_;
    }
  }

  Cause cause() const { return causes_.cause[static_cast<std::size_t>(part_)]; }
  double from() const { return causes_.border[static_cast<std::size_t>(part_)]; }
  double to() const { return causes_.border[static_cast<std::size_t>(part_) + 1]; }

  bool takes_no_time() const { return to() - from() <= no_time; }

  bool next() {
    if (part_ + 1 < causes_.count) {
      ++part_;
      return true;
    }
    if (piece_ + 1 >= trajectory_.pieces().size()) {
      return false;
    }
    causes_ = PieceCauses(trajectory_, ++piece_);
    part_ = 0;
    return true;
  }

  bool previous() {
    if (part_ > 0) {
      --part_;
      return true;
    }
    if (piece_ == 0) {
      return false;
    }
    causes_ = PieceCauses(trajectory_, --piece_);
    part_ = causes_.count - 1;
    return true;
  }

 private:
  const Trajectory& trajectory_;
  std::size_t piece_;
  PieceCauses causes_;
  int part_ = 0;
};

}  // namespace

Explanation explain(const Run& run, const State& state) {
  Explanation explanation;
  explanation.state = state;
  if (run.trajectory == nullptr || run.trajectory->pieces().empty()) {
    return explanation;
  }
  const ReasonFinder reasons(run);
  explanation.reason = reasons.find(state, state.cause);
  if (state.cause.kind == CauseKind::ramp_down) {
    explanation.ahead = find_slower_place(run, reasons, state);
  }
  return explanation;
}

CauseStretch stretch_at(const Trajectory& trajectory, double time) {
  CauseStretch stretch;
  if (trajectory.pieces().empty()) {
    return stretch;
  }
  CauseWalk back(trajectory, time);
  CauseWalk on = back;
  stretch.cause = back.cause();
  stretch.from = back.from();
  while (back.previous() && (back.cause() == stretch.cause || back.takes_no_time())) {
    stretch.from = back.from();
  }
  stretch.to = on.to();
  while (on.next() && (on.cause() == stretch.cause || on.takes_no_time())) {
    stretch.to = on.to();
  }
  stretch.line = trajectory.state(stretch.from).line;
  return stretch;
}

std::optional<CauseStretch> stretch_before(const Trajectory& trajectory, const CauseStretch& stretch) {
  if (trajectory.pieces().empty()) {
    return std::nullopt;
  }
  CauseWalk walk(trajectory, stretch.from);
  do {
    if (walk.to() <= stretch.from && !walk.takes_no_time()) {
      return stretch_at(trajectory, walk.from());
    }
  } while (walk.previous());
  return std::nullopt;
}

std::optional<CauseStretch> stretch_after(const Trajectory& trajectory, const CauseStretch& stretch) {
  if (trajectory.pieces().empty() || stretch.to >= trajectory.duration()) {
    return std::nullopt;
  }
  return stretch_at(trajectory, stretch.to);
}

}  // namespace feedscope
