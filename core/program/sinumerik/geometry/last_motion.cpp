#include "core/program/sinumerik/geometry/last_motion.h"

namespace feedscope::sinumerik {

namespace {

Vec3 unit_or_zero(const Vec3& along) {
  return along.norm() > same_point ? Vec3(along.normalized()) : Vec3(Vec3::Zero());
}

}  // namespace

Vec3 LastMotion::direction(const PathWriter& path) const {
  const Vec3 end = path.position();
  if (!arc_) {
    return path.has_moved() ? unit_or_zero(end - start_) : Vec3(Vec3::Zero());
  }
  const ArcSolution solution =
      by_radius_ ? solve_radius_arc(start_, arc_->target, arc_->radius, arc_->axis, arc_->extra_turns)
                 : solve_center_arc(start_, arc_->target, arc_->center, arc_->axis, arc_->extra_turns);
  if (solution.fault != ArcFault::none) {
    return unit_or_zero(end - start_);
  }
  const ArcWords& last = solution.pieces[static_cast<std::size_t>(solution.count - 1)].words;
  return last.axis.cross(end - last.center).normalized();
}

}  // namespace feedscope::sinumerik
