#include "core/models/optimal/slowed_law.h"

#include <algorithm>
#include <cmath>

#include "core/trajectory/part_walk.h"

namespace feedscope {
namespace {

constexpr int samples = 16;  ///< of a part

double largest_share(const Vec3& values, const Vec3& limits) {
  return values.cwiseAbs().cwiseQuotient(limits).maxCoeff();
}

}  // namespace

double SlowedLaw::slower_by(std::size_t first_piece, std::size_t last_piece) const {
  double factor = 1;
  for (PartWalk walk(run_, first_piece); !walk.done() && walk.part().piece < last_piece; walk.next()) {
    const Part& part = walk.part();
    const PartMotion motion = walk.motion();
    const Vec3& jerk = run_.path().in_corner(part.element) ? axes_.blend_jerk : axes_.jerk;
    const double feed = run_.feed_of(part.element);
    for (int k = 0; k <= samples; ++k) {
      const Kinematics at = motion.kinematics(part.duration * k / samples);
      factor = std::max({factor, at.velocity.norm() / feed, largest_share(at.velocity, axes_.velocity),
                         std::sqrt(largest_share(at.acceleration, axes_.acceleration)),
                         std::cbrt(largest_share(at.jerk, jerk))});
    }
  }
  return factor;
}

void SlowedLaw::replace_slower(std::uint32_t first, std::uint32_t last, const TrajectoryBuilder::Mark& start,
                               TrajectoryBuilder& builder) const {
  const std::vector<Piece>& pieces = run_.pieces();
  const auto before = [](const Piece& piece, std::uint32_t element) { return piece.element < element; };
  const auto begin = std::lower_bound(pieces.begin(), pieces.end(), first, before);
  const auto end = std::lower_bound(begin, pieces.end(), last, before);
  if (begin == end || begin->element != first || begin->q != 0) {
    return;
  }
  const auto first_piece = static_cast<std::size_t>(begin - pieces.begin());
  const auto last_piece = static_cast<std::size_t>(end - pieces.begin());
  const double time = run_.piece_end(last_piece - 1) - begin->time;
  const double taken = builder.time() - start.time;
  if (!(time < taken)) {
    return;
  }
  const double factor = slower_by(first_piece, last_piece);
  if (!(time * factor < taken)) {
    return;
  }
  builder.take_back(start);
  for (std::size_t p = first_piece; p < last_piece; ++p) {
    builder.add_piece(pieces[p], run_.piece_end(p) - pieces[p].time);
  }
  builder.slow_down(start, factor);
}

}  // namespace feedscope
