#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "core/analysis/envelope/band.h"
#include "core/analysis/envelope/part_looks.h"
#include "core/analysis/rotary/rotary_course.h"

namespace feedscope {

/// Instants of a part at which its rotary axes are sampled: those of its motion; evenly spaced ones while the
/// axes of an indexing machine turn; more of them over large rotations, since all axes of the machine rise
/// and fall with the angles.
class RotaryLooks {
 public:
  /// `turned`: rotation of all rotary axes together in the part [rad].
  RotaryLooks(const Trajectory& trajectory, const Part& part, const ElementCurve& curve, double turned);
  int count() const { return (waits_ ? 1 : motion_.count() - 1) * between_ + 1; }
  double at(int i) const;
  int first_after(double time) const;

 private:
  double motion_at(int i) const { return waits_ ? start_ + duration_ * i : motion_.at(i); }

  PartLooks motion_;
  double start_;     ///< [s]
  double duration_;  ///< [s]
  bool waits_;
  int between_;  ///< steps between consecutive instants of the motion, or ends of a separate rotation
};

/// Rotary axes of a run, part by part, for a SpanEnvelope.
class RotaryWalk {
 public:
  using Band = RotaryBand;
  /// The course, shared.
  class Source {
   public:
    explicit Source(std::shared_ptr<const RotaryCourse> course) : course_(std::move(course)) {}
    const RotaryCourse& course() const { return *course_; }
    double duration() const { return course_->trajectory().duration(); }

   private:
    std::shared_ptr<const RotaryCourse> course_;
  };

  /// `source` must outlive this.
  RotaryWalk(const Source& source, double time);

  bool done() const { return walk_.done(); }
  double begin() const { return walk_.part().time; }
  double end() const { return begin() + walk_.part().duration; }
  RotaryLooks looks() { return {course_.trajectory(), walk_.part(), motion().curve(), turned()}; }
  void add(Band& band, double time);
  /// Sample at an instant of the part [s].
  RotarySample sample(double time);
  /// Times in this part at which the tip on a line passes the end of the reach of a joint, where the jerk of
  /// rotary axes jumps, a place within that reach, or the place nearest to the first rotary axis [s].
  std::vector<double> turning_places();
  void next();

 private:
  const PartMotion& motion();
  double turned();

  const RotaryCourse& course_;
  PartWalk walk_;
  std::optional<PartMotion> motion_;  ///< of the current part
};

}  // namespace feedscope
