#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "core/analysis/contour/contour_course.h"
#include "core/analysis/contour/path_deviation.h"

namespace feedscope {

/// Programmed path of a run; empty for an empty run.
const Toolpath& programmed_path(const Trajectory& trajectory);

/// A place of the executed path with its distance from the programmed one.
struct ContourNode {
  CoursePlace place;
  ContourCourse::Point point;
  PathDeviation::Foot foot;
  double error = 0;  ///< [mm]
};

/// Stretch between two neighbouring nodes on one element.
struct ContourSpan {
  ContourNode from;
  ContourNode to;
  double bound = 0;  ///< upper bound of the distance from the programmed path between them [mm]
};

/// Samples distances of an executed path from the programmed one, and finds the largest in a stretch exactly.
///
/// Between two nodes with feet on segments F and G the distance is at most that from F and at most that from
/// G; another segment may be nearer. Each of the two exceeds the straight line between its values at both
/// nodes by at most (du)^2/8 times the amount by which its second derivative by u falls below 0. From a line
/// that derivative is the component of the path's own towards the line; from an arc with centre c and |p - c|
/// = r it is that of r, (|p'|^2 - r'^2 + (p - c) p'')/r. The lower of both straight lines plus this excess is
/// the bound of a span. It decreases with the square of the length, so the number of halvings grows with the
/// logarithm of the precision.
class ContourSearch {
 public:
  /// Largest error of a largest distance [mm], unless largest_in() reports more.
  static constexpr double precision = 1e-6;

  explicit ContourSearch(const Trajectory& trajectory);
  /// `deviation`: from the programmed path of `trajectory`.
  ContourSearch(const Trajectory& trajectory, const PathDeviation& deviation);

  /// From now on errors up to `error` [mm] may be overestimated: places up to that distance are not of
  /// interest, so the search for other passes is skipped.
  void look_above(double error) { of_interest_ = error; }

  ContourCourse& course() { return course_; }
  const PathDeviation& deviation() const { return deviation_; }

  /// Calls `visit` for the spans in elements [first, last) that may leave the programmed path, in order.
  /// Throws Cancelled.
  void for_spans(std::uint32_t first, std::uint32_t last, Progress* progress,
                 const std::function<void(const ContourSpan&)>& visit);
  /// Appends the spans of a corner blend, which for_spans() omits if corners are plain.
  void corner_spans(std::uint32_t element, std::vector<ContourSpan>& spans);
  ContourNode node(const CoursePlace& at);
  /// Replaces `best` by the farthest place in `spans`, if one is farther; empties `spans`. Returns an upper
  /// bound of the distance within them [mm].
  double largest_in(std::vector<ContourSpan>& spans, ContourNode& best);

 private:
  /// Largest distance of a span from its chord [mm].
  double sagitta(const ContourNode& from, const ContourNode& to) const;
  PathDeviation::Foot foot_of(const Vec3& position, std::size_t segment) const;
  bool is_steady(const ContourSpan& span) const;
  std::optional<double> largest_on_chord(const ContourSpan& span) const;
  double bound_of(const ContourSpan& span) const;
  double rise_above_chord(std::size_t segment, const PathDeviation::Foot& at_from,
                          const PathDeviation::Foot& at_to, const ContourSpan& span) const;
  double bend_from_line(std::size_t index, const PathDeviation::Foot& at_from,
                        const PathDeviation::Foot& at_to, const ContourSpan& span) const;
  double bend_across_line(std::size_t index, const PathDeviation::Foot& at_from,
                          const PathDeviation::Foot& at_to, const ContourSpan& span) const;
  double bend_from_arc(const Arc& arc, const ContourSpan& span) const;
  double bend_from_helix(const Arc& arc, const PathDeviation::Foot& at_from, const PathDeviation::Foot& at_to,
                         const ContourSpan& span) const;

  const Trajectory& trajectory_;
  ContourCourse course_;
  PathDeviation deviation_;
  double of_interest_ = 0;        ///< from look_above() [mm]
  std::size_t last_segment_ = 0;  ///< of the last foot
  std::vector<double> ends_;
};

}  // namespace feedscope
