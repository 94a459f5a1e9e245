#pragma once

#include <vector>

#include "core/trajectory/trajectory.h"

namespace feedscope {

/// A place of an executed path; ContourCourse defines `u` on `element`.
struct CoursePlace {
  std::uint32_t element = 0;
  double u = 0;
};

/// Executed path where it may leave the programmed one, as smooth spans with bounded curvature.
///
/// `u` is the time on filtered motion [s], the parameter of a cubic blend, else the path length from the
/// element's start [mm].
class ContourCourse {
 public:
  explicit ContourCourse(const Trajectory& trajectory);

  /// Whether corners are rounded between programmed lines: the deviation of a corner then depends on the
  /// corner only.
  bool has_plain_corners() const { return plain_corners_; }
  /// Ends of the spans of `element`, in order; none if it follows the programmed path exactly, and on plain
  /// corners. Cost for elements in order: of the order of their pieces and blocks.
  void nodes(std::uint32_t element, std::vector<double>& ends);
  /// Ends of the spans of one corner blend, plain or not.
  void corner_nodes(std::uint32_t element, std::vector<double>& ends) const;
  struct Point {
    Vec3 position = Vec3::Zero();  ///< [mm]
    Vec3 d1 = Vec3::Zero();        ///< derivatives by u
    Vec3 d2 = Vec3::Zero();
    bool steady = false;  ///< filtered motion of a single pulse
  };
  Point at(const CoursePlace& place);
  /// Largest excess of the second derivative between two places of an element over the larger of those at the
  /// places, as a vector's length or as its component in any direction.
  double bend_between(std::uint32_t element, double from, double to, double at_ends) const;
  /// The only programmed segment in the filters between the two places; none if there are several, and on
  /// other elements.
  std::optional<std::size_t> block_seen(std::uint32_t element, double from, double to) const;
  /// Whether the path between the two places is exactly one programmed line.
  bool is_on_one_line(std::uint32_t element, double from, double to) const;
  double path_length(const CoursePlace& at);  ///< executed, from the start [mm]
  double time(const CoursePlace& at);         ///< [s]

 private:
  void curve_nodes(std::uint32_t element, std::vector<double>& ends) const;
  void filtered_nodes(std::uint32_t element, std::vector<double>& ends);
  void divide_filtered(const FilteredMotion& motion, double from, double to, std::vector<double>& ends);
  void compacted_nodes(std::uint32_t element, std::vector<double>& ends) const;
  void executed_nodes(std::uint32_t element, std::vector<double>& ends) const;
  const ElementCurve& curve(std::uint32_t element);

  const Trajectory& trajectory_;
  bool plain_corners_;
  std::size_t piece_ = 0;  ///< first one after those processed by filtered_nodes()
  std::uint32_t curve_element_;
  ElementCurve curve_;
  FilterWalk filters_;
};

}  // namespace feedscope
