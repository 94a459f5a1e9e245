#include "core/analysis/time/cause_times.h"

#include <algorithm>
#include <array>
#include <functional>
#include <utility>

namespace feedscope {

namespace {

constexpr std::size_t pieces_a_mark = 64;
constexpr std::size_t kind_count = cause_kind_count;

/// Whether the middle of a piece has its own cause.
bool holds_acceleration(const Piece& piece) {
  return piece.law == Law::ramp && piece.second != Piece::no_cause &&
         piece.cause.kind != CauseKind::ramp_down;
}

std::optional<CauseKind> longest(const std::array<double, kind_count>& by_kind) {
  const auto most = std::ranges::max_element(by_kind);
  return *most > 0 ? std::optional(static_cast<CauseKind>(most - by_kind.begin())) : std::nullopt;
}

}  // namespace

CauseTimes::CauseTimes(std::shared_ptr<const Trajectory> trajectory)
    : trajectory_(std::move(trajectory)), place_of_(all_causes().size()) {
  std::vector<bool> occurs(all_causes().size());
  for (const Piece& piece : trajectory_->pieces()) {
    occurs[cause_index(piece.cause)] = true;
    if (holds_acceleration(piece)) {
      occurs[piece.second] = true;
    }
  }
  for (std::size_t i = 0; i < occurs.size(); ++i) {
    if (occurs[i]) {
      place_of_[i] = static_cast<std::uint8_t>(seen_.size());
      seen_.push_back(static_cast<std::uint8_t>(i));
    }
  }
  const std::size_t pieces = trajectory_->pieces().size();
  marks_.reserve((pieces / pieces_a_mark + 1) * seen_.size());
  std::vector<double> sums(seen_.size());
  for (std::size_t i = 0; i < pieces; ++i) {
    if (i % pieces_a_mark == 0) {
      marks_.insert(marks_.end(), sums.begin(), sums.end());
    }
    add_piece(sums, i, trajectory_->piece_end(i) - trajectory_->pieces()[i].time);
  }
}

void CauseTimes::add_piece(std::vector<double>& sums, std::size_t piece, double duration) const {
  const Piece& at = trajectory_->pieces()[piece];
  double held = 0;
  if (holds_acceleration(at)) {
    const PiecePhases phases(at, trajectory_->piece_end(piece) - at.time);
    if (phases.count() > 1) {
      held = std::clamp(duration - phases.begin(1), 0.0, phases.end(1) - phases.begin(1));
      sums[place_of_[at.second]] += held;
    }
  }
  sums[place_of_[cause_index(at.cause)]] += duration - held;
}

std::vector<double> CauseTimes::until(double time) const {
  const double end = std::clamp(time, 0.0, trajectory_->duration());
  const std::size_t last = trajectory_->piece_at(end);
  const std::size_t mark = last / pieces_a_mark;
  const auto row = marks_.begin() + static_cast<std::ptrdiff_t>(mark * seen_.size());
  std::vector<double> sums(row, row + static_cast<std::ptrdiff_t>(seen_.size()));
  for (std::size_t i = mark * pieces_a_mark; i <= last; ++i) {
    const double start = trajectory_->pieces()[i].time;
    add_piece(sums, i, (i < last ? trajectory_->piece_end(i) : end) - start);
  }
  return sums;
}

std::vector<double> CauseTimes::between(double from, double to) const {
  std::vector<double> times(all_causes().size());
  if (seen_.empty() || !(to > from)) {
    return times;
  }
  const std::vector<double> before = until(from);
  const std::vector<double> after = until(to);
  for (std::size_t i = 0; i < seen_.size(); ++i) {
    times[seen_[i]] = std::max(0.0, after[i] - before[i]);
  }
  return times;
}

std::vector<double> CauseTimes::within(std::span<const ColumnStretch> stretches) const {
  std::vector<double> sums(all_causes().size());
  for (const ColumnStretch& stretch : stretches) {
    std::ranges::transform(sums, between(stretch.from, stretch.to), sums.begin(), std::plus());
  }
  return sums;
}

std::vector<std::optional<CauseKind>> CauseTimes::dominating(std::span<const double> times) const {
  std::vector<std::optional<CauseKind>> kinds(times.empty() ? 0 : times.size() - 1);
  if (seen_.empty() || times.empty()) {
    return kinds;
  }
  std::vector<double> before = until(times.front());
  for (std::size_t column = 0; column < kinds.size(); ++column) {
    std::vector<double> after = until(times[column + 1]);
    std::array<double, kind_count> by_kind{};
    for (std::size_t i = 0; i < seen_.size(); ++i) {
      by_kind[static_cast<std::size_t>(all_causes()[seen_[i]].kind)] += after[i] - before[i];
    }
    kinds[column] = longest(by_kind);
    before = std::move(after);
  }
  return kinds;
}

std::vector<std::optional<CauseKind>> CauseTimes::dominating(std::span<const ColumnStretch> stretches,
                                                             std::size_t count) const {
  std::vector<std::optional<CauseKind>> kinds(count);
  for (std::size_t i = 0; i < stretches.size();) {
    const std::size_t column = stretches[i].column;
    std::array<double, kind_count> by_kind{};
    for (; i < stretches.size() && stretches[i].column == column; ++i) {
      const std::vector<double> times = between(stretches[i].from, stretches[i].to);
      for (const std::uint8_t cause : seen_) {
        by_kind[static_cast<std::size_t>(all_causes()[cause].kind)] += times[cause];
      }
    }
    kinds[column] = longest(by_kind);
  }
  return kinds;
}

}  // namespace feedscope
