#pragma once

#include <vector>

#include "core/feed/node_plan.h"
#include "core/models/optimal/path_cells.h"

namespace feedscope {

/// A law from standstill to standstill that keeps static limits of every part of the path, by the planner of
/// the planned models: what JerkLaw begins with. Curves are parts of about one static speed, so that a sharp
/// place slows its surroundings and not the whole curve.
class StaticLaw {
 public:
  struct Phase {
    double time;  ///< [s]
    double jerk;
    Motion1d at;
  };

  void clear();
  /// Appends a span of the path, whose cells are `cells`; `jerk` that of its axes, `feed` its speed.
  void add_span(const std::vector<PathCell>& cells, const SpeedBound& feed, const AxisVectors& axes,
                const Vec3& jerk);
  /// Time in which `cells` are passed at their static speeds [s].
  static double time_of(const std::vector<PathCell>& cells, const SpeedBound& feed, const AxisVectors& axes,
                        const Vec3& jerk);
  /// Plans what was added.
  void plan();
  /// From the next plan() on the part at path length `s` from the start is passed slower, but not once more
  /// if it begins at `lowered`. Returns where it begins [mm].
  double lower_at(double s, double lowered);

  std::size_t size() const { return parts_.size(); }
  /// Parts in order of the path. Where a part begins and ends from the start [mm].
  double part_begin(std::size_t part) const { return begins_[part]; }
  double part_end(std::size_t part) const { return part + 1 < size() ? begins_[part + 1] : length_; }
  /// Whether it is the last one of its span.
  bool ends_span(std::size_t part) const { return ends_span_[part] != 0; }
  double length() const { return length_; }  ///< [mm]
  /// How many times as many cells as usual the part needs: where it had to be lowered, more.
  double fineness(std::size_t part) const { return fineness_[part]; }

  bool is_straight() const { return straight_; }  ///< one part a span, full limits
  const PlanElement& part(std::size_t index) const { return parts_[index]; }
  /// Phases in order; the last one is the end.
  const std::vector<Phase>& phases() const { return phases_; }
  double duration() const { return phases_.back().time; }  ///< [s]
  double ramp_time() const { return ramp_time_; }          ///< of the fastest ramps [s]

  /// The motion at `time`; times in order from rewind() on.
  Motion1d at(double time);
  /// When path length `s` is reached; in order from rewind() on.
  double time_at(double s);
  std::size_t place() const { return phase_; }
  void rewind(std::size_t place = 0) { phase_ = place; }

 private:
  void add_part(const PathCell* first, const PathCell* last, const SpeedBound& feed, const AxisVectors& axes,
                const Vec3& jerk);
  void lay_phases(const std::vector<PlanNode>& nodes);

  std::vector<PlanElement> parts_;
  std::vector<double> begins_;    ///< of parts [mm]
  std::vector<double> fineness_;  ///< of parts
  std::vector<std::uint8_t> ends_span_;
  double length_ = 0;
  double largest_jerk_ = 0;
  bool straight_ = true;
  std::vector<Phase> phases_;
  std::size_t phase_ = 0;
  double ramp_time_ = 0;
};

}  // namespace feedscope
