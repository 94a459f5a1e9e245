#pragma once

#include <vector>

#include "core/feed/node_plan.h"
#include "core/models/optimal/path_cells.h"

namespace feedscope {

/// Initial law of JerkLaw: from standstill to standstill within static limits of every part of the path, by
/// the planner of the planned models. Curves are divided into parts of similar static speed, so that a sharp
/// place slows only its surroundings and not the whole curve.
class StaticLaw {
 public:
  struct Phase {
    double time;  ///< [s]
    double jerk;
    Motion1d at;
  };

  void clear();
  /// Appends a span of the path, with cells `cells`; `jerk` of its axes, `feed` its speed.
  void add_span(const std::vector<PathCell>& cells, const SpeedBound& feed, const AxisVectors& axes,
                const Vec3& jerk);
  /// Time in which `cells` are passed at their static speeds [s].
  static double time_of(const std::vector<PathCell>& cells, const SpeedBound& feed, const AxisVectors& axes,
                        const Vec3& jerk);
  /// Plans everything added.
  void plan();
  /// Slows down the part at path length `s` from the next plan() on, but not again if it begins at `lowered`.
  /// Returns its start [mm].
  double lower_at(double s, double lowered);

  std::size_t size() const { return parts_.size(); }
  /// Parts in order of the path. Start of a part from the start of the law [mm].
  double part_begin(std::size_t part) const { return begins_[part]; }
  double part_end(std::size_t part) const { return part + 1 < size() ? begins_[part + 1] : length_; }
  /// True if it is the last part of its span.
  bool ends_span(std::size_t part) const { return ends_span_[part] != 0; }
  double length() const { return length_; }  ///< [mm]
  /// Factor of the number of cells that the part needs: larger where it had to be lowered.
  double fineness(std::size_t part) const { return fineness_[part]; }

  bool is_straight() const { return straight_; }  ///< one part per span, full limits
  const PlanElement& part(std::size_t index) const { return parts_[index]; }
  /// Phases in order; the last one is the end.
  const std::vector<Phase>& phases() const { return phases_; }
  double duration() const { return phases_.back().time; }  ///< [s]
  double ramp_time() const { return ramp_time_; }          ///< of the fastest ramps [s]

  /// The motion at `time`; times in order from rewind() on.
  Motion1d at(double time);
  /// Time at which path length `s` is reached; in order from rewind() on.
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
