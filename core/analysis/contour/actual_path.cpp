#include "core/analysis/contour/actual_path.h"

#include <cmath>

namespace feedscope {

ActualPath::ActualPath(std::shared_ptr<const Trajectory> trajectory, const Machine& machine,
                       Progress* progress)
    : response_(std::move(trajectory), machine, progress),
      deviation_(*response_.trajectory().path().programmed()) {}

ActualSample ActualPath::at(const State& state) const {
  return ActualSampler(*this, state.time).at(state);
}

double ActualPath::set_contour_error(const State& state) const {
  return ActualErrors(*this).at(state.position, state.element);
}

PathDeviation::Foot ActualErrors::foot(const Vec3& position, std::uint32_t element) {
  const PathDeviation::Foot found = deviation_.nearest(position, trajectory_.path().segment(element), last_);
  last_ = found.segment;
  return found;
}

bool ActualErrors::is_cut(std::uint32_t element) const {
  return !trajectory_.is_rapid(element) && trajectory_.path().kind(element) != ElementKind::dwell;
}

bool ActualErrors::is_of_cut(const PathDeviation::Foot& foot, std::uint32_t element) const {
  return is_cut(element) && !trajectory_.path().programmed()->segments[foot.segment].rapid;
}

double ActualErrors::at(const Vec3& position, std::uint32_t element) {
  return std::sqrt(foot(position, element).squared);
}

ActualSample ActualSampler::at(const State& state) {
  const ActualMotion motion = walk_.at(state.time);
  const PathDeviation::Foot foot = errors_.foot(motion.position, state.element);
  return {motion, std::sqrt(foot.squared), errors_.is_of_cut(foot, state.element)};
}

}  // namespace feedscope
