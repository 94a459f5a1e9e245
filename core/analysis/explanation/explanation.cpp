#include "core/analysis/explanation/explanation.h"

#include <array>

namespace feedscope {
namespace {

constexpr double no_time = 1e-9;  // rounding error of a piece, even in long programs [s]

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
  return run.trajectory == nullptr
             ? Explanation{state, {}, {}}
             : run.setup.model->explain({*run.trajectory, run.setup.machine, run.setup.settings}, state);
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
