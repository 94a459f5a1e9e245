#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/toolpath/toolpath.h"

namespace feedscope {

/// Which of X, Y and Z a trace records.
using SeenAxes = std::array<bool, 3>;

/// Programmed path as short lines, arcs within 0.5 um, for matching recorded positions. Axes that are not
/// recorded have no extent.
class ProgrammedCourse {
 public:
  ProgrammedCourse(const Toolpath& toolpath, const SeenAxes& seen);

  std::size_t size() const { return points_.size(); }                  ///< points
  const Vec3& point(std::size_t i) const { return points_[i]; }        ///< [mm]
  double s(std::size_t i) const { return s_[i]; }                      ///< programmed path length [mm]
  double seen_length(std::size_t i) const { return seen_length_[i]; }  ///< of the recorded axes [mm]
  double length() const { return s_.empty() ? 0 : s_.back(); }         ///< [mm]
  const SeenAxes& seen() const { return seen_; }
  const Bounds& bounds() const { return bounds_; }
  /// Whether the program moves an axis, recorded or not.
  bool moves(std::size_t axis) const { return moves_[axis]; }
  /// `place` without the axes that are not recorded.
  Vec3 visible(const Vec3& place) const;
  /// Toolpath index of the segment at `s` [mm]; the earlier one at a border.
  std::uint32_t segment_at(double s) const;
  /// Program line at `s` [mm]; the earlier one at a border; 0 without segments.
  std::uint32_t line_at(double s) const { return lines_.empty() ? 0 : lines_[segment_at(s)]; }
  std::size_t segments() const { return lines_.size(); }  ///< including those without length, such as dwells
  std::uint32_t line_of(std::uint32_t segment) const { return lines_[segment]; }  ///< of the program
  double start_of(std::uint32_t segment) const { return starts_[segment]; }       ///< [mm]

 private:
  void add(const Vec3& place, double length);

  SeenAxes seen_;
  std::vector<Vec3> points_;
  std::vector<double> s_;
  std::vector<double> seen_length_;
  std::vector<double> starts_;        ///< of the segments, then the end [mm]
  std::vector<std::uint32_t> lines_;  ///< of the segments
  Bounds bounds_;
  SeenAxes moves_{};
};

}  // namespace feedscope
