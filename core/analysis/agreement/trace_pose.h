#pragma once

#include "core/analysis/agreement/path_matcher.h"
#include "core/analysis/agreement/programmed_course.h"

namespace feedscope {

/// How the coordinates of a trace stand to those of the program: place = scale mirror (recorded) + offset.
struct TracePose {
  double scale = 1;            ///< 25.4: the trace is in inches; 1/25.4: it was taken for inches
  Vec3 mirror = Vec3::Ones();  ///< -1: the axis is mirrored
  Vec3 offset = Vec3::Zero();  ///< [mm]
  bool plain() const;          ///< nothing but an offset
  Vec3 apply(const Vec3& recorded) const { return scale * mirror.cwiseProduct(recorded) + offset; }
};

/// Finds it from where a record and a path reach to and how they run: offsets where an axis is shifted, the
/// signs and the unit where those fit clearly better.
TracePose find_pose(const ProgrammedCourse& course, const MotionRecord& record);

/// By how much the places that were matched are off their path throughout, across it; zero below 5 um and
/// three times `noise` [mm].
Vec3 offset_left(const ProgrammedCourse& course, const MotionRecord& record, const MatchedRecord& matched,
                 double noise);

}  // namespace feedscope
