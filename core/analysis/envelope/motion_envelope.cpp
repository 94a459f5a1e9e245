#include "core/analysis/envelope/motion_envelope.h"

#include <algorithm>
#include <utility>

#include "core/analysis/envelope/part_looks.h"

namespace feedscope {

namespace {

constexpr std::size_t pieces_a_group = 4;

}  // namespace

MotionEnvelope::MotionEnvelope(std::shared_ptr<const Trajectory> trajectory, Progress* progress)
    : trajectory_(std::move(trajectory)), causes_(trajectory_) {
  const std::size_t pieces = trajectory_->pieces().size();
  std::vector<MotionBand> groups((pieces + pieces_a_group - 1) / pieces_a_group);
  std::size_t reported = 0;
  for (PartWalk walk(*trajectory_); !walk.done(); walk.next()) {
    const Part& part = walk.part();
    MotionBand band;
    add_part(band, part, walk.motion(), part.duration);
    groups[part.piece / pieces_a_group].add(band);
    if (!trajectory_->is_rapid(part.element)) {
      cutting_.add(band);
    } else {
      rapids_.add(part.time, part.time + part.duration);
    }
    if (progress != nullptr && part.piece >= reported) {
      progress->report(static_cast<double>(part.piece) / static_cast<double>(pieces));
      reported = part.piece + std::size_t{4096};
    }
  }
  pyramid_ = Pyramid<MotionBand>(std::move(groups));
}

MotionBand MotionEnvelope::column(double from, double to, double whole_share) const {
  MotionBand band;
  if (trajectory_ == nullptr || trajectory_->pieces().empty() || to < 0 || from > trajectory_->duration()) {
    return band;
  }
  const std::size_t first = trajectory_->piece_at(from);
  const std::size_t last = trajectory_->piece_at(to);
  std::size_t first_whole = first / pieces_a_group;
  std::size_t end_whole = last / pieces_a_group + 1;
  const double short_enough = (to - from) * whole_share;
  if (group_duration(first_whole) > short_enough) {
    const std::size_t group_end = (first_whole + 1) * pieces_a_group;
    add_pieces(band, first, std::min(last, group_end - 1), from, to);
    ++first_whole;
  }
  if (end_whole > first_whole && group_duration(end_whole - 1) > short_enough) {
    --end_whole;
    add_pieces(band, end_whole * pieces_a_group, last, from, to);
  }
  if (end_whole > first_whole) {
    pyramid_.add(band, first_whole, end_whole);
  }
  return band;
}

double MotionEnvelope::group_duration(std::size_t group) const {
  const std::size_t first = group * pieces_a_group;
  const std::size_t last = std::min(first + pieces_a_group, trajectory_->pieces().size()) - 1;
  return trajectory_->piece_end(last) - trajectory_->pieces()[first].time;
}

void MotionEnvelope::add_pieces(MotionBand& band, std::size_t first, std::size_t last, double from,
                                double to) const {
  for (std::size_t i = first; i <= last; ++i) {
    const double start = trajectory_->pieces()[i].time;
    const double begin = std::max(from, start) - start;
    const double end = std::min(to, trajectory_->piece_end(i)) - start;
    if (begin < end || i == first) {
      add_piece(band, i, begin, std::max(begin, end));
    }
  }
}

void MotionEnvelope::add_piece(MotionBand& band, std::size_t piece, double from, double to) const {
  const double until = trajectory_->pieces()[piece].time + to;
  for (PartWalk walk(*trajectory_, piece, from); !walk.done(); walk.next()) {
    const Part& part = walk.part();
    if (part.piece != piece || part.time > until) {
      break;
    }
    add_part(band, part, walk.motion(), std::min(part.duration, until - part.time));
  }
}

void MotionEnvelope::add_part(MotionBand& band, const Part& part, const PartMotion& motion,
                              double duration) const {
  band.add(motion.state_without_length(0));
  if (!(duration > 0)) {
    return;
  }
  band.add(motion.state_without_length(duration));
  const double speed_turns = part.j == 0 ? 0 : -part.a / part.j;
  if (speed_turns > 0 && speed_turns < duration) {
    band.add(motion.state_without_length(speed_turns));
  }
  const int inner = inner_looks(*trajectory_, part, motion.curve(), duration);
  for (int k = 1; k <= inner; ++k) {
    band.add(motion.state_without_length(duration * k / (inner + 1)));
  }
}

}  // namespace feedscope
