#pragma once

#include "core/analysis/agreement/path_matcher.h"
#include "core/analysis/agreement/programmed_course.h"

namespace feedscope {

/// Transformation from the coordinates of a trace to those of the program: place = scale mirror (recorded) +
/// offset.
struct TracePose {
  double scale = 1;            ///< 25.4: the trace is in inches; 1/25.4: it was mistaken for inches
  Vec3 mirror = Vec3::Ones();  ///< -1: the axis is mirrored
  Vec3 offset = Vec3::Zero();  ///< [mm]
  bool plain() const;          ///< nothing but an offset
  Vec3 apply(const Vec3& recorded) const { return scale * mirror.cwiseProduct(recorded) + offset; }
};

/// Finds the pose from the extents and shapes of record and path: an offset if an axis is shifted, signs and
/// unit if others fit clearly better.
TracePose find_pose(const ProgrammedCourse& course, const MotionRecord& record);

/// Systematic offset of the matched positions across their path; zero below 5 um or three times `noise` [mm].
Vec3 offset_left(const ProgrammedCourse& course, const MotionRecord& record, const MatchedRecord& matched,
                 double noise);

}  // namespace feedscope
