#include "core/analysis/agreement/trace_pose.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/analysis/agreement/path_shape.h"

namespace feedscope {
namespace {

constexpr double inch = 25.4;
constexpr double another_shape = 0.1;  // of the size: mean distance from which shapes differ
constexpr double same_size = 0.03;     // by which the extents of the same shape may differ

std::vector<Vec3> visible(const ProgrammedCourse& course, const std::vector<Vec3>& places) {
  std::vector<Vec3> seen;
  seen.reserve(places.size());
  for (const Vec3& place : places) {
    seen.push_back(course.visible(place));
  }
  return seen;
}

}  // namespace

bool TracePose::plain() const {
  return scale == 1 && mirror == Vec3::Ones();
}

TracePose find_pose(const ProgrammedCourse& course, const MotionRecord& record) {
  TracePose pose;
  std::vector<Vec3> path;
  for (std::size_t i = 0; i < course.size(); ++i) {
    path.push_back(course.point(i));
  }
  const std::vector<Vec3> recorded = visible(course, record.place);
  const Vec3 wanted = course.bounds().max - course.bounds().min;
  const Bounds bounds = bounds_of(recorded);
  if (recorded.empty() || !(wanted.norm() > 0)) {
    return pose;
  }
  const Vec3 extent = bounds.max - bounds.min;
  for (const double scale : {inch, 1 / inch}) {
    if (std::abs(scale * extent.norm() / wanted.norm() - 1) < same_size) {
      pose.scale = scale;
    }
  }
  const auto same_extent = [&] {
    for (int axis = 0; axis < 3; ++axis) {
      if (std::abs(pose.scale * extent[axis] - wanted[axis]) > same_size * wanted.norm()) {
        return false;
      }
    }
    return true;
  }();
  if (!same_extent) {  // not exactly one run of the program: only its own coordinates can be trusted
    pose.scale = 1;
    return pose;
  }
  const std::vector<Vec3> shape = shape_of(path, wanted.norm() * 1e-3);
  const std::vector<Vec3> raw = shape_of(recorded, extent.norm() * 1e-3);
  const Vec3 middle = (course.bounds().min + course.bounds().max) / 2;
  double best = std::numeric_limits<double>::infinity();
  for (int signs = 0; signs < 8; ++signs) {
    TracePose candidate;
    candidate.scale = pose.scale;
    bool seen = true;
    for (int axis = 0; axis < 3; ++axis) {
      const bool mirrored = (signs >> axis & 1) != 0;
      candidate.mirror[axis] = mirrored ? -1 : 1;
      seen = seen && (!mirrored || wanted[axis] > same_size * wanted.norm());
    }
    if (!seen) {
      continue;  // an axis without extent has no sign
    }
    candidate.offset =
        middle - candidate.scale * candidate.mirror.cwiseProduct((bounds.min + bounds.max) / 2);
    std::vector<Vec3> moved;
    for (const Vec3& place : raw) {
      moved.push_back(candidate.apply(place));
    }
    const double off = mean_distance(shape, moved);
    if (off < 0.5 * best) {  // by a clear margin: the plain transformation has priority
      best = off;
      pose = candidate;
    }
  }
  if (best > another_shape * wanted.norm()) {
    return {};  // another shape: its extent cannot be trusted
  }
  return pose;
}

Vec3 offset_left(const ProgrammedCourse& course, const MotionRecord& record, const MatchedRecord& matched,
                 double noise) {
  constexpr double least_offset = 5e-3;  // [mm]: less counts as none
  constexpr int rounds = 3;
  Vec3 offset = Vec3::Zero();
  for (int round = 0; round < rounds; ++round) {
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    Vec3 right = Vec3::Zero();
    std::size_t part = 0;
    for (std::size_t i = matched.first; i < matched.end; ++i) {
      const double s = matched.s[i];
      if (std::isnan(s)) {
        continue;
      }
      while (part + 2 < course.size() && course.s(part + 1) < s) {
        ++part;
      }
      const Vec3 line = course.point(part + 1) - course.point(part);
      if (!(line.norm() > 0)) {
        continue;
      }
      const Vec3 t = line.normalized();
      const Vec3 off = course.visible(record.place[i]) - course.point(part);
      const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - t * t.transpose();
      const double weight = 1 / (1e-3 + (across * (off - offset)).norm());  // the agreeing majority decides
      sum += weight * across;
      right += weight * (across * off);
    }
    const double ridge = 1e-6 * (sum.trace() + 1);
    offset = (sum + ridge * Eigen::Matrix3d::Identity()).ldlt().solve(right);
  }
  return offset.norm() > std::max(least_offset, 3 * noise) ? offset : Vec3(Vec3::Zero());
}

}  // namespace feedscope
