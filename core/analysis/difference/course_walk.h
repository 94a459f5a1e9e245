#pragma once

#include <cstdint>
#include <vector>

#include "core/analysis/path_deviation.h"
#include "core/trajectory/part_walk.h"

namespace feedscope {

/// Length of a programmed path before each of its segments, and of all [mm].
std::vector<double> lengths_before(const Toolpath& programmed);

/// A short time of a run, and how far along the program it comes meanwhile.
struct ProgressSpan {
  double time = 0;      ///< start [s]
  double duration = 0;  ///< [s]
  double begin = 0;     ///< programmed path length [mm]
  double end = 0;       ///< not before `begin`
  LawPoint law;         ///< programmed path length from `begin`, never falling [mm]
  std::uint32_t segment = 0;
  bool dwell = false;

  double end_time() const { return time + duration; }
  double offset_at(double tau) const;  ///< from `begin`, `tau` after the start [mm]
  double tau_at(double offset) const;  ///< first instant, the inverse [s]
  bool same_law(const ProgressSpan& other) const;
};

/// A run as progress along the *programmed* path, which is the same for every control: where two runs of one
/// program have come equally far, they are at the same place, whatever their corners cut off.
///
/// Lines and arcs that a control takes over count as they are. A corner curve stands for the programmed path
/// that it replaces, in proportion to its length: its middle is at the corner. On filtered motion, whose
/// blocks flow into each other, the place is the programmed point that is nearest on the way past it
/// (PathDeviation::foot_near).
class CourseWalk {
 public:
  /// At the first span. `trajectory` has pieces; it and `lengths`, of its programmed path, outlive this.
  CourseWalk(const Trajectory& trajectory, const std::vector<double>& lengths);

  const ProgressSpan& span() const { return spans_[at_]; }
  /// False, and nothing happens, at the last one.
  bool next();

 private:
  /// A span before its place on the program is known.
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
  std::uint32_t element_ = 0;  ///< gathered last
  std::vector<RawSpan> raw_;
  std::vector<ProgressSpan> spans_;  ///< of the element
  std::size_t at_ = 0;
  double reached_ = 0;  ///< programmed, where the next span begins [mm]
};

}  // namespace feedscope
