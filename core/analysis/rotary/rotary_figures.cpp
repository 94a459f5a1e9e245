#include "core/analysis/rotary/rotary_figures.h"

#include <cmath>
#include <limits>

#include "core/analysis/rotary/rotary_peak_search.h"
#include "core/analysis/rotary/turn_law.h"
#include "core/toolpath/joint_shape.h"
#include "core/toolpath/turn_course.h"

namespace feedscope {
namespace {

constexpr double no_axis = std::numeric_limits<double>::quiet_NaN();

/// Samples where joints deflect the tool, and half way between them, where two joints may overlap.
class OrientationSearch {
 public:
  explicit OrientationSearch(const RotaryCourse& course)
      : course_(course), path_(*course.trajectory().path().programmed()) {}

  OrientationError largest() {
    for (const TurnJoint& joint : path_.turn_joints) {
      look(joint.segment, 1);
      look(joint.segment, 0.5);
      look(joint.segment + 1, 0.5);
    }
    return worst_;
  }

 private:
  void look(std::size_t segment, double share) {
    const SegmentTurn* turn = path_.segment_turn(segment);
    if (segment >= path_.segments.size() || !(path_.segments[segment].length > 0)) {
      return;
    }
    const double length = path_.segments[segment].length;
    const TurnJoint* behind = course_.joint_behind(segment);
    const TurnJoint* before = segment > 0 ? course_.joint_behind(segment - 1) : nullptr;
    std::array<double, 3> aside{};
    double sum = 0;
    for (std::size_t i = 0; i < aside.size(); ++i) {
      aside[i] = (behind != nullptr ? joint_turn(*behind, i, -((1 - share) * length)).value() : 0) +
                 (before != nullptr ? joint_turn(*before, i, share * length).value() : 0);
      sum += std::abs(aside[i]);
    }
    if (sum <= worst_.angle) {  // the tool deviates by less
      return;
    }
    std::array<double, 3> angles{};
    if (turn != nullptr) {
      angles = TurnCourse(course_.chain(), *turn, length).angles(share * length);
    } else if (before != nullptr || behind != nullptr) {
      const SegmentTurn* beside =
          before != nullptr ? path_.segment_turn(segment - 1) : path_.segment_turn(segment + 1);
      if (beside == nullptr) {
        return;
      }
      angles = before != nullptr ? beside->to : beside->from;
    }
    const Vec3 programmed = tool_direction(course_.chain(), angles);
    for (std::size_t i = 0; i < angles.size(); ++i) {
      angles[i] += aside[i];
    }
    const Vec3 rounded = tool_direction(course_.chain(), angles);
    const double angle = std::atan2(programmed.cross(rounded).norm(), programmed.dot(rounded));
    if (angle > worst_.angle) {
      worst_ = {angle, path_.segments[segment].line};
    }
  }

  const RotaryCourse& course_;
  const Toolpath& path_;
  OrientationError worst_;
};

}  // namespace

RotaryFigures rotary_figures(const std::shared_ptr<const RotaryCourse>& course, bool limits_jerk,
                             const Progress* progress) {
  RotaryFigures figures;
  const RotaryWalk::Source source(course);
  RotaryPeakSearch search;
  for (RotaryWalk walk(source, 0); !walk.done(); walk.next()) {
    stop_if_cancelled(progress);
    search.add(walk);
  }
  figures.rotary = search.rotary();
  figures.linear = search.linear();
  for (const RotaryTurn& turn : course->trajectory().path().programmed()->rotary_turns) {
    if (turn.great_circle && turn.law.way > 0) {
      continue;  // the search has covered it
    }
    for (const RotaryAxis& axis : course->axes()) {
      const RestToRestPlace most = TurnLaw(turn, course->axes(), axis).largest();
      figures.rotary[rotary_place(axis.name)].add(most.velocity, most.acceleration, most.jerk);
    }
  }
  for (std::size_t i = 0; i < figures.rotary.size(); ++i) {
    AxisPeaks& peaks = figures.rotary[i];
    if (!course->has(rotary_names[i])) {
      peaks = {no_axis, no_axis, no_axis};
    } else if (!limits_jerk) {
      peaks.jerk = no_axis;
    }
    if (!limits_jerk && figures.linear) {
      (*figures.linear)[i].jerk = no_axis;
    }
  }
  figures.orientation = OrientationSearch(*course).largest();
  return figures;
}

}  // namespace feedscope
