#pragma once

#include <cstdint>
#include <vector>

#include "core/analysis/contour/path_deviation.h"
#include "core/trajectory/part_walk.h"

namespace feedscope {

/// Length of a programmed path before each of its segments, then its total [mm].
std::vector<double> lengths_before(const Toolpath& programmed);

/// A short time of a run, and its progress along the program meanwhile.
struct ProgressSpan {
  double time = 0;      ///< start [s]
  double duration = 0;  ///< [s]
  double begin = 0;     ///< programmed path length [mm]
  double end = 0;       ///< not before `begin`
  LawPoint law;         ///< programmed path length from `begin`, never decreasing [mm]
  std::uint32_t segment = 0;
  bool dwell = false;

  double end_time() const { return time + duration; }
  double offset_at(double tau) const;  ///< from `begin` at `tau` [s] after the start [mm]
  double tau_at(double offset) const;  ///< first time at `offset`, inverse of offset_at() [s]
  bool same_law(const ProgressSpan& other) const;
};

/// A run as progress along the *programmed* path, which is the same for every control: two runs of one
/// program with the same progress are at the same place, however they cut the corners.
///
/// Lines and arcs that a control runs unchanged count as they are. A corner curve corresponds to the
/// programmed path that it replaces, in proportion to its length: its middle is at the corner. On filtered
/// motion, whose blocks merge, the place is the nearest programmed point in passing
/// (PathDeviation::foot_near).
class CourseWalk {
 public:
  /// Starts at the first span. `trajectory` has pieces; it and `lengths`, of its programmed path, outlive
  /// this.
  CourseWalk(const Trajectory& trajectory, const std::vector<double>& lengths);

  const ProgressSpan& span() const { return spans_[at_]; }
  /// Advances to the next span; returns false at the last one and stays there.
  bool next();

 private:
  /// A span whose place on the program is not determined yet.
  struct RawSpan {
    double time;
    double duration;
    double length;  ///< executed [mm]
    double speed_from;
    double speed_to;
  };

  void gather();
  void gather_curve();
  void gather_blend_part();
  void gather_filtered();
  void follow_part();
  void add_span(const RawSpan& raw, double end, double scale);
  double programmed_until(std::size_t segment) const;
  double end_of(std::uint32_t element) const;
  bool is_filtered(std::size_t element) const;

  const Trajectory& trajectory_;
  const std::vector<double>& lengths_;
  PartWalk parts_;
  PathDeviation deviation_;
  std::uint32_t element_ = 0;  ///< most recently gathered
  std::vector<RawSpan> raw_;
  std::vector<ProgressSpan> spans_;  ///< of the element
  std::size_t at_ = 0;
  double reached_ = 0;  ///< programmed path length at the start of the next span [mm]
};

}  // namespace feedscope
