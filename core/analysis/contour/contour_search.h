#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "core/analysis/contour/contour_course.h"
#include "core/analysis/path_deviation.h"

namespace feedscope {

/// The programmed path of a run; that of an empty one is empty.
const Toolpath& programmed_path(const Trajectory& trajectory);

/// A place of the executed path with its distance from the programmed one.
struct ContourNode {
  CoursePlace place;
  ContourCourse::Point point;
  PathDeviation::Foot foot;
  double error = 0;  ///< [mm]
};

/// Between two neighbouring nodes on one element.
struct ContourSpan {
  ContourNode from;
  ContourNode to;
  double bound = 0;  ///< no place between them is farther from the programmed path [mm]
};

/// Distances from the programmed path along an executed one, sampled, and the largest of a stretch exactly.
///
/// Between two nodes with feet on segments F and G the distance is at most that from F and at most that from
/// G; another segment may be nearer still. Each of these two leaves the straight line between its values at
/// both nodes upwards by no more than (du)^2/8 times how much its second derivative by u falls below 0: from
/// a line that is the part of the path's own towards the line, from an arc with centre c and |p - c| = r the
/// second derivative of r,
/// (|p'|^2 - r'^2 + (p - c) p'')/r. The lower of both straight lines and that make the bound of a span. It
/// comes down with the square of the length, so that halving where the bound is above the largest distance
/// found takes a number of steps that goes with the logarithm of the precision.
class ContourSearch {
 public:
  /// A largest distance found is too small by no more than this [mm], unless largest_in() says more.
  static constexpr double precision = 1e-6;

  explicit ContourSearch(const Trajectory& trajectory);
  /// `deviation`: from the programmed path of `trajectory`.
  ContourSearch(const Trajectory& trajectory, const PathDeviation& deviation);

  /// From now on errors up to `error` [mm] need not be exact but may be too large: places that are no farther
  /// are of no interest, which spares the look at other passes.
  void look_above(double error) { of_interest_ = error; }

  ContourCourse& course() { return course_; }
  const PathDeviation& deviation() const { return deviation_; }

  /// Calls `visit` for the spans of element after element in [first, last) that may leave the programmed
  /// path; throws Cancelled.
  void for_spans(std::uint32_t first, std::uint32_t last, Progress* progress,
                 const std::function<void(const ContourSpan&)>& visit);
  /// Adds the spans of a corner blend, which for_spans() leaves out where corners are plain.
  void corner_spans(std::uint32_t element, std::vector<ContourSpan>& spans);
  ContourNode node(const CoursePlace& at);
  /// Replaces `best` by the farthest place in `spans`, if one is farther; `spans` is left empty.
  /// Returns what no place in them is farther than [mm].
  double largest_in(std::vector<ContourSpan>& spans, ContourNode& best);

 private:
  /// What a span may be away from its chord [mm].
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
  double of_interest_ = 0;        ///< as look_above() [mm]
  std::size_t last_segment_ = 0;  ///< of the foot found last
  std::vector<double> ends_;
};

}  // namespace feedscope
